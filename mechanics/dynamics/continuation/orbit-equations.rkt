#lang racket/base
;; The equations of a periodic orbit: the state comes back after the period T.
;;
;; Unknowns are the start z, the period where the system itself decides it, and the parameter p;
;; the derivatives of the end by z and p follow from the variational equations, in one integration,
;; with p as a component of the state that rests.  Of all starts along the orbit the one is
;; taken that has not moved along the flow from a reference: f(z₀)·(z − z₀) = 0.
;;
;; Where an energy H is kept the orbits are a family, of which H is the parameter; one of the
;; equations follows from the others, and λ ∇H is added to z(T) − z, which lets H grow: an orbit
;; that closes has λ = 0 (F. J. Muñoz-Almaraz and others, Physica D 181, 2003).

(require racket/flonum
         (only-in racket/list range)
         "branch-start.rkt" "curve-step.rkt"
         "../map/map-on-tuples.rkt"
         "../../calculus/derivative.rkt"
         "../../generic/up-down.rkt"
         "../../motion/evolution.rkt" "../../motion/linearized-flow.rkt"
         "../../motion/observed-systems.rkt"
         "../../numeric/constants.rkt" "../../numeric/flvector.rkt"
         "../../numeric/linear-algebra/flonum-systems.rkt"
         "../../numeric/linear-algebra/general-eigenvalues.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt"
         "../../value/shape.rkt"
         (only-in "../../value/structure.rkt" ref structure->list))

(provide (struct-out orbits) orbit-equations orbit-unknowns flow-over flow-end flow-slopes
         rates-at state-of start-of turns-of
         ;; for other equations
         part row-of longer rows-and energy-at energy-slope)

