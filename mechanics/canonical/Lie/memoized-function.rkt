#lang racket/base
;; A function of the state that is called once, at a state of symbols, and evaluated by the
;; simplified expression from then on.
;;
;; Brackets of brackets run the functions below them anew, twice as often at each level; memoized
;; functions do not.  A function that fails at symbols is called at each state.

(require "../../algebra/expression/expression.rkt"
         "../../error/refusal.rkt"
         "../../generic/describe.rkt" "../../generic/function.rkt" "../../generic/on-demand.rkt"
         "../../hamiltonian/H-state.rkt"
         "../../value/shape.rkt" "../../value/simplify.rkt")

(require-on-demand ["../../calculus/expression-function.rkt" evaluate-at])

(provide memoized-function)

;; place : a state of symbols; value : that of the function there, or #f where it is no expression
(struct worked-out (place value) #:authentic)

(define (memoized-function who F)
  (define work-out-once
    (by-shape (lambda (state) (work-out F state)) #:lasting? (lambda (w) #f)))
  (unary-function (lambda () (value->datum F)) (state)
    (check-H-state who state)
    (define w (work-out-once state))
    (define value (worked-out-value w))
    (if value (evaluate-at value (worked-out-place w) state) (F state))))

(define (work-out F state)
  (define place (symbols-like state "z"))
  (define value
    (if-raised raised? #f
      (define value (F place))
      (and (expression? value) (simplify-strictly value))))
  (worked-out place value))
