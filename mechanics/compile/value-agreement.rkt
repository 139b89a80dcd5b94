#lang racket/base
;; Is a program right at a point, as far as one can tell?
;;
;; Where the function has no value, nothing is known.  Where it fails in another way the
;; program must not go on with numbers, or the user would never hear of it; if what the
;; program makes is no number, the generic arithmetic may have complained of a complex one.

(require "../error/failure.rkt" "../error/refusal.rkt")

(provide agrees?)

;; (value), (made) : what the function and the program make of the point
;; (same? value made), (numbers? made) -> boolean
(define (agrees? value made #:same? same? #:numbers? numbers?)
  (define v
    (with-handlers ([no-value? (lambda (e) 'none)]
                    [raised? (lambda (x) 'failure)])
      (value)))
  (case v
    [(none) #t]
    [(failure) (not (numbers? (made)))]
    [else (same? v (made))]))
