#lang racket/base
;; Questions asked with their arguments in another order.
;;
;; A Lagrangian, a quantity and a path are all functions, and the answer to what was not meant
;; may well be a verdict.  What can be told by its kind, or by failing, is refused; where the
;; names or a second verdict suggest it, that is remarked.

(require "../calculus/derivative.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/refusal.rkt"
         "../generic/compare.rkt" "../generic/describe.rkt" "../generic/up-down.rkt"
         "../hamiltonian/known-Hamiltonians.rkt"
         "../lagrangian/name-hints.rkt" "../lagrangian/Lagrange-equations.rkt"
         "../value/shape.rkt")

(provide check-order-of-arguments check-Hamiltonian-first call-with-quantity-last
         remarks-on-order plain-function?)

;; ---------------------------------------------------------------------------
;; By kind

;; names : what the arguments are called, such as (L q) or (L Q local); a function comes
;; first, and a local tuple last.
(define (check-order-of-arguments who names arguments)
  (define others (cdr arguments))
  (define function-later?
    (and (not (plain-function? (car arguments))) (ormap plain-function? others)))
  (define tuple-earlier?
    (and (memq 'local names)
         (not (tuple? (last-of arguments)))
         (ormap tuple? (reverse (cdr (reverse arguments))))))
  (when (or function-later? tuple-earlier?)
    (complain who "the arguments come in another order: ~a" (value->text (cons who names)))))

(define (plain-function? x) (and (procedure? x) (not (tuple? x))))

(define (last-of xs) (car (reverse xs)))

;; Is another of the arguments known to be a Hamiltonian, and the first is not?
(define (check-Hamiltonian-first who H . others)
  (when (and (not (declared-Hamiltonian? H)) (ormap declared-Hamiltonian? others))
    (complain who "the Hamiltonian comes first; these look exchanged")))

;; ---------------------------------------------------------------------------
;; By failing

;; The values of the thunk; where it says that L is without inertia, and Q has it, Q is the
;; Lagrangian.
(define (call-with-quantity-last who L Q state thunk)
  (with-handlers ([exn:fail:mechanics:singular?
                   (lambda (e)
                     (when (and (inert? Q state) (not (inert? L state)))
                       (complain
                        who "the Lagrangian comes first, then the quantity; these look swapped"))
                     (raise e))])
    (thunk)))

;; Does f depend on the velocities otherwise than linearly?
(define (inert? f state)
  (with-handlers ([raised? (lambda (e) #f)])
    (define by-velocities (partial 2))
    (define second ((by-velocities (by-velocities (scalar-valued 'Lagrangian f))) state))
    (for/or ([x (in-list (scalars second))]) (not (g:zero? x)))))

;; ---------------------------------------------------------------------------
;; By name

;; An energy for a Lagrangian conserves the Lagrangian, which is its energy: so nothing but the
;; names tells.
(define (remarks-on-order L Q state)
  (if (and (inert? Q state) (called-Lagrangian? Q) (not (called-Lagrangian? L)) (named? L))
      (list (format "~a was taken for the Lagrangian, which comes first, and ~a for the quantity"
                    (value->text L) (value->text Q)))
      '()))
