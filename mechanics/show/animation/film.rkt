#lang racket/base
;; What is shown in an animation, and when.

(provide (struct-out film) film-state)

;; motion : time -> state; drawing : state -> pict
;; trail : state -> points, or #f; trail-time : how much of it is seen, or #f for all
;; plane : phase-plane or #f; title : string
(struct film (motion drawing schedule trail trail-time plane title))

(define (film-state f t) ((film-motion f) t))
