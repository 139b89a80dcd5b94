#lang racket/base
;; SICM 3.6, Surfaces of Section (pp. 239–263), in the reader's own language.

(require mechanics
         (only-in "section-3-5.rkt" H-pend-sysder))

(provide driven-pendulum-map
         HHpotential HHHam HHsysder section->state HHmap
         make-advance find-next-crossing refine-crossing)

;; The periodically driven pendulum looked at once in each period of the drive, at phase 0
;; (p. 247).  A negative frequency leads back.
(define (driven-pendulum-map m l g A omega)
  (define advance (state-advancer H-pend-sysder m l g A omega))
  (define period (/ :2pi omega))
  (define angle (principal-value :pi))
  (lambda (theta p_theta return fail)
    (define next (advance (up 0 theta p_theta) period 1e-12))
    (return (angle (coordinate next)) (momentum next))))

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
  (define twice-left
    (- (* 2 (- E (HHpotential (up 0 (up 0 y) (down 0 0)))))
       (square p_y)))
  (and (>= twice-left 0)
       (up 0 (up 0 y) (down (sqrt twice-left) p_y))))

;; From a crossing of the section with that energy to the next one (pp. 261 and 262): the motion
;; is followed to int-eps.  Crossings are zeros of the polynomials that the motion is along its
;; steps: none is missed, whatever dt, and each is found to rounding, nearer than sec-eps.
(define (HHmap E dt sec-eps int-eps)
  (define next-crossing
    (Poincare-map (HHsysder) (upwards) #:tolerance int-eps))
  (lambda (y p_y return fail)
    (define start (section->state E y p_y))
    (cond [start
           (define crossing (next-crossing start))
           (return (ref (coordinate crossing) 1)
                   (ref (momentum crossing) 1))]
          [else (fail)])))

(define (upwards)
  (event (lambda (s) (ref (coordinate s) 0)) #:direction 'rising #:name 'section))

;; The same step by step, as the book has it, with any advancer: one is made of a
;; state-advancer and the tolerance of the integration.
(define ((make-advance advancer int-eps) state dt) (advancer state dt int-eps))

;; (return crossing beyond): where x next becomes positive, and the state at the end of the
;; step of dt in which it does.
(define (find-next-crossing state advance dt sec-eps return)
  (let loop ([s state])
    (define next (advance s dt))
    (if (and (< (ref (coordinate s) 0) 0)
             (>= (ref (coordinate next) 0) 0))
        (return (refine-crossing sec-eps advance s) next)
        (loop next))))

;; Newton's method for the time at which x = 0, from a state near by.
(define (refine-crossing sec-eps advance state)
  (define-values (x xdot) (values (ref (coordinate state) 0) (ref (momentum state) 0)))
  (define closer (advance state (- (/ x xdot))))
  (if (< (abs (ref (coordinate closer) 0)) sec-eps)
      closer
      (refine-crossing sec-eps advance closer)))
