#lang racket/base
;; Forces outside the potential: given as they are, as a function Q of the local
;; tuple, or by a dissipation function F whose derivative −∂₂F they are.
;;
;; Rayleigh's is F = k v², a drag proportional to the velocity.  Power is then lost
;; at the rate ∂₂F v, which is 2F.

(require "local-tuple.rkt"
         "../algebra/expression/symbols.rkt"
         "../calculus/derivative.rkt"
         (only-in "../calculus/literal-function.rkt" literal-function? literal-function-takes?)
         "../error/complain.rkt" "../error/note.rkt" "../error/refusal.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/describe.rkt"
         "../generic/function-check.rkt" "../generic/function.rkt"
         "../generic/printed-function.rkt" "../generic/up-down.rkt"
         "../generic/wrong-argument.rkt"
         "../value/shape.rkt")

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
  (define slope (and F (noting-linear who F ((partial 2) (scalar-dissipation who F)))))
  (cond [(and Q F) (g:- Q slope)]
        [F (g:negate slope)]
        [else Q]))

;; A function that is linear in the velocities makes a force that does not depend on them: most
;; likely it is that of the force itself.  Each function is looked at once.
(define looked-at (make-weak-hasheq))

(define (noting-linear who F slope)
  (unary-function (lambda () (value->datum slope)) (local)
    (unless (hash-ref looked-at F #f)
      (hash-set! looked-at F #t)
      (when (if-raised refusal? #f (linear? slope (symbols-like local "x")))
        (note-once (format (string-append "~a: the dissipation function is linear in the "
                                          "velocities, so that its force does not depend on them"
                                          "\n  a force is given as #:force ~a")
                           who (value->text F)))))
    (slope local)))

(define (linear? slope state)
  (define force (scalars (slope state)))
  (and (not (andmap g:zero? force))
       (not (for*/or ([e (in-list force)] [v (in-list (scalars (velocity state)))])
              (occurs? v e)))))

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
