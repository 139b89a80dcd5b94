#lang racket/base
;; Generating functions (SICM 5.4).
;;
;; A canonical transformation has p dq − H dt = p' dq' − H' dt + dF, so that, F being written in
;; one old and one new variable, its derivatives give the other two:
;;
;;     F₁(t, q, q')     p =  ∂₁F₁      p' = −∂₂F₁
;;     F₂(t, q, p')     p =  ∂₁F₂      q' =  ∂₂F₂
;;     F₃(t, p, q')     q = −∂₁F₃      p' = −∂₂F₃
;;     F₄(t, p, p')     q = −∂₁F₄      q' =  ∂₂F₄
;;
;; and H' = H∘C + ∂₀F in each case.  From the new state the first equation is not needed: the
;; second is solved for the old variable, and then the first gives the other old one.  The other
;; way round for the inverse.

(require "mixed-variables.rkt"
         "../calculus/derivative.rkt"
         "../generic/arithmetic.rkt" "../generic/function-check.rkt" "../generic/function.rkt"
         "../generic/printed-function.rkt" "../generic/up-down.rkt"
         "../hamiltonian/H-state.rkt"
         "../lagrangian/local-tuple.rkt"
         (only-in "../value/structure.rkt" ref))

(provide F1->C F2->C F3->C F4->C
         F1->C-inv F2->C-inv F3->C-inv F4->C-inv
         F1->K F2->K F3->K F4->K
         ;; for the way back
         (struct-out type) type-of check-generator old-sign new-sign signed part other state-of
         time-and-variable named)

;; ---------------------------------------------------------------------------
;; The four types

;; old, new : 'q or 'p, the variables that F depends on
(struct type (number old new) #:authentic)

(define types
  (list (type 1 'q 'q) (type 2 'q 'p) (type 3 'p 'q) (type 4 'p 'p)))

(define (type-of number) (list-ref types (sub1 number)))

;; The sign with which the derivative by that variable gives the other one.
(define (old-sign k) (if (eq? (type-old k) 'q) 1 -1))
(define (new-sign k) (if (eq? (type-new k) 'q) -1 1))

(define (part state which) (if (eq? which 'q) (coordinate state) (momentum state)))
(define (other which) (if (eq? which 'q) 'p 'q))

;; (t, q, p) of a variable and its conjugate
(define (state-of t which x conjugate)
  (if (eq? which 'q) (up t x conjugate) (up t conjugate x)))

(define (signed sign x) (if (= sign 1) x (g:negate x)))

;; ---------------------------------------------------------------------------
;; Transformations

(define-syntax-rule (define-of-types make [name number] ...)
  (begin (define (name F) (make 'name (type-of number) F)) ...))

(define-of-types to-old [F1->C 1] [F2->C 2] [F3->C 3] [F4->C 4])
(define-of-types to-new [F1->C-inv 1] [F2->C-inv 2] [F3->C-inv 3] [F4->C-inv 4])

;; new state ↦ old state
(define (to-old who k F)
  (check-generator who k F)
  (completed who F (new-of who k F) (old-of who k F)))

;; old state ↦ new state
(define (to-new who k F)
  (check-generator who k F)
  (completed who F (old-of who k F) (new-of who k F)))

;; One of the two variables that F depends on: "old" or "new", 'q or 'p, the sign with which the
;; derivative by it gives its conjugate; and F of the time, this variable and the other one
(struct variable (age which sign at) #:authentic)

(define (old-of who k F) (variable "old" (type-old k) (old-sign k) (number-valued who F)))
(define (new-of who k F)
  (define number (number-valued who F))
  (variable "new" (type-new k) (new-sign k) (lambda (t y x) (number t x y))))

(define (slope v t x other) (derivative-at (lambda (x) ((variable-at v) t x other)) x))

;; state with the known variable and its conjugate ↦ state with the one sought
(define (completed who F known sought)
  (define solve (solved who known sought))
  (define which (variable-which sought))
  (unary-function (call-datum who F) (state)
    (check-H-state who state)
    (define-values (t x) (values (time state) (solve state)))
    (state-of t which x
              (signed (variable-sign sought)
                      (slope sought t x (part state (variable-which known)))))))

;; state with the known variable and its conjugate ↦ the one sought.  The search for it begins with
;; the coordinates or momenta of the state, as near a transformation that is close to the identity.
(define (solved who known sought)
  (define which (variable-which known))
  (define s
    (mixed-variable-solver
     who
     (format "~a ~a" (variable-age sought) (named (variable-which sought)))
     (format "the ~a state" (variable-age known))
     (lambda (place x)
       (define-values (t y) (time-and-variable place))
       (slope known t y x))))
  (lambda (state)
    (solution-at s (up (time state) (part state which)) (part state (variable-which sought))
                 (signed (variable-sign known) (part state (other which))))))

;; place : (up t x), as a solver is given it
(define (time-and-variable place) (values (ref place 0) (ref place 1)))

(define (named which) (if (eq? which 'q) "coordinates" "momenta"))

;; ---------------------------------------------------------------------------
;; The correction of the new Hamiltonian: new state ↦ ∂₀F

(define-of-types rate-of-generator [F1->K 1] [F2->K 2] [F3->K 3] [F4->K 4])

(define (rate-of-generator who k F)
  (check-generator who k F)
  (define solve (solved who (new-of who k F) (old-of who k F)))
  (unary-function (call-datum who F) (state)
    (check-H-state who state)
    (define-values (x y) (values (solve state) (part state (type-new k))))
    (derivative-at (lambda (t) (F t x y)) (time state))))

;; ---------------------------------------------------------------------------
;; Bad generating functions

(define (check-generator who k F)
  (check-takes who F 3
               (format (string-append "a generating function of type ~a takes three arguments, "
                                      "the time, the old ~a and the new ~a")
                       (type-number k) (named (type-old k)) (named (type-new k)))))

(define ((number-valued who F) t x y)
  (check-scalar-value who "a generating function" F (F t x y)))
