#lang racket/base
;; The texts that a pict draws, from left to right as they are drawn: what is the same with
;; whatever fonts a machine has.

(require (only-in pict dc-for-text-size draw-pict pict-height pict-width)
         racket/class
         (only-in racket/draw record-dc%)
         (only-in racket/string string-join))

(provide drawn-texts)

(define (drawn-texts p)
  (define dc (new record-dc% [width (max 1 (pict-width p))] [height (max 1 (pict-height p))]))
  (draw-pict p dc 0 0)
  (string-join (texts (send dc get-recorded-datum)) " "))

(define (texts d)
  (cond [(and (pair? d) (eq? (car d) 'draw-text)) (filter string? d)]
        [(pair? d) (append (texts (car d)) (texts (cdr d)))]
        [else '()]))
