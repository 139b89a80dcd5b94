#lang racket/base
;; The claims of a perturbation, tested order by order.
;;
;; Results of the algebra of waves are tested by Lie derivatives and brackets of functions,
;; which know nothing of waves:
;;
;;     transformed      the term of H' is that of H, carried along by the generators
;;     without-angles   it does not depend on the angles
;;     canonical        the brackets of the old coordinates and momenta, as series in ε, have no
;;                      term of this order
;;     inverse          nor has the image of a new state under C and then its inverse, which is that
;;                      of the formulas

(require racket/list
         "perturbation-results.rkt" "perturbed-motion.rkt"
         "../Lie/Lie-derivative.rkt" "../Lie/Lie-triangle.rkt"
         "../../calculus/derivative.rkt"
         "../../error/computed-once.rkt"
         "../../generic/arithmetic.rkt"
         "../../generic/sums-and-products.rkt" "../../generic/up-down.rkt"
         "../../hamiltonian/H-state.rkt" "../../hamiltonian/Poisson-bracket.rkt"
         "../../lagrangian/local-tuple.rkt"
         "../../value/shape.rkt"
         "../../verdict/prove-zero.rkt" "../../verdict/verdict.rkt")

(provide verify-perturbation perturbation-verdicts)

;; The verdict on the first claim in all orders: a down tuple of the differences
(define (verify-perturbation P)
  (check-perturbation 'verify-perturbation P)
  (car (judged P (lambda (P) (list (apply down (differences P)))))))

;; ((claim order verdict) …)
(define (perturbation-verdicts P)
  (check-perturbation 'perturbation-verdicts P)
  (define (listed claim first values)
    (for/list ([v (in-list (judged P values))] [n (in-naturals first)]) (list claim n v)))
  (append (listed 'transformed 0 differences)
          (listed 'without-angles 0 slopes-by-angles)
          (listed 'canonical 1 brackets)
          (listed 'inverse 1 round-trips)))

;; values : perturbation -> list of values that are to be 0;  -> their verdicts
;; A claim that holds for all numbers in the place of decimals is proved for them; of one that does
;; not, or rests on their values, the verdict is that on the decimals themselves.
(define (judged P values)
  (define decimals (perturbation-decimals P))
  (define as-given (once (lambda () (values P))))
  (cond [(null? decimals) (for/list ([x (in-list (as-given))]) (zero-at P x))]
        [else
         (for/list ([x (in-list (values (for-all-decimals P)))] [n (in-naturals)])
           (define v (zero-at P x))
           (if (settled? v (map car decimals)) v (zero-at P (list-ref (as-given) n))))]))

;; A value that is too large with names is too large with decimals, too, after a longer time.
(define (settled? v names)
  (or (and (proved? v)
           (not (ormap (lambda (name) (memq name names)) (flatten (verdict-assumptions v)))))
      (eq? (verdict-reason v) 'too-large)))

(define (zero-at P value)
  (prove-zero value #:variables (scalars (perturbation-state P))))

(define (functions P terms) (for/list ([s (in-list terms)]) (term-function P s)))

;; The terms of exp(± …) F of functions, by their Lie derivatives
(define (carried-functions P terms sign)
  (carry terms (map Lie-derivative (perturbation-generators P)) (lambda (F L) (L F)) g:+ g:*
         #:sign sign))

;; ---------------------------------------------------------------------------
;; The claims, each a list of values that are to be 0

(define (differences P)
  (define state (perturbation-state P))
  (define given (perturbation-given P))
  (define start
    (for/list ([k (in-range (length (perturbation-terms P)))])
      (if (< k (length given)) (list-ref given k) nothing)))
  (for/list ([F (in-list (carried-functions P start 1))]
             [K (in-list (functions P (perturbation-terms P)))])
    (g:- (F state) (K state))))

(define (nothing state) 0)

(define (slopes-by-angles P)
  (for/list ([K (in-list (functions P (perturbation-terms P)))])
    (((partial 1) K) (perturbation-state P))))

;; Order m of {a, b} is the sum of {aᵢ, bⱼ} with i + j = m.
(define (brackets P)
  (define components (for/list ([terms (in-list (images P 1))]) (functions P terms)))
  (for/list ([m (in-range 1 (length (perturbation-terms P)))])
    (apply up (for/list ([pair (in-combinations components 2)])
                (define-values (a b) (values (car pair) (cadr pair)))
                (g:for/sum ([i (in-range (add1 m))])
                  ((Poisson-bracket (list-ref a i) (list-ref b (- m i)))
                   (perturbation-state P)))))))

;; C, followed by its inverse as a Lie transform, and the amounts by which the formulas of
;; perturbation-inverse miss that
(define (round-trips P)
  (define (back terms) (carried-functions P terms -1))
  (define (by-formulas sign) (for/list ([terms (in-list (images P sign))]) (functions P terms)))
  (define nothings (map (lambda (W) nothing) (perturbation-Ws P)))
  (define ends (map back (by-formulas 1)))
  (define inverse (for/list ([f (in-list (parts-of-state P))]) (back (cons f nothings))))
  (define state (perturbation-state P))
  (define (at m) (lambda (terms) ((list-ref terms m) state)))
  (for/list ([m (in-range 1 (length (perturbation-terms P)))])
    (apply up (append (map (at m) ends)
                      (map g:- (map (at m) inverse) (map (at m) (by-formulas -1)))))))

;; Each angle and each action as a function of the state
(define (parts-of-state P)
  (define (parts part)
    (for/list ([k (in-range (length (angles-of P)))])
      (lambda (state) (list-ref (scalars (part state)) k))))
  (append (parts coordinate) (parts momentum)))
