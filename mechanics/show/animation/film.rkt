#lang racket/base
;; A film: the motion that an animation shows, its drawing and its schedule.

(provide (struct-out film) film-state)

;; motion : time -> state; drawing : state -> pict
;; trail : state -> points, or #f; trail-time : its duration on the picture, or #f for all of it
;; plane : phase-plane or #f; title : string
(struct film (motion drawing schedule trail trail-time plane title))

(define (film-state f t) ((film-motion f) t))
