#lang racket/base
;; Branches that a function takes on values being differentiated.
;;
;; (if (< x a) …), |x − a| and floor choose by a number; its derivative says how the place
;; moves where the choice changes.  Who integrates over x wants to know
;; (calculus/moving-places.rkt): while `current-branches` is a procedure, it is called with
;; each value chosen by, the choice made (its sign, or the whole number it was rounded to),
;; and a procedure that gives, from two choices, the value between them.

(require "../kind.rkt")

(provide current-branches note-sign! note-rounding!)

(define current-branches (make-parameter #f))

;; (difference) : a value, of which the sign is asked
(define (note-sign! difference)
  (define note (current-branches))
  (when note
    (define x (difference))
    (define c (comparand x))
    (when (and (real? c) (carrier? x))
      (note x (cond [(> c 0) 1] [(< c 0) -1] [else 0]) (lambda (one other) 0)))))

;; boundary : of two whole numbers next to each other
(define (note-rounding! x rounded boundary)
  (define note (current-branches))
  (when note (note x rounded boundary)))
