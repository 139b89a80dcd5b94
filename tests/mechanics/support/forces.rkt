#lang racket/base
;; Particles and forces that are used in several tests.

(require mechanics)

(provide pendulum weight polar drag
         position-1 positions-1 position-2 positions-2 force-on-one force-on-two
         position-of force-of)

;; A pendulum, its angle from the bottom; a position in the plane.
(define ((pendulum l) t theta) (up (* l (sin theta)) (* -1 l (cos theta))))
(define ((weight m g) t r v) (up 0 (* -1 m g)))
(define (polar t q)
  (up (* (ref q 0) (cos (ref q 1))) (* (ref q 0) (sin (ref q 1)))))
(define ((drag b) t r v) (* -1 b v))

;; Any position in space, and any two, as a function of time and one or two coordinates.
(define (position-of name coordinates)
  (literal-function name (-> (X Real (if (= coordinates 1) Real (UP* Real coordinates)))
                             (UP Real Real Real))))
(define position-1 (position-of 'r 1))
(define position-2 (position-of 'r 2))
(define (positions-1 t q) (up (position-1 t q) ((position-of 's 1) t q)))
(define (positions-2 t q) (up (position-2 t q) ((position-of 's 2) t q)))

;; Any force of time, positions and velocities.
(define (force-of particles)
  (define space '(UP Real Real Real))
  (define shape (if (= particles 1) space (UP* space particles)))
  (literal-function 'F (-> (X Real shape shape) shape)))
(define force-on-one (force-of 1))
(define force-on-two (force-of 2))
