#lang racket/base
;; What a method of integration is to those who use it.
;;
;; A *method* starts a *stepper* for a system y' = f(y); the stepper holds the
;; state of one integration.  It tries a step of some length and says how wrong
;; that may be; the driver (integrate.rkt) accepts it or tries a shorter one.
;; Time, where f depends on it, is a component of y with derivative 1.

(provide (struct-out method) (struct-out stepper))

;; order : the error of a step of length h is of the order h^order
;; adaptive? : does it estimate that error?
;; start : (f! y0) -> stepper; (f! y dy) stores f(y) in dy
(struct method (name order adaptive? start)
  #:authentic
  #:property prop:object-name 0)

;; state       : the flvector of the present state, which steps overwrite
;; slope       : -> the flvector f(state), good until a step is tried
;; try!        : h -> the error of a step of that length, a flonum: the root mean
;;               square over the components, each relative to 1 + |y|; 0.0 if the
;;               method does not know
;; accept!     : -> void; the state tried last becomes the present one
;; interpolant : -> (theta out -> void), which stores in `out` the state at the
;;               fraction theta of the step accepted last, and stays good
(struct stepper (state slope try! accept! interpolant)
  #:authentic)
