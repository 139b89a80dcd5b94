#lang racket/base
;; The motion of a perturbed system: new and old states, and the solution (SICM 7.2, p. 463).
;;
;; With C = C_{W₁} ∘ C_{W₂} ∘ ⋯ the old state is C(new); each component is a series in ε, found
;; by the exponentials that transform the Hamiltonian.  In the new state the actions rest and
;; the angles turn at the frequencies of the new Hamiltonian: forth, on, and back is the solution.

(require racket/list
         "../Lie/Lie-triangle.rkt" "Poisson-series.rkt" "found-perturbation.rkt"
         "../../calculus/expression-function.rkt"
         "../../error/complain.rkt" "../../error/failure.rkt"
         "../../generic/arithmetic.rkt" "../../generic/compare.rkt" "../../generic/describe.rkt"
         "../../generic/elementary.rkt"
         "../../generic/function.rkt" "../../generic/up-down.rkt"
         "../../hamiltonian/H-state.rkt"
         "../../lagrangian/local-tuple.rkt"
         "../../value/shape.rkt")

(provide perturbation-transformation perturbation-inverse perturbation-solution
         ;; for verdicts
         images numbered)

;; new state ↦ old state, to the order of P
(define (perturbation-transformation P)
  (define who 'perturbation-transformation)
  (check-perturbation who P)
  (transformation who P 1))

;; old state ↦ new state
(define (perturbation-inverse P)
  (define who 'perturbation-inverse)
  (check-perturbation who P)
  (transformation who P -1))

;; For each angle and each action the terms of its image, from order 0 on
;; sign : 1 from new states to old ones, −1 back
(define (images P sign)
  (define n (length (angles-of P)))
  (define nothing (for/list ([_ (in-list (perturbation-Ws P))]) (zero-series n)))
  (define (image first) (carried P (cons first nothing) sign))
  (append (for/list ([j (in-range n)]) (image (angle-series n j)))
          (for/list ([I (in-list (actions-of P))]) (image (constant-series n I)))))

(define (carried P terms sign)
  (define actions (actions-of P))
  (for/fold ([terms terms]) ([entry (in-list (numbered (perturbation-Ws P) sign))])
    (exponentiate terms (car entry) (cdr entry)
                  (lambda (F W) (series-bracket F W actions)) series-sum series-scale
                  #:sign sign)))

;; ((n . Wₙ) …), backwards for the inverse
(define (numbered Ws sign)
  (define all (for/list ([W (in-list Ws)] [n (in-naturals 1)]) (cons n W)))
  (if (= sign 1) all (reverse all)))

(define (transformation who P sign)
  (define formulas (for/list ([terms (in-list (images P sign))]) (summed P terms)))
  (define n (length (angles-of P)))
  (define names (scalars (perturbation-state P)))
  (unary-function (lambda () (list who 'P)) (state)
    (check-state-like who (perturbation-state P) state)
    (check-divisors who P state)
    (define point (map cons names (scalars state)))
    (define-values (q p)
      (split-at (for/list ([e (in-list formulas)]) (evaluate-generically e point)) n))
    (up (time state)
        (filled (coordinate state) q)
        (filled (momentum state) p))))

(define (summed P terms)
  (for/fold ([sum 0]) ([s (in-list terms)] [k (in-naturals)])
    (g:+ sum (g:* (g:expt (perturbation-parameter P) k)
                  (series->formula P s)))))

(define (filled shape xs) (scalars->structure shape (lambda (k) (list-ref xs k))))

;; ---------------------------------------------------------------------------
;; Resonances divided by

(define (check-divisors who P state)
  (define point (map cons (scalars (perturbation-state P)) (scalars state)))
  (for ([d (in-list (perturbation-divisors P))])
    (define value (comparand (evaluate-generically (caddr d) point)))
    (when (eqv? value 0) (raise-resonance who d state))
    (when (and (flonum? value) (= value 0.0)) (raise-resonance who d state))))

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
  (define frequencies
    (let ([H (summed P (perturbation-terms P))])
      (for/list ([I (in-list (actions-of P))]) (expression-derivative H I))))
  (define names (scalars (perturbation-state P)))
  (unary-function (lambda () (list who 'P)) (state)
    (define new (C-inv state))
    (define point (map cons names (scalars new)))
    (define rates (filled (coordinate new)
                          (for/list ([w (in-list frequencies)]) (evaluate-generically w point))))
    (unary-function (lambda () (list (list who 'P) (value->datum state))) (t)
      (C (up t
             (g:+ (coordinate new) (g:* rates (g:- t (time state))))
             (momentum new))))))
