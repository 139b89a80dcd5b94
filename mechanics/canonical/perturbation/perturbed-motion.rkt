#lang racket/base
;; The motion of a perturbed system: new and old states, and the solution (SICM 7.2, p. 463).
;;
;; With C = C_{W₁} ∘ C_{W₂} ∘ ⋯ the old state is C(new); each component is a series in ε, found
;; by the exponentials that transform the Hamiltonian.  In the new state the actions rest and
;; the angles turn at the frequencies of the new Hamiltonian: forth, on, and back is the solution.

(require "../Lie/Lie-triangle.rkt" "perturbation-results.rkt" "Poisson-series.rkt"
         "../../calculus/expression-function.rkt"
         "../../error/complain.rkt" "../../error/failure.rkt"
         "../../generic/arithmetic.rkt" "../../generic/compare.rkt" "../../generic/describe.rkt"
         "../../generic/elementary.rkt"
         "../../generic/function.rkt"
         "../../generic/sums-and-products.rkt" "../../generic/up-down.rkt"
         "../../hamiltonian/H-state.rkt"
         "../../lagrangian/local-tuple.rkt"
         "../../value/shape.rkt")

(provide perturbation-transformation perturbation-inverse perturbation-solution
         ;; for verdicts
         images)

;; new state ↦ old state, to the order of P
(define (perturbation-transformation P) (transformation 'perturbation-transformation P 1))

;; old state ↦ new state
(define (perturbation-inverse P) (transformation 'perturbation-inverse P -1))

;; For each angle and each action the terms of its image, from order 0 on
;; sign : 1 from new states to old ones, −1 back
(define (images P sign)
  (define n (length (angles-of P)))
  (define actions (actions-of P))
  (define nothing (map (lambda (W) (zero-series n)) (perturbation-Ws P)))
  (define (image start)
    (carry (cons start nothing) (perturbation-Ws P) (lambda (F W) (series-bracket F W actions))
           series-sum series-scale #:sign sign))
  (append (for/list ([j (in-range n)]) (image (angle-series n j)))
          (for/list ([I (in-list actions)]) (image (constant-series n I)))))

(define (transformation who P sign)
  (check-perturbation who P)
  (define place (perturbation-state P))
  (define formula
    (list->structure place
                     (cons (time place)
                           (for/list ([terms (in-list (images P sign))]) (summed P terms)))))
  (unary-function (lambda () (list who 'P)) (state)
    (check-state-like who place state)
    (check-divisors who P state)
    (evaluate-at formula place state)))

(define (summed P terms)
  (g:for/sum ([s (in-list terms)] [k (in-naturals)])
    (g:* (g:expt (perturbation-parameter P) k)
         (series->formula P s))))

;; ---------------------------------------------------------------------------
;; Resonances among the divisors

(define (check-divisors who P state)
  (for ([d (in-list (perturbation-divisors P))])
    (define value (comparand (evaluate-at (caddr d) (perturbation-state P) state)))
    (when (or (eqv? value 0) (and (flonum? value) (= value 0.0)))
      (raise-resonance who d state))))

(define (raise-resonance who d state)
  (raise-singular who
                  (format (string-append "the state is on the resonance ~a, which was divided by "
                                         "in order ~a: ~a = 0\n  #:keep '(~a) keeps its waves")
                          (cadr d) (car d) (value->text (caddr d)) (cadr d))
                  state
                  "state" state))

;; ---------------------------------------------------------------------------
;; The solution

;; (((perturbation-solution P) state) t) : the state at t of the motion through a state
(define (perturbation-solution P)
  (define who 'perturbation-solution)
  (check-perturbation who P)
  (define kept (perturbation-resonances P))
  (unless (null? kept)
    (complain who
              (string-append "the new Hamiltonian has the waves ~a left, kept for resonances; "
                             "its motion is no rotation\n  integrate that of "
                             "(perturbation-Hamiltonian P)")
              (map cadr kept)))
  (define-values (C C-inv) (values (perturbation-transformation P) (perturbation-inverse P)))
  (define place (perturbation-state P))
  (define frequencies
    (let ([H (summed P (perturbation-terms P))])
      (list->structure (coordinate place)
                       (for/list ([I (in-list (actions-of P))]) (expression-derivative H I)))))
  (unary-function (lambda () (list who 'P)) (state)
    (define new (C-inv state))
    (define rates (evaluate-at frequencies place new))
    (unary-function (lambda () (list (list who 'P) (value->datum state))) (t)
      (C (up t
             (g:+ (coordinate new) (g:* rates (g:- t (time state))))
             (momentum new))))))
