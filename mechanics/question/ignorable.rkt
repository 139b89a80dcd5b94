#lang racket/base
;; Ignorable coordinates, also called cyclic: those that L does not depend on.  The
;; momenta ∂₂L that belong to them are conserved (SICM 1.8, p. 79).

(require racket/list
         "what-is-asked.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt"
         "../generic/describe.rkt"
         "../lagrangian/generic-state.rkt" "../lagrangian/Lagrange-equations.rkt"
         "../lagrangian/local-tuple.rkt" "../lagrangian/total-derivative.rkt"
         "../value/shape.rkt" "../value/simplify.rkt" "../value/structure.rkt"
         "../verdict/prove-zero.rkt" "../verdict/smoothness.rkt" "../verdict/verdict.rkt")

(provide verify-ignorable ignorable-coordinates conserved-momenta)

;; A verdict on the component of ∂₁L at a local tuple of symbols.
;; which : the coordinate's symbol, or its index, or a list of indices
(define (verify-ignorable L which local)
  (check-question 'verify-ignorable L local)
  (define chain (index-chain which (coordinate local)))
  (independence 'verify-ignorable L chain local))

;; A verdict on the derivative of L by that coordinate alone.
(define (independence who L chain local)
  (define by-coordinate (apply partial 1 chain))
  (define-values (slope survey)
    (survey-derivatives
     (lambda () ((by-coordinate (scalar-valued who L)) ((clip-state 3) local)))
     (scalars local)))
  (prove-zero slope #:variables (scalars local) #:surveys (list survey)
              #:meaning (lambda () (meaning-of-Lagrangian L ((clip-state 3) local)))
              #:again (lambda (change) (independence who (change L) chain local))))

;; The symbols of all coordinates for which that is proved.
(define (ignorable-coordinates L local)
  (check-question 'ignorable-coordinates L local)
  (map leaf-symbol (ignorable 'ignorable-coordinates L local)))

;; A list of (up coordinate momentum), one for each.
(define (conserved-momenta L local)
  (check-question 'conserved-momenta L local)
  (define found (ignorable 'conserved-momenta L local))
  (define momenta
    (((partial 2) (scalar-valued 'conserved-momenta L)) ((clip-state 3) local)))
  (for/list ([entry (in-list found)])
    (up (leaf-symbol entry) (simplify (component-at momenta (leaf-chain entry))))))

(define (check-question who L local)
  (check-Lagrangian who L)
  (check-generic-states who local L))

;; Those of the coordinates that are.
(define (ignorable who L local)
  (for/list ([entry (in-list (leaves (coordinate local)))]
             #:when (proved? (independence who L (leaf-chain entry) local)))
    entry))

;; ---------------------------------------------------------------------------
;; Coordinates by name and by place

(define (component-at x chain) (if (null? chain) x (apply ref x chain)))

;; chain : the indices that lead to a coordinate
(struct leaf (symbol chain) #:authentic)

(define (leaves q)
  (let walk ([x q] [path '()])
    (if (tuple? x)
        (append* (for/list ([e (in-list (structure->list x))] [i (in-naturals)])
                   (walk e (cons i path))))
        (list (leaf x (reverse path))))))

(define (index-chain which q)
  (define known (leaves q))
  (define chain (if (exact-nonnegative-integer? which) (list which) which))
  (cond [(findf (lambda (entry) (eq? (leaf-symbol entry) which)) known) => leaf-chain]
        [(member chain (map leaf-chain known)) chain]
        [else
         (complain 'verify-ignorable
                   (string-append "expected a coordinate: its symbol, its index, "
                                  "or a list of indices"
                                  "\n  given: ~a"
                                  "\n  coordinates: ~a")
                   (value->text which) (value->text q))]))
