#lang racket/base
;; Methods of integration, as their users see them.
;;
;; A *method* starts a *stepper* for a system y' = f(y); the stepper holds the
;; state of one integration.  It tries a step of some length and says how wrong
;; that may be; the driver (integrate.rkt) accepts it or tries a shorter one.
;; Time, where f depends on it, is a component of y with derivative 1.

(require racket/flonum)

(provide (struct-out method) adaptive-method fixed-step-method
         start-stepper (struct-out stepper) make-stepper
         rates-at)

;; order : the error of a step of length h, as far as it is estimated, is of the
;;         order h^order
;; step  : the length of all steps, or #f if they follow the error
;; start : (f! y0) -> stepper; (f! y dy) stores f(y) in dy
;; asks  : 'jacobian if it solves equations, for which it asks for the derivatives of f
;;         (rates-with-jacobian.rkt); 'expansion if it asks for Taylor coefficients
;;         (right-hand-side.rkt); or #f.  One that asks is told, in `start`, the error tolerated in
;;         a step.
;; alternative : of a method for separable systems alone (symplectic.rkt), a maker of one
;;         for all systems, h -> method; or #f
(struct method (name order step start asks alternative)
  #:authentic
  #:property prop:custom-print-quotable 'never
  #:property prop:custom-write
  (lambda (m port mode)
    (write (if (method-step m) (list (method-name m) (method-step m)) (method-name m)) port)))

(define (adaptive-method name order start #:asks [asks #f]) (method name order #f start asks #f))
(define (fixed-step-method name order step start #:asks [asks #f] #:alternative [alternative #f])
  (method name order step start asks alternative))

;; state       : the flvector of the present state, which steps overwrite
;; slope       : -> the flvector f(state), good until a step is tried
;; try!        : h -> the error of a step of that length, a flonum: the root mean
;;               square over the components, each relative to 1 + |y|; of a method
;;               with a fixed step 0.0, or not a number if the step fails
;; accept!     : -> void; the state tried last becomes the present one
;; interpolant : -> (theta out -> void), which stores in `out` the state at the
;;               fraction theta of the step accepted last, and stays good
;; propose     : the length tried last, its error in units of the tolerance -> the length of the
;;               next step, or of this one tried again if the error exceeds 1; #f if the driver
;;               decides
;; limit       : -> the greatest length of the next step, not a number where there is none; #f if
;;               none is known before the step is tried
;; moved!      : -> void; to be told when the state was changed by another
(struct stepper (state slope try! accept! interpolant propose limit moved!) #:authentic)

(define (make-stepper state slope try! accept! interpolant
                      #:propose [propose #f] #:limit [limit #f] #:moved! [moved! void])
  (stepper state slope try! accept! interpolant propose limit moved!))

;; f(y), in an flvector of its own
(define (rates-at f! y)
  (define rates (make-flvector (flvector-length y)))
  (f! y rates)
  rates)

(define (start-stepper m f! y0 tolerance)
  (if (method-asks m)
      ((method-start m) f! y0 tolerance)
      ((method-start m) f! y0)))
