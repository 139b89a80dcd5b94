#lang racket/base
;; The motion of a perturbed system: new and old states, and the solution (SICM 7.2, p. 463).
;;
;; With C = C_{W₁} ∘ C_{W₂} ∘ ⋯ the old state is C(new); each component is a series in ε, found
;; by the exponentials that transform the Hamiltonian.  In the new state the actions rest and
;; the angles turn at the frequencies of the new Hamiltonian: forth, on, and back is the solution.

(require racket/list
         "Lie-triangle.rkt" "Poisson-series.rkt" "found-perturbation.rkt"
         "Lie-derivative.rkt"
         "../calculus/expression-function.rkt"
         "../error/complain.rkt" "../error/failure.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/describe.rkt"
         "../generic/elementary.rkt"
         "../generic/function.rkt" "../generic/up-down.rkt"
         "../hamiltonian/H-state.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/shape.rkt" "../value/simplify.rkt"
         "../verdict/prove-zero.rkt")

(provide perturbation-transformation perturbation-inverse perturbation-solution
         verify-perturbation)

;; new state ↦ old state, to the order of P
(define (perturbation-transformation P)
  (define who 'perturbation-transformation)
  (check-perturbation who P)
  (transformation who P (lambda (terms) (carried P terms (in-order P) 1))))

;; old state ↦ new state
(define (perturbation-inverse P)
  (define who 'perturbation-inverse)
  (check-perturbation who P)
  (transformation who P (lambda (terms) (carried P terms (reverse (in-order P)) -1))))

;; ((n . Wₙ) …)
(define (in-order P) (for/list ([W (in-list (perturbation-Ws P))] [n (in-naturals 1)]) (cons n W)))

(define (carried P terms numbered sign)
  (define actions (actions-of P))
  (for/fold ([terms terms]) ([entry (in-list numbered)])
    (exponentiate terms (car entry) (cdr entry)
                  (lambda (F W) (series-bracket F W actions)) series-sum series-scale
                  #:sign sign)))

;; carry : the terms of a component -> those of its image
(define (transformation who P carry)
  (define order (length (perturbation-Ws P)))
  (define n (length (angles-of P)))
  (define (component first) (carry (cons first (for/list ([_ (in-range order)]) (zero-series n)))))
  (define formulas
    (for/list ([terms (in-list
                       (append (for/list ([j (in-range n)]) (component (angle-series n j)))
                               (for/list ([I (in-list (actions-of P))])
                                 (component (constant-series n I)))))])
      (summed P terms)))
  (define names (scalars (perturbation-state P)))
  (unary-function (lambda () (list who 'P)) (state)
    (check-H-state who state)
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
                  (simplify-strictly (series->expression s (angles-of P)))))))

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

;; ---------------------------------------------------------------------------
;; The verdict

;; Order by order: is the Hamiltonian, transformed by the Lie derivatives of the generators as
;; functions, the new one?  A down tuple of the differences.
(define (verify-perturbation P)
  (check-perturbation 'verify-perturbation P)
  (define order (length (perturbation-Ws P)))
  (define given (perturbation-given P))
  (define (none state) 0)
  (define start
    (for/list ([k (in-range (add1 order))])
      (if (< k (length given)) (list-ref given k) none)))
  (define end
    (for/fold ([terms start]) ([W (in-list (perturbation-generators P))] [n (in-naturals 1)])
      (define L (Lie-derivative W))
      (exponentiate terms n W (lambda (F W) (L F)) g:+ g:*)))
  (define state (perturbation-state P))
  (prove-zero
   (apply down
          (for/list ([F (in-list end)] [s (in-list (perturbation-terms P))])
            (g:- (F state) (series->expression s (angles-of P)))))
   #:variables (scalars state)))
