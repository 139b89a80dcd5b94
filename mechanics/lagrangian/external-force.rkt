#lang racket/base
;; Forces outside the potential: given as they are, as a function Q of the local
;; tuple, or by a dissipation function F whose derivative −∂₂F they are.
;;
;; Rayleigh's is F = k v², a drag proportional to the velocity.  Power is then lost
;; at the rate ∂₂F v, which is 2F.

(require "local-tuple.rkt"
         "../calculus/derivative.rkt"
         (only-in "../calculus/literal-function.rkt" literal-function? literal-function-takes?)
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt"
         "../generic/function-check.rkt" "../generic/function.rkt"
         "../generic/printed-function.rkt" "../generic/up-down.rkt"
         "../generic/wrong-argument.rkt")

(provide Rayleigh-dissipation external-force force-like force->datum)

(define-printed (Rayleigh-dissipation k)
  (lambda (local)
    (g:* k (g:square (velocity local)))))

;; Q − ∂₂F, of which either may be #f; #f if both are.
(define (external-force who Q F)
  (unless (or (not Q) (procedure? Q))
    (complain-of-argument who "a force: a function of the local tuple" Q))
  (when (and Q (not (accepts? Q 1))) (raise-arity-of-force who Q))
  (unless (or (not F) (takes-arguments? F 1))
    (complain-of-argument who "a dissipation function: a function of the local tuple" F))
  (when (and (literal-function? F) (not (literal-function-takes? F (list (up 't 'q 'v)))))
    (raise-path-as-dissipation who F))
  (define slope (and F ((partial 2) (scalar-dissipation who F))))
  (cond [(and Q F) (g:- Q slope)]
        [F (g:negate slope)]
        [else Q]))

;; One pair of parentheses was left out, most likely.
(define (raise-path-as-dissipation who F)
  (complain who "a dissipation function takes the local tuple (up t q v); given ~a~a"
            (describe-function F)
            (if (eq? who 'Lagrange-equations)
                (format "\n  a path comes in parentheses of its own: ((Lagrange-equations L) ~a)"
                        (value->text F))
                "\n  one path of several coordinates is a tuple of paths: (up x y)")))

;; Newton's forces are functions of time, positions and velocities; these are not.
(define (raise-arity-of-force who Q)
  (complain who "a force is a function of the local tuple (up t q v); given ~a~a"
            (describe-function Q)
            (if (accepts? Q 3)
                "\n  of a force on particles, (F t r v), (generalized-force r F) makes one"
                "")))

;; The keyword and its argument in the datum of a call; none without a force.
(define (force->datum Q)
  (if Q (list '#:force (value->datum Q)) '()))

;; F, whose value is checked to be a number and no tuple, as that of a force is.
(define (scalar-dissipation who F)
  (define (hint value) (format "\n  a force is given as #:force ~a" (value->text F)))
  (unary-function (lambda () (value->datum F)) (local)
    (check-scalar-value who "a dissipation function" F (F local) hint)))

;; The force, checked to have the shape of the momenta; 0 is no force whatever the shape.
(define (force-like who momenta force)
  (cond [(or (eqv? force 0) (same-shape? momenta force)) force]
        [else
         (complain who "the force must be ~a, like the momenta; given ~a"
                   (if (tuple? momenta) (describe momenta) "a number")
                   (describe-with-value force))]))
