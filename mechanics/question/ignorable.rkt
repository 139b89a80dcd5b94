#lang racket/base
;; Ignorable coordinates, also called cyclic: those that L does not depend on.  The
;; momenta ∂₂L that belong to them are conserved (SICM 1.8, p. 79).  A Hamiltonian p v − L has
;; the same ones (3.4), at states with those momenta.

(require racket/list
         "argument-order.rkt" "question-meaning.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt"
         "../generic/describe.rkt"
         "../hamiltonian/H-state.rkt" "../hamiltonian/Hamiltonian.rkt"
         "../hamiltonian/classify-system.rkt"
         "../lagrangian/generic-state.rkt" "../lagrangian/Lagrange-equations.rkt"
         "../lagrangian/local-tuple.rkt" "../lagrangian/total-derivative.rkt"
         "../value/shape.rkt" "../value/simplify.rkt" "../value/structure.rkt"
         "../verdict/question-domain.rkt" "../verdict/surveyed-zero.rkt"
         "../verdict/verdict.rkt")

(provide verify-ignorable ignorable-coordinates conserved-momenta)

;; A verdict on the component of ∂₁L at a local tuple of symbols, or of ∂₁H at a state of such.
;; which : the coordinate's symbol, or its index, or a list of indices
(define (verify-ignorable f which state)
  (check-order-of-arguments 'verify-ignorable '(L which local) (list f which state))
  (define s (subject-of 'verify-ignorable f state))
  (independence s (index-chain which (coordinate state))))

;; The symbols of all coordinates for which that is proved.
(define (ignorable-coordinates f state)
  (map leaf-symbol (ignorable (subject-of 'ignorable-coordinates f state))))

;; A list of (up coordinate momentum), one for each.
(define (conserved-momenta f state)
  (define s (subject-of 'conserved-momenta f state))
  (define momenta (momenta-of s))
  (for/list ([entry (in-list (ignorable s))])
    (up (leaf-symbol entry) (simplify (component-at momenta (leaf-chain entry))))))

;; The coordinates that are proved to be ignorable
(define (ignorable s)
  (filter (lambda (entry) (proved? (independence s (leaf-chain entry))))
          (leaves (coordinate (subject-state s)))))

;; A verdict on the derivative by that coordinate alone.
(define (independence s chain)
  (define by-coordinate (apply partial 1 chain))
  (define-values (f state) (values (subject-function s) (subject-state s)))
  (prove-residual-zero (lambda () ((by-coordinate (number-of s)) state)) (scalars state)
                       #:domain (lambda () (values-at (list f) state))
                       #:meaning (lambda () (if (subject-Hamiltonian? s)
                                                (meaning-of-Hamiltonian f state)
                                                (meaning-of-Lagrangian f state)))
                       #:again (lambda (change)
                                 (independence (struct-copy subject s [function (change f)])
                                               chain))))

;; ---------------------------------------------------------------------------
;; The subject of a question

;; state : (t, q, v) of symbols, or (t, q, p) for a Hamiltonian
(struct subject (who function state Hamiltonian?) #:authentic)

(define (subject-of who f state)
  (check-order-of-arguments who '(L local) (list f state))
  (cond [(told-by-state? who f state)
         (check-Hamiltonian who f)
         (check-H-state who state)
         (check-symbols who state "state")
         (check-parameters who f state "state")
         (subject who f state #t)]
        [else
         (check-Lagrangian who f)
         (check-generic-states who state f)
         (subject who f ((clip-state 3) state) #f)]))

(define (number-of s)
  (define-values (who f) (values (subject-who s) (subject-function s)))
  (if (subject-Hamiltonian? s) (number-valued who f) (scalar-valued who f)))

(define (momenta-of s)
  (if (subject-Hamiltonian? s)
      (momentum (subject-state s))
      (((partial 2) (number-of s)) (subject-state s))))

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
