#lang racket/base
;; Points where a function has a value but no derivative.
;;
;; Kinks, jumps and infinite slopes are mathematical failures, whether the point
;; is exact or not: a flonum infinity would become a NaN at the next step, far
;; from where it could be understood.

(require "describe.rkt"
         "../error/failure.rkt")

(provide raise-no-derivative-at)

;; why : a clause that says what happens there, such as "where it jumps", or #f.
(define (raise-no-derivative-at name arguments [why #f])
  (raise
   (exn:fail:mechanics:singular
    (format "~a: has no derivative ~aat ~a"
            name (if why (string-append why ", ") "") (arguments->text arguments))
    (current-continuation-marks)
    (if (null? (cdr arguments)) (car arguments) arguments))))

(define (arguments->text arguments)
  (for/fold ([text (value->text (car arguments))]) ([a (in-list (cdr arguments))])
    (string-append text ", " (value->text a))))
