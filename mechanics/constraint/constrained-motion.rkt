#lang racket/base
;; Following a constrained motion in numbers.
;;
;; Accelerations solved for with the multipliers keep G̈ at zero, not G: errors of the
;; integration would let G and its rate drift.  So each step is taken back to where both are
;; zero, by the shortest way as kinetic energy measures it (motion/system/manifold.rkt):
;;
;;     M δ − Jᵀ μ = 0,    J δ = −G,
;;
;; repeated for the coordinates, and once, J δ = −(J v + ∂₀G), for the velocities.
;; Of constraints that repeat each other those stated first are kept, for the motion does not
;; depend on which; that is found out where the motion begins.

(require racket/flonum
         "accelerations.rkt" "constrained-code.rkt" "constraint.rkt" "dependence.rkt"
         "constraint-jacobian.rkt"
         "../calculus/gradient.rkt"
         "../error/complain.rkt" "../error/failure.rkt"
         "../generic/arithmetic.rkt" "../generic/define-plain.rkt" "../generic/describe.rkt"
         "../generic/function.rkt" "../generic/printed-function.rkt" "../generic/up-down.rkt"
         "../lagrangian/external-force.rkt" "../lagrangian/Lagrange-equations.rkt"
         "../lagrangian/local-tuple.rkt" "../lagrangian/state-derivative.rkt"
         "../motion/system/manifold.rkt"
         "../numeric/constants.rkt"
         "../value/shape.rkt"
         (only-in "../value/structure.rkt" list->up zero-like))

(provide constrained-state-derivative consistent-state)

