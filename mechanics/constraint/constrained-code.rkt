#lang racket/base
;; Constrained motions compiled from the Lagrangian and the constraints themselves.
;;
;; Derivatives of both, taken by the generic arithmetic on placeholders, make each part of them
;; many times.  Here L, the force and the constraints are traced once, to one short list of
;; instructions.  A sweep back over it from L, and one from each constraint G, give the momenta
;; P, ∂L/∂q, the Jacobian J and the rates Ġ = ∂₀G + J v; a sweep forwards, in the direction
;; (1, v, 0), gives dP/dt but for the accelerations and γ, the known part of the rates of Ġ; one
;; for each velocity a column of the mass matrix M.  Constraints demand, for suitable f
;; and c,
;;
;;     M a − Jᵀ λ = f,    J a = c,
;;
;; whatever a is: accelerations, or a way back to the constraints (constrained-motion.rkt).
;; constrained-solution.rkt writes the solution of this system.

(require (only-in racket/list append-map make-list range split-at)
         (only-in racket/vector vector-append vector-copy)
         "constrained-solution.rkt" "constraint-jacobian.rkt"
         "../compile/program-builder.rkt" "../compile/compile-function.rkt" "../compile/program.rkt"
         "../compile/derivative-sweep.rkt"
         "../generic/up-down.rkt"
         "../lagrangian/local-tuple.rkt"
         "../motion/system/Lagrangian-code.rkt"
         "../value/shape.rkt")

(provide constrained-code ingredients
         (rename-out [codes-rates rates-code] [codes-position position-code]
                     [codes-velocity velocity-code]))

;; Compiled functions of the state: its rates; the increments that take the coordinates, or the
;; velocities, to where the constraints hold.  position is #f if no constraint is holonomic.
(struct codes (rates position velocity) #:authentic)

;; kept : indices of constraints; derivative : state -> the rates, for its name
;; -> codes; or #f where L, force and constraints cannot be traced
(define (constrained-code who L cs outside kept derivative state)
  (define p (traced-program (ingredients who L cs outside kept) state #:name who))
  (define n (shape-length (coordinate state)))
  (define holonomic (holonomic-among who cs kept state))
  (define first-derivatives (and p (differentiable? p) (swept-back p n holonomic outside)))
  (and first-derivatives
       (differentiable? first-derivatives)
       (codes-of first-derivatives n holonomic outside derivative state)))

;; state ↦ L, the kept constraints, the force
(define ((ingredients who L cs outside kept) state)
  (define all (scalars (constraint-values who cs state)))
  (apply up (L state)
         (append (for/list ([k (in-list kept)]) (list-ref all k))
                 (if outside
                     (force-scalars (outside state) (shape-length (coordinate state)))
                     '()))))

;; 0 is no force whatever the shape
(define (force-scalars force n) (if (eqv? force 0) (make-list n 0) (scalars force)))

;; For each kept constraint: is it holonomic?
(define (holonomic-among who cs kept state)
  (define-values (positions velocities) (positions-and-velocities who cs state))
  (for/list ([k (in-list kept)]) (and (list-ref positions k) #t)))

;; ---------------------------------------------------------------------------
;; First derivatives

;; ingredients : their program -> the program of ∂L/∂q, P, the force if there is one, and for
;; each constraint its value, its rate and its row of J
(define (swept-back ingredients n holonomic outside)
  (define-values (b p) (reload ingredients))
  (define outputs (vector->list (program-outputs p)))
  (define of-L (sweep-back! b p (car outputs)))
  (define-values (constraints force) (split-at (cdr outputs) (length holonomic)))
  (builder->program
   b (program-inputs p)
   (append (elements of-L 1 (+ n 1))
           (elements of-L (+ n 1) (+ n n 1))
           force
           (append-map (lambda (x holonomic?) (constraint-outputs b p n x holonomic?))
                       constraints holonomic))))

(define (elements v from to) (vector->list (vector-copy v from to)))

(define (constraint-outputs b p n x holonomic?)
  (define slopes (sweep-back! b p x))
  (define row (if holonomic? (elements slopes 1 (+ n 1)) (elements slopes (+ n 1) (+ n n 1))))
  (define rate
    (if holonomic?
        (for/fold ([sum (vector-ref slopes 0)]) ([x (in-list row)] [k (in-naturals (+ n 1))])
          (add! b sum (multiply! b x (place k))))
        x))
  (list* x rate row))

;; ---------------------------------------------------------------------------
;; Second derivatives, and the programs

;; The parts of the program of first derivatives, vectors of operands.
(struct parts (by-q momenta force values rates J) #:authentic)

(define (parts-of p n count force?)
  (define outputs (program-outputs p))
  (define (from start) (vector-copy outputs start (+ start n)))
  (define constraints (if force? (* 3 n) (* 2 n)))
  (define (constraint i) (+ constraints (* i (+ n 2))))
  (parts (from 0) (from n) (if force? (from (* 2 n)) (make-vector n 0))
         (for/vector ([i (in-range count)]) (vector-ref outputs (constraint i)))
         (for/vector ([i (in-range count)]) (vector-ref outputs (+ 1 (constraint i))))
         (for/vector ([i (in-range count)]) (from (+ 2 (constraint i))))))

(define (codes-of first-derivatives n holonomic outside derivative state)
  (define-values (b p) (reload first-derivatives))
  (define ps (parts-of p n (length holonomic) (and outside #t)))
  (define velocities (for/list ([k (in-range n)]) (place (+ 1 n k))))
  (define solve (solver b (mass-matrix b p (parts-momenta ps)) (parts-J ps)))
  (define all (range (length holonomic)))
  (define on-positions (for/list ([h? (in-list holonomic)] [i (in-list all)] #:when h?) i))
  (define still (map (lambda (x) 0) velocities))
  (define (back xs indices) (way-back b solve n xs indices))
  (define (code first q v)
    (program->compiled-function
     (builder->program b (program-inputs p) (append (list first) q v))
     (up first (velocity state) (velocity state)) derivative))
  (codes (code 1 velocities (accelerations b p solve ps all))
         (and (pair? on-positions) (code 0 (back (parts-values ps) on-positions) still))
         (code 0 still (back (parts-rates ps) all))))

;; -> (f c indices ↦ a), for the constraints of these indices
(define ((solver b M J) f c indices)
  (constrained-solution! b M (for/list ([i (in-list indices)]) (vector-ref J i)) f c))

(define (accelerations b p solve ps all)
  (define known (known-rates b p (vector-append (parts-momenta ps) (parts-rates ps))))
  (solve (for/vector ([by-q (in-vector (parts-by-q ps))] [Q (in-vector (parts-force ps))]
                      [P (in-vector (parts-momenta ps))])
           (subtract! b (add! b by-q Q) (known P)))
         (for/list ([r (in-vector (parts-rates ps))]) (negate! b (known r)))
         all))

;; To where the xs of these indices are zero.
(define (way-back b solve n xs indices)
  (solve (make-vector n 0)
         (for/list ([i (in-list indices)]) (negate! b (vector-ref xs i)))
         indices))
