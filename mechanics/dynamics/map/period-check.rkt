#lang racket/base
;; Is a time a period of a system?  A drive's frequency is easily given in its place: the states
;; after each such time make no map, for the drive is at another phase whenever one looks.
;;
;; The rates at the start and a period later are compared, of the state itself and of one beside
;; it: where a motion rests the drive may not be felt.  A state without the time in it has no drive,
;; and any time is a period of its rates.

(require "../../error/complain.rkt" "../../error/refusal.rkt"
         "../../generic/arithmetic.rkt" "../../generic/compare.rkt" "../../generic/describe.rkt"
         "../../generic/up-down.rkt" "../../generic/wrong-argument.rkt"
         "../../motion/system/check.rkt"
         "../../search/implicit-root.rkt"
         "../../value/shape.rkt")

(provide check-duration check-period timed-state? changed)

;; Is the first scalar of the state the time?
(define (timed-state? f state)
  (and (tuple? state) (eqv? (car (scalars (f state))) 1)))

;; Is it a number, and not 0?
(define (check-duration who period)
  (check-real who "period" period)
  (when (zero? (comparand period))
    (complain-of-argument who "a period that is not 0" period)))

(define (check-period who derivative state period)
  (define start (plain state))
  (when (and (tuple? start) (>= (structure-length (adopt start)) 3)
             (if-raised refusal? #f (timed-state? derivative start)))
    (for ([s (in-list (list start (beside start)))])
      (define-values (now later) (values (rates derivative s) (rates derivative (after s period))))
      (unless (or (not now) (not later) (same? now later))
        (raise-no-period who period derivative s (after s period))))))

;; -> a list of numbers, or #f where the derivative has no value or no number
(define (rates derivative state)
  (if-raised refusal? #f
    (define all (map comparand (scalars (derivative state))))
    (and (andmap rational? all) all)))

;; The state with (change x k) in place of its k-th scalar x.
(define (changed state change)
  (define all (list->vector (scalars state)))
  (scalars->structure state (lambda (k) (change (vector-ref all k) k))))

(define (after state period) (changed state (lambda (x k) (if (= k 0) (g:+ x period) x))))
(define (beside state) (changed state (lambda (x k) (if (= k 0) x (g:+ x (/ 0.1 k))))))

(define (same? xs ys)
  (for/and ([x (in-list xs)] [y (in-list ys)])
    (<= (abs (- x y)) (* 1e-6 (+ 1 (abs x) (abs y))))))

(define (raise-no-period who period derivative now later)
  (complain who
            (string-append "the rates of the system are others after that time, which is no period"
                           "\n  given: ~a\n  rates now: ~a\n  and then: ~a\n  "
                           "what goes as (cos (* omega t)) has the period (/ :2pi omega)")
            (value->text period) (value->text (derivative now)) (value->text (derivative later))))
