#lang racket/base
;; SICM 3.6, Surfaces of Section (pp. 239–263), in the reader's own language.

(require mechanics
         (only-in "section-1-7.rkt" pend-state-derivative)
         "../calculus/perturbed-value.rkt"
         "../generic/compare.rkt" "../generic/wrong-argument.rkt"
         "../motion/system/check.rkt")

(provide driven-pendulum-map
         HHpotential HHHam HHsysder section->state HHmap
         make-advance find-next-crossing refine-crossing)

;; The periodically driven pendulum looked at once in each period of the drive, at phase 0
;; (p. 247).  A negative frequency leads back.  The pivot is at rest then, so that the momentum is
;; m l² θ'; and in between Lagrange's equation, which has fewer products than Hamilton's two, leads
;; from look to look.
(define (driven-pendulum-map m l g A omega)
  (check-pendulum m l g A omega)
  (define advance (state-advancer pend-state-derivative m l g A omega))
  (define period (/ :2pi omega))
  (define inertia (* m l l))
  (define angle (principal-value :pi))
  (define (strobe theta p_theta return fail)
    (define next (advance (up 0 theta (/ p_theta inertia)) period 1e-12))
    (return (angle (coordinate next)) (* inertia (velocity next))))
  (procedure-rename strobe 'driven-pendulum-map)) ; by which it is known in messages

(define (check-pendulum m l g A omega)
  (define who 'driven-pendulum-map)
  (check-parameters who '(m l g A omega) (list m l g A omega))
  (for ([x (in-list (list m l omega))] [name (in-list '(m l omega))])
    (when (zero? (comparand x))
      (complain-of-argument who (format "a parameter ~a that is not 0" name) x))))

(define (check-parameters who names values)
  (for ([x (in-list values)] [name (in-list names)])
    (check-real who (format "parameter ~a" name) (comparand x))))

;; ---------------------------------------------------------------------------
;; Hénon and Heiles: a star in the field of a galaxy, or any two degrees of freedom
;; (pp. 252 to 262)

(define (HHpotential s)
  (define-values (x y) (values (ref (coordinate s) 0) (ref (coordinate s) 1)))
  (+ (* 1/2 (+ (square x) (square y)))
     (* (square x) y)
     (* -1/3 (cube y))))

(define (HHHam s)
  (+ (* 1/2 (square (momentum s)))
     (HHpotential s)))

(define (HHsysder) (Hamiltonian->state-derivative HHHam))

;; The state of energy E on the section x = 0 on its way to positive x, or #f where the energy
;; does not suffice.
(define (section->state E y p_y)
  (for ([x (in-list (list E y p_y))] [name (in-list '(E y p_y))])
    (unless (real? (comparand (innermost x)))
      (complain-of-argument 'section->state (format "a real number as ~a" name) x)))
  (define twice-left
    (- (* 2 (- E (HHpotential (up 0 (up 0 y) (down 0 0)))))
       (square p_y)))
  (and (>= twice-left 0)
       (up 0 (up 0 y) (down (sqrt twice-left) p_y))))

;; From a crossing of the section with that energy to the next one (pp. 261 and 262): the motion
;; is followed to int-eps.  Crossings are zeros of the polynomials that the motion is along its
;; steps: none is missed, whatever dt, and each is found to rounding, nearer than sec-eps.
(define (HHmap E dt sec-eps int-eps)
  (check-parameters 'HHmap '(E dt sec-eps int-eps) (list E dt sec-eps int-eps))
  (define next-crossing
    (Poincare-map (HHsysder) (upwards) #:tolerance int-eps))
  (define (section y p_y return fail)
    (define start (section->state E y p_y))
    (cond [start
           (define crossing (next-crossing start))
           (return (ref (coordinate crossing) 1)
                   (ref (momentum crossing) 1))]
          [else (fail)]))
  (procedure-rename section 'HHmap))

(define (upwards)
  (event (lambda (s) (ref (coordinate s) 0)) #:direction 'rising #:name 'section))

;; The same step by step, as the book has it, with any advancer: one is made of a
;; state-advancer and the tolerance of the integration.
(define ((make-advance advancer int-eps) state dt) (advancer state dt int-eps))

;; (return crossing beyond): where x next becomes positive, and the state at the end of the
;; step of dt in which it does.
(define (find-next-crossing state advance dt sec-eps return)
  (check-positive 'find-next-crossing "dt" dt)
  (check-positive 'find-next-crossing "sec-eps" sec-eps)
  (let loop ([s state])
    (define next (advance s dt))
    (if (and (< (ref (coordinate s) 0) 0)
             (>= (ref (coordinate next) 0) 0))
        (return (refine-crossing sec-eps advance s) next)
        (loop next))))

;; Newton's method for the time at which x = 0, from a state near by; to sec-eps, or as near as
;; rounding lets it come.
(define (refine-crossing sec-eps advance state)
  (check-positive 'refine-crossing "sec-eps" sec-eps)
  (let closer ([state state] [steps 0])
    (define-values (x xdot) (values (ref (coordinate state) 0) (ref (momentum state) 0)))
    (define next (advance state (- (/ x xdot))))
    (if (or (< (abs (ref (coordinate next) 0)) sec-eps) (= steps most-refinements))
        next
        (closer next (+ steps 1)))))

(define most-refinements 50)
