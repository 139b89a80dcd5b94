#lang racket/base
;; From a Lagrangian to the motion of local states (SICM 1.7).
;;
;; Lagrange's equations are linear in the accelerations: with P = ∂₂L and a force Q
;; outside L,
;;
;;     ∂₂P a = ∂₁L + Q − ∂₀P − ∂₁P v,
;;
;; so the accelerations follow from the local state (t, q, v) wherever the mass
;; matrix ∂₂∂₂L has an inverse.

(require "external-force.rkt" "Lagrange-equations.rkt" "local-tuple.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/hint.rkt"
         "../error/message-words.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/printed-function.rkt" "../generic/up-down.rkt" "../generic/value-struct.rkt"
         "../generic/wrong-argument.rkt"
         "../value/compose.rkt" "../value/simplify.rkt" "../value/structure.rkt"
         "../value/matrix/linear-algebra.rkt")

(provide Lagrangian->acceleration Lagrangian->state-derivative
         Lagrange-equations-first-order qv->state-path
         check-velocity
         ;; for those who explain a failure
         directions->text
         ;; for those who compile it
         Lagrangian-derivative? Lagrangian-derivative-Lagrangian)

;; (Lagrangian->acceleration L) : (t, q, v) ↦ a
(define (Lagrangian->acceleration L [dissipation #f] #:force [Q #f])
  (acceleration-function 'Lagrangian->acceleration L dissipation Q))

;; (Lagrangian->state-derivative L) : (t, q, v) ↦ (1, v, a)
(define (Lagrangian->state-derivative L [dissipation #f] #:force [Q #f])
  (define acceleration-at
    (acceleration-function 'Lagrangian->state-derivative L dissipation Q))
  (define f
    (function-of-state
     'Lagrangian->state-derivative L dissipation Q
     (lambda (state)
       (define acceleration (acceleration-at state))
       (up 1 (velocity state) acceleration))))
  (if (or dissipation Q)
      f
      (Lagrangian-derivative (function-procedure f) (function-mask f) (function-make-datum f) L)))

;; The state derivative without outside forces; it keeps its Lagrangian, from which it is compiled.
(value-struct Lagrangian-derivative function (Lagrangian))

(define (acceleration-function who L dissipation Q)
  (check-Lagrangian who L)
  (define outside (external-force who Q dissipation))
  (define L-scalar (scalar-valued who L))
  (define P ((partial 2) L-scalar))
  (define mass ((partial 2) P))
  (define (force state)
    (define inside
      (g:- (((partial 1) L-scalar) state)
           (g:+ (((partial 0) P) state)
                (g:* (((partial 1) P) state) (velocity state)))))
    (if outside (g:+ inside (force-like who inside (outside state))) inside))
  (function-of-state
   who L dissipation Q
   (lambda (state)
     (check-velocity who state)
     (with-handlers ([exn:fail:mechanics:singular:matrix? raise-no-inertia])
       (solve-linear-left (mass state) (force state))))))

;; Without this check a difference in shape would show only where parts of the equations are added.
(define (check-velocity who state)
  (unless (and (local-tuple? state) (>= (s:length state) 3))
    (complain-of-argument who "a state (up t q v)" state
                          (if (local-tuple? state)
                              "\n  the velocities are missing"
                              (list-hint state "(up t q v)"))))
  (define-values (q v) (values (coordinate state) (velocity state)))
  (unless (same-shape? q v)
    (complain who "the velocities are of another shape than the coordinates~a~a"
              (format "\n  coordinates: ~a" (value->text q))
              (format "\n  velocities: ~a" (value->text v)))))

;; A null vector of the mass matrix is a direction in which a change of velocity
;; changes no momentum.
(define (raise-no-inertia e)
  (define mass-matrix (exn:fail:mechanics:singular-where e))
  (raise-without-inverse
   'Lagrangian->acceleration
   (string-append "the mass matrix has no inverse; accelerations do not follow from the state"
                  (directions->text e)
                  (format "\n  mass matrix: ~a" (value->text (simplify mass-matrix))))
   mass-matrix
   (exn:fail:mechanics:singular:matrix-null-vectors e)
   e))

;; Lines on the directions in which the matrix of a failure has no inverse
(define (directions->text e [missing "no inertia"] [readable values])
  (joined (for/list ([v (in-list (or (exn:fail:mechanics:singular:matrix-null-vectors e) '()))])
            (format "\n  ~a in the direction: ~a" missing (value->text (readable v))))
          ""))

;; ---------------------------------------------------------------------------
;; Lagrange's equations of first order

;; (((Lagrange-equations-first-order L) q v) t) : how far (t, q(t), v(t)) is from
;; moving as the state derivative says.
(define (Lagrange-equations-first-order L [dissipation #f] #:force [Q #f])
  (define slope (Lagrangian->state-derivative L dissipation #:force Q))
  (define (residual q v)
    (define states (qv->state-path q v))
    (g:- (D states) (compose slope states)))
  (make-function residual 4 (made-from 'Lagrange-equations-first-order L dissipation Q)))

;; t ↦ (t, q(t), v(t)), whether v is the derivative of q or not.
(define (qv->state-path given-q given-v)
  (define q (path 'qv->state-path given-q))
  (define v (path 'qv->state-path given-v))
  (printed-function (qv->state-path q v) (t)
    (up t (q t) (v t))))

;; ---------------------------------------------------------------------------

(define (function-of-state who L dissipation Q f)
  (unary-function (made-from who L dissipation Q) (state) (f state)))

(define (made-from who L dissipation Q)
  (apply call-datum who L (append (if dissipation (list dissipation) '()) (force->datum Q))))