;; (t, q, v) ↦ (1, v, a), with the parts that motion/system/manifold.rkt needs
(define-plain (constrained-state-derivative given-L constraints #:force [Q #f])
  (derivative-for 'constrained-state-derivative given-L constraints Q))

;; who : the procedure that the reader called
(define (derivative-for who given-L constraints Q)
  (define cs (gather-with who given-L constraints))
  (define-values (L outside) (values (scalar-valued who given-L) (external-force who Q #f)))
  (define (derivative choose)
    (define solve (accelerations-with who L cs outside choose))
    (lambda (state)
      (define-values (a multipliers) (solve state))
      (up 1 (velocity state) (vector->structure (velocity state) a))))
  (define all (derivative values))
  (make-manifold-derivative
   (lambda (state)
     (check-state who cs state)
     (all state))
   (lambda (caller state)
     (check-state who cs state)
     (define kept (and (numeric? state) (kept-constraints who cs state)))
     (define ready (if kept (derivative (choosing kept)) all))
     (preparation ready kept (watched who L cs outside kept)
                  (lambda () (complete who L cs outside kept ready state))))
   (apply call-datum 'constrained-state-derivative given-L cs (force->datum Q))))

;; -> corrections, and the compiled rates; both #f where symbols are left, which the caller
;; refuses; the rates #f where the derivative itself is compiled later
(define (complete who L cs outside kept ready state)
  (cond [(and kept (numeric? (ready state)))
         (define c (constrained-code who L cs outside kept ready state))
         (values (if c
                     (corrections (position-code c) (velocity-code c) (refusing cs))
                     (corrections-of who L cs kept))
                 (and c (rates-code c)))]
        [else (values #f #f)]))

;; The values of L, force and constraints, and the derivatives of L, which a large constant in the
;; value of L would hide.
(define ((watched who L cs outside kept) state)
  (up ((ingredients who L cs outside (or kept '())) state)
      ((gradient L) state)))

(define (check-state who cs state)
  (check-velocity who state)
  (void (checked-constraint-values who cs state)))

(define ((choosing kept) xs) (for/list ([k (in-list kept)]) (list-ref xs k)))

;; ---------------------------------------------------------------------------
;; Redundant constraints

;; The indices of the constraints to keep at this state and beyond, or #f if symbols are left.
;; The state is singular if constraints depend on each other there and not beside it.
(define (kept-constraints who cs state)
  (define (kept state)
    (define J (jacobian-rows who cs state))
    (and (andmap (lambda (row) (andmap real? (vector->list row))) J)
         (independent-rows who J)))
  (define here (kept state))
  (when (and here (not (equal? here (kept (beside-state state)))))
    (raise-singular-state who cs state))
  here)

(define (beside-state state)
  (list->structure
   state
   (for/list ([x (in-list (scalars state))] [k (in-naturals 1)])
     (+ x (* 1e-3 (+ 1 (abs x)) (spread-fraction k))))))

(define (raise-singular-state who cs state)
  (raise-singular
   who
   (string-append "where the motion begins, constraints depend on each other "
                  "that are independent elsewhere"
                  (format "\n  state: ~a" (value->text state))
                  (dependences->text (dependences who (jacobian-rows who cs state))))
   state))

;; ---------------------------------------------------------------------------
;; Back to the constraints

;; kept : indices of constraints
(define (corrections-of who L cs kept)
  (define holonomic-constraints? (ormap holonomic? (constraint-set-parts cs)))
  (corrections (and holonomic-constraints? (lambda (state) (towards-positions who L cs kept state)))
               (lambda (state) (towards-velocities who L cs kept state))
               (refusing cs)))

(define ((refusing cs) caller state) (raise-inconsistent caller cs state))

;; The increments of a state that take the coordinates, or the velocities, to where the
;; constraints hold.
(define (towards-positions who L cs kept state)
  (define-values (positions velocities) (positions-and-velocities who cs state))
  (define holonomic (filter (lambda (k) (list-ref positions k)) kept))
  (up 0
      (vector->structure (coordinate state) (shortest who L cs holonomic state positions))
      (zero-like (velocity state))))

(define (towards-velocities who L cs kept state)
  (define-values (positions velocities) (positions-and-velocities who cs state))
  (up 0
      (zero-like (coordinate state))
      (vector->structure (velocity state) (shortest who L cs kept state velocities))))

;; -> δ, a vector; off : the values of all constraints, a list; indices : the constraints to meet
(define (shortest who L cs indices state off)
  (define choose (choosing indices))
  (define-values (step multipliers)
    (solve-constrained who (mass-rows L state)
                       (choose (jacobian-rows who cs state))
                       (make-vector (shape-length (coordinate state)) 0)
                       (map g:negate (choose off))))
  step)

(define (raise-inconsistent caller cs state)
  (define-values (positions velocities) (positions-and-velocities caller cs state))
  (define (field label xs)
    (if (ormap values xs)
        (format "\n  ~a: ~a" label (value->text (single-or list->up (filter values xs))))
        ""))
  (complain caller
            (string-append "the state does not keep the constraints~a~a"
                           "\n  state: ~a"
                           "\n  ((consistent-state L constraints) state) is one beside it "
                           "that does")
            (field "values of the constraints" positions)
            (field "their rates of change" velocities)
            (value->text state)))

;; ---------------------------------------------------------------------------
;; A state to begin with

;; (consistent-state L constraints) : state -> the state, moved to keep the constraints
(define (consistent-state L constraints)
  (define who 'consistent-state)
  (define derivative (derivative-for who L constraints #f))
  (unary-function (call-datum who L (gather who constraints)) (state)
    (check-velocity who state)
    (define y (structure->flvector state (lambda (x) (raise-no-number who x state))))
    (define-values (on rates)
      (complete-motion who (prepare-motion who derivative state) state))
    (define project! (projector on (flvector-length y)))
    (project! y)
    (define found (flvector->structure state y))
    (define left (project! (flvector-copy y)))
    (unless (fl<= left 1e-12)
      (raise-not-convergent who "no state was found that keeps the constraints" found left))
    (up (time state) (coordinate found) (velocity found))))

(define (raise-no-number who x state)
  (complain who "expected a state of real numbers; it holds ~a\n  state: ~a"
            (describe-with-value x) (value->text state)))