;; family : parameter -> state derivative; state : gives shape and time; timed? : is the time in it?
;; period : parameter -> number, of a system that is driven; #f where it is unknown
;; energy : of a state, or #f; turns : flvector, by which angles are ahead after a period
;; times : the periods of the drive in one of the orbit; advance : the state, p and displacements
(struct orbits (family state timed? period energy turns times advance) #:authentic)

(define (turns-of gap)
  (for/flvector #:length (flvector-length gap) ([d (in-flvector gap)])
    (define whole (fl* :2pi (flround (fl/ d :2pi))))
    (if (fl< (flabs (fl- d whole)) 0.1) whole 0.0)))

;; ---------------------------------------------------------------------------
;; The flow

;; end : flvector; slopes : rows of its derivatives by the start and the parameter
(struct flow (end slopes) #:authentic)

(define (start-of o) (let ([all (scalars (orbits-state o))]) (if (orbits-timed? o) (cdr all) all)))

(define (state-of o z) (with-unknowns (orbits-state o) (orbits-timed? o) (up-of-numbers z)))

;; The numbers of a state, without the time
(define (moving o state)
  (define all (numbers-of state))
  (if (orbits-timed? o) (apply flvector (cdr (flvector->list all))) all))

(define (rates-at o z p) (moving o (((orbits-family o) p) (state-of o z))))

(define (with-parameter family)
  (lambda (both) (up ((family (ref both 1)) (ref both 0)) 0)))

;; -> a procedure: start, parameter, duration -> flow
(define (flow-over family state timed? tolerance)
  (define advance (state-advancer (lambda () (with-displacements (with-parameter family)))))
  (lambda (o z p duration)
    (define both (up (state-of o z) p))
    (define start (apply up both (unit-displacements both (if timed? 1 0))))
    (define end
      (structure->list
       (call-unwatched
        (lambda () (call-for-state 'continue (lambda () (advance start duration tolerance)))))))
    (flow (moving o (ref (car end) 0))
          (rows-transpose (for/vector ([v (in-list (cdr end))])
                            (list->vector (flvector->list (moving o (ref v 0)))))))))

;; ---------------------------------------------------------------------------
;; Unknowns: z, then the period unless the system is driven, then λ and the energy or the parameter

(define (orbit-unknowns o z T p)
  (apply flvector (append (flvector->list z) (if (orbits-period o) '() (list T))
                          (if (orbits-energy o) (list 0.0) '()) (list p))))

;; The part of x of that length from a place on
(define (part x from count)
  (for/flvector #:length count ([k (in-range count)]) (flvector-ref x (+ from k))))

(define (orbit-equations o x0 scale)
  (define n (length (start-of o)))
  (define scales
    (for/flvector #:length (flvector-length x0) ([x (in-flvector x0)] [k (in-naturals 1)])
      (cond [(= k (flvector-length x0)) scale]
            [(= k (+ n 1)) (flmax 1e-3 (flabs x))]
            [else (fl+ 1.0 (flabs x))])))
  (equations (lambda (x reference) (evaluate-orbit o n x reference)) scales
             (lambda (x) (period-at o n x))
             (lambda (x)
               (define twice (struct-copy orbits o [times (* 2 (orbits-times o))]
                                          [turns (flvector-scaled 2.0 (orbits-turns o))]))
               (define y (flvector-copy x))
               (unless (orbits-period o) (flvector-set! y n (fl* 2.0 (flvector-ref x n))))
               (values (orbit-equations twice y scale) y))))

(define (period-at o n x)
  (define period (orbits-period o))
  (if period
      (* (orbits-times o) (period (flvector-ref x (- (flvector-length x) 1))))
      (flvector-ref x n)))

(define (evaluate-orbit o n x reference)
  (define z (part x 0 n))
  (define parameter (flvector-ref x (- (flvector-length x) 1)))
  (define p (if (orbits-energy o) 0.0 parameter))
  (define period (orbits-period o))
  (define T (period-at o n x))
  (define fl ((orbits-advance o) o z p T))
  (define gap (difference (difference (flow-end fl) z) (orbits-turns o)))
  (define speed (rates-at o (flow-end fl) p))
  (define M (submatrix (flow-slopes fl) (range n) (range n)))
  (define along-flow (rates-at o (part reference 0 n) p))
  (cond [period (driven-part o n fl gap M speed p)]
        [(orbits-energy o) (kept-part o n x z reference gap M speed along-flow parameter)]
        [else (free-part n z reference gap M speed along-flow (flow-slopes fl))]))

(define (energy-at o z) (flvector-ref (numbers-of ((orbits-energy o) (state-of o z))) 0))
(define (energy-slope o z) (moving o (derivative-at (orbits-energy o) (state-of o z))))

;; ---------------------------------------------------------------------------
;; The rows, row by row beside those of M − 1
(define (beside-displacement n M columns)
  (for/vector #:length n ([row (in-vector (rows-combine - M (unit-rows n 1.0 0.0)))]
                          [i (in-naturals)])
    (list->vector (append (vector->list row)
                          (for/list ([c (in-list columns)]) (if c (flvector-ref c i) 0.0))))))

(define (column rows j) (for/flvector ([row (in-vector rows)]) (vector-ref row j)))
(define (row-of v . further) (list->vector (append (flvector->list v) further)))
(define (longer v . further) (apply flvector (append (flvector->list v) further)))
(define (rows-and rows . further) (list->vector (append (vector->list rows) further)))

;; How the period of the drive changes with the parameter
(define (driven-part o n fl gap M speed p)
  (define slower (* (orbits-times o) (derivative-at (orbits-period o) p)))
  (define by-p (along (column (flow-slopes fl) n) (real->double-flonum slower) speed))
  (evaluated gap (beside-displacement n M (list by-p)) (lambda () (multipliers M n '()))))

(define (free-part n z reference gap M speed along-flow slopes)
  (define unit (flvector-scaled (fl/ 1.0 (norm along-flow)) along-flow))
  (evaluated (longer gap (dot unit (difference z (part reference 0 n))))
             (rows-and (beside-displacement n M (list speed (column slopes n)))
                       (row-of unit 0.0 0.0))
             (lambda () (multipliers M n (list speed)))))

(define (kept-part o n x z reference gap M speed along-flow h)
  (define unit (flvector-scaled (fl/ 1.0 (norm along-flow)) along-flow))
  (define slope (energy-slope o z))
  (define lambda* (flvector-ref x (+ n 1)))
  (evaluated (longer (along gap lambda* slope) (dot unit (difference z (part reference 0 n)))
                     (- (energy-at o z) h))
             (rows-and (beside-displacement n M (list speed slope #f))
                       (row-of unit 0.0 0.0 0.0)
                       (row-of slope 0.0 0.0 -1.0))
             (lambda () (multipliers M n (list speed slope)))))

;; Of M, less the 1 along the flow and the 1 of the energy: in the space normal to both, where M
;; leaves the flow's direction alone and does not change the energy, they are those of the others.
(define (multipliers M n given)
  (define known (filter (lambda (v) (fl> (norm v) 0.0)) given))
  (define basis
    (if (null? known)
        (for/list ([k (in-range n)]) (unit-flvector k n))
        (let-values ([(_rank vs) (floating-kernel (for/vector ([v (in-list known)]) (row-of v)))])
          (for/list ([v (in-list vs)]) (apply flvector (vector->list v))))))
  (define m (length basis))
  (define (products f)
    (for/vector #:length m ([u (in-list basis)])
      (for/vector #:length m ([v (in-list basis)]) (dot u (f v)))))
  (define reduced
    (floating-solutions (products values) (products (lambda (v) (rows-times M v)))))
  (sort (or (and (vector? reduced) (real-matrix-eigenvalues (rows->flvector reduced) m)) '())
        > #:key magnitude))
