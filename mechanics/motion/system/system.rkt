#lang racket/base
;; A state derivative ready for integration, and the right-hand sides that methods are given.

(require "manifold.rkt"
         "../../numeric/ode/rates-with-jacobian.rkt" "../../numeric/ode/right-hand-side.rkt"
         "../../numeric/ode/stepper.rkt"
         "../../value/shape.rkt")

(provide (struct-out system)
         system-right-hand-side system-method system-state system-size system-expand check-start
         for-one-integration call-for-passage)

;; shape : a state; clock? : is its first scalar the time, with derivative 1?
;; derivative     : state -> state
;; make-slope!    : -> (y dy -> void), for one integration
;; make-jacobian! : -> (y J -> void), for one integration, or #f if there are differences only;
;;                  compiled when first asked for
;; operations     : how many flonum operations its rates take, or #f
;; expander       : -> expander (numeric/Taylor/expansion.rkt), or a string, the reason why there
;;                  is none; made when first asked for
;; machine        : -> machine-rates (numeric/ode/right-hand-side.rkt), or #f;
;;                  made when first asked for
;; parameters     : their values in these, an flvector
;; corrections    : those of the manifold that motions are on (manifold.rkt), or #f
;; spare          : a box of a right-hand side that no integration uses any more, or #f
;; separable      : a box: is it known to be separable (separable.rkt)?
;; own            : its right-hand side in one integration, or #f
(struct system (shape clock? derivative make-slope! make-jacobian! operations expander machine
                parameters corrections spare separable own)
  #:authentic)

;; The right-hand side that the method integrates.
(define (system-right-hand-side s m)
  (cond [(eq? 'jacobian (method-asks m))
         (define slope! ((system-make-slope! s)))
         (define n (system-size s))
         (differentiated slope!
                         (when-asked
                          (lambda () (or ((system-make-jacobian! s)) (differences slope! n)))))]
        [else (or (system-own s) (new-right-hand-side s))]))

(define (new-right-hand-side s)
  (expandable ((system-make-slope! s)) (system-expand s) ((system-machine s))
              (system-parameters s)))

;; The expander of the motions' Taylor coefficients, or a string, the reason why there is none.
(define (system-expand s) ((system-expander s)))

;; The method, with steps that end on the manifold of the system, if there is one.
(define (system-method s m) (method-on m (system-corrections s) (system-size s)))

;; s for one integration: a method that was tried keeps the coefficients that it computed.
(define (for-one-integration s) (with-own s (new-right-hand-side s)))

;; (use s'), s' being s for one integration of which no interpolant is kept: its right-hand side,
;; which takes longer to make than a few steps, is kept for the next integration.
(define (call-for-passage s use)
  (define spare (system-spare s))
  (define f! (or (take-spare! spare) (new-right-hand-side s)))
  (begin0 (use (with-own s f!))
          (rest! f!)
          (set-box! spare f!)))

;; For one thread alone; others make their own.
(define (take-spare! spare)
  (define f! (unbox spare))
  (and f! (box-cas! spare f! #f) f!))

(define (with-own s f!)
  (struct-copy system s [own f!]))

;; Refuses a start that is not on the manifold of the system.
(define (check-start who s y) (check-on who (system-corrections s) y (system-state s y)))

(define (system-state s y) (flvector->structure (system-shape s) y))

(define (system-size s) (shape-length (system-shape s)))
