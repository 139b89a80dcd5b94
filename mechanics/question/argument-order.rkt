#lang racket/base
;; Questions asked with their arguments in another order.
;;
;; A Lagrangian, a quantity and a path are all functions, and the answer to a question with
;; exchanged arguments may well be a verdict.  An order that is wrong by the kinds of the arguments,
;; or fails, is refused; where names or a second verdict suggest an exchange, there is a remark.

(require (only-in racket/list last)
         "../calculus/derivative.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/refusal.rkt"
         "../generic/compare.rkt" "../generic/describe.rkt"
         "../generic/function-check.rkt" "../generic/up-down.rkt" "../generic/wrong-argument.rkt"
         "../hamiltonian/known-Hamiltonians.rkt"
         "../lagrangian/function-name-hints.rkt" "../lagrangian/Lagrange-equations.rkt"
         "../value/shape.rkt")

(provide check-order-of-arguments check-Hamiltonian-first call-with-quantity-last
         remarks-on-order)

;; ---------------------------------------------------------------------------
;; By kind

;; names : words for the arguments, such as (L q) or (L Q local); a function comes
;; first, and a local tuple last.
(define (check-order-of-arguments who names arguments)
  (define function-later?
    (and (not (plain-procedure? (car arguments))) (ormap plain-procedure? (cdr arguments))))
  (define tuple-earlier?
    (and (memq 'local names)
         (not (tuple? (last arguments)))
         (ormap tuple? arguments)))
  (when (or function-later? tuple-earlier?)
    (complain who "the arguments come in another order: ~a" (value->text (cons who names)))))

;; Refuses a first argument that is not known to be a Hamiltonian where another one is.
(define (check-Hamiltonian-first who H . others)
  (when (and (not (declared-Hamiltonian? H)) (ormap declared-Hamiltonian? others))
    (complain who "the Hamiltonian comes first; these look exchanged")))

;; ---------------------------------------------------------------------------
;; By failing

;; The values of the thunk.  If it fails, L has no inertia and Q has, then Q is the Lagrangian.
(define (call-with-quantity-last who L Q state thunk)
  (with-handlers ([exn:fail:mechanics:singular?
                   (lambda (e)
                     (check-comes-first who (and (inert? Q state) (not (inert? L state)))
                                        "Lagrangian" "quantity")
                     (raise e))])
    (thunk)))

;; Does f depend on the velocities otherwise than linearly?
(define (inert? f state)
  (if-raised raised? #f
    (define by-velocities (partial 2))
    (define M ((by-velocities (by-velocities (scalar-valued 'Lagrangian f))) state))
    (not (andmap g:zero? (scalars M)))))

;; ---------------------------------------------------------------------------
;; By name

;; An energy taken for a Lagrangian conserves the Lagrangian, which is its energy: so only the names
;; show the exchange.
(define (remarks-on-order L Q state)
  (if (and (inert? Q state) (called-Lagrangian? Q) (not (called-Lagrangian? L)) (named? L))
      (list (format "~a was taken for the Lagrangian, which comes first, and ~a for the quantity"
                    (value->text L) (value->text Q)))
      '()))
