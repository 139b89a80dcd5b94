#lang racket/base
;; Lists of recurrences without their numbers.
;;
;; The members of an ensemble differ in parameters, which are coefficients of their recurrences.
;; Machine code takes these from the tape, so that one code does for all members.  Numbers that code
;; is made by, as 1 or an exponent, stay.

(require "recurrence-list.rkt")

(provide without-numbers)

;; -> the same list with slots in place of numbers, and the list of these numbers.  A pair (last
;; order . recurrence) may stand for a recurrence.
(define (without-numbers xs)
  (define numbers '())
  (define count 0)
  (define (slot-of x)
    (begin0 (slot count)
            (set! numbers (cons x numbers))
            (set! count (+ 1 count))))
  (define (part x)
    (cond [(flonum? x) (if (memv x '(1.0 -1.0)) x (slot-of x))]
          [(weighed? x) (weighed (part (weighed-weight x)) (weighed-row x))]
          [(pair? x) (cons (part (car x)) (part (cdr x)))]
          [(and (recurrence? x) (not (memq (recurrence-kind x) '(power power-value))))
           (recurrence (recurrence-kind x) (part (recurrence-operands x)))]
          [else x]))
  (define abstract (part xs))
  (values abstract (reverse numbers)))
