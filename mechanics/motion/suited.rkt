#lang racket/base
;; Which method a system is integrated by.
;;
;; The Taylor method needs recurrences for all that its rates are made of, and coefficients
;; where the motion begins.  Where it is asked for by its name and cannot be, that is said;
;; `auto` takes the method of Dormand and Prince then, and for systems of so many operations
;; that their recurrences take longer.

(require "method.rkt" "plan.rkt" "system.rkt"
         "../error/complain.rkt"
         "../numeric/ode/bridged.rkt" "../numeric/ode/dormand-prince-853.rkt"
         "../numeric/ode/integrate.rkt"
         "../numeric/ode/taylor.rkt")

(provide suited)

;; p, y : the plan of an integration of s from the state y, an flvector -> p with its method
(define (suited p s y)
  (define m (plan-method p))
  (cond [(eq? m automatic)
         (plan-by p (if (or (long? s) (reason-against p s y)) dormand-prince-853 bridged-taylor))]
        [(eq? m taylor)
         (define reason (reason-against p s y))
         (when reason (raise-not-suited (plan-who p) reason))
         p]
        [else p]))

;; Recurrences of that many operations cost more than the longer steps save.
(define (long? s) (> (or (system-operations s) 0) most-operations))
(define most-operations 200)

(define bridged-taylor (bridged-method taylor dormand-prince-853))

(define (plan-by p m) (struct-copy plan p [method m]))

;; A string, or #f if the Taylor method can integrate s from y on.
(define (reason-against p s y)
  (define expand (system-expand s))
  (cond [(string? expand) expand]
        [(expands-from? (system-right-hand-side s taylor) y (step-tolerance (plan-tolerance p))) #f]
        [else "its coefficients are not finite at the start"]))

(define (raise-not-suited who reason)
  (complain who
            (string-append "the Taylor method cannot follow this motion\n  reason: ~a"
                           "\n  use 'auto, which takes another method then")
            reason))
