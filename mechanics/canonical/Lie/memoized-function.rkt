#lang racket/base
;; A function of the state that is worked out once, at a state of symbols, and read off the
;; simplified expression from then on.
;;
;; Brackets of brackets run the functions below them anew, twice as often at each level.  Settled
;; ones do not.  A function that makes nothing of symbols is called as it is.

(require "../../algebra/expression/expression.rkt"
         "../../error/refusal.rkt"
         "../../generic/describe.rkt" "../../generic/function.rkt" "../../generic/on-demand.rkt"
         "../../generic/up-down.rkt"
         "../../hamiltonian/H-state.rkt"
         "../../value/assumptions.rkt" "../../value/shape.rkt" "../../value/simplify.rkt"
         "../../value/symbols-like.rkt")

(require-on-demand ["../../calculus/expression-function.rkt" evaluate-generically])

(provide settled)

;; place : a state of symbols; value : what the function is there, or #f where it is no formula;
;; declared : the assumptions it was simplified under
(struct worked-out (place value declared) #:authentic)

(define (settled who F)
  (define known #f)
  (define (at state)
    (unless (and known
                 (same-shape? state (worked-out-place known))
                 (equal? (assumptions 'declared) (worked-out-declared known)))
      (set! known (work-out F state)))
    known)
  (unary-function (lambda () (value->datum F)) (state)
    (check-H-state who state)
    (define w (at state))
    (define value (worked-out-value w))
    (if value
        (evaluate-generically value
                              (map cons (scalars (worked-out-place w)) (scalars state)))
        (F state))))

(define (work-out F state)
  (define place (symbols-like state "z"))
  (define value
    (with-handlers ([raised? (lambda (e) #f)])
      (define value (F place))
      (and (or (number? value) (expression? value)) (simplify-strictly value))))
  (worked-out place value (assumptions 'declared)))
