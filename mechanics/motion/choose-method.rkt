#lang racket/base
;; The choice of a method for a system.
;;
;; The Taylor method needs recurrences for all operations of the rates, and coefficients where the
;; motion begins.  If it is asked for by its name and cannot be used, the reader is told; `auto`
;; takes the method of Dormand and Prince then, and where that is faster.
;;
;; Which is faster shows at the start.  A step of Dormand and Prince takes twelve evaluations; its
;; error is about that of the term of order 8, so that its length is near 1.9 (ε/‖y_8‖)^(1/8), as
;; measured (between 1.2 and 3.4 for all motions of the benchmarks, whatever the tolerance).
;; Since both lengths follow the radius of convergence, their ratio stays much the same.

(require racket/flonum
         "method.rkt" "integration-plan.rkt"
         "system/system.rkt"
         "../error/complain.rkt"
         (only-in "../numeric/constants.rkt" rounding)
         "../numeric/ode/fallback-method.rkt" "../numeric/ode/dormand-prince-853.rkt"
         "../numeric/ode/integrate.rkt"
         "../numeric/ode/taylor.rkt")

(provide suited)

;; p, y : the plan of an integration of s from the state y, an flvector -> p with its method
(define (suited p s y)
  (define m (plan-method p))
  (cond [(eq? m automatic)
         (define o (and (not (long? s)) (outlook-of p s y)))
         (define Taylor? (and (outlook? o) (not (slower? o p s))))
         (struct-copy plan p [method (if Taylor? bridged-taylor dormand-prince-853)])]
        [(eq? m taylor)
         (define o (outlook-of p s y))
         (when (string? o) (raise-not-suited (plan-who p) o))
         p]
        [else p]))

;; Has s so many operations that the Taylor method is not tried?
(define (long? s) (> (or (system-operations s) 0) most-operations))
(define most-operations 200)

(define bridged-taylor (bridged-method taylor dormand-prince-853))

;; -> the outlook of the Taylor method at y, or a string, the reason why it cannot integrate s
(define (outlook-of p s y)
  (cond [(string? (system-expand s)) (system-expand s)]
        [else
         (define o (outlook-from (system-right-hand-side s taylor) y
                                 (step-tolerance (plan-tolerance p))))
         (if (fl> (outlook-step o) 0.0) o "its coefficients are not finite at the start")]))

;; Does the Taylor method take longer, by more than the model's uncertainty?  Not asked where the
;; tolerance leaves only rounding, of which the Taylor method loses less.  The work of both is
;; nanoseconds of machine code, as measured.
(define (slower? o p s)
  (define tolerance (step-tolerance (plan-tolerance p)))
  (define step (outlook-step o))
  (define other
    (flmin (fl* 1.9 (flexpt (fl/ tolerance (outlook-eighth o)) 0.125)) (fl* 2.0 step)))
  (define other-work
    (+ 80.0 (* 12.0 (system-size s))
       (* 6.0 (or (system-operations s) 0)) (* 60.0 (outlook-functions o))))
  (and (fl> tolerance rounding)
       (> (* other (outlook-work o)) (* 1.25 step other-work))))

(define (raise-not-suited who reason)
  (complain who
            (string-append "the Taylor method cannot follow this motion\n  reason: ~a"
                           "\n  use 'auto, which takes another method then")
            reason))
