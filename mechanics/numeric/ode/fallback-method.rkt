#lang racket/base
;; A method that foresees its steps, helped by another where these collapse.
;;
;; Near a state where a formula is 0/0, as a spherical pendulum's at its pole, the motion may be
;; as smooth as elsewhere; but the last coefficients of its Taylor series are due to
;; rounding, and steps get shorter without end, as before a singularity.  A method that
;; looks at the slope in a few places strides over it.  So where a step is to be much shorter
;; than those before, a longer one is tried by the other method, and taken if its error is
;; tolerated; if not, half of it, down to the step that was foreseen.

(require racket/flonum
         "stepper.rkt"
         "../record-fields.rkt" "../flvector.rkt")

(provide bridged-method)

;; m : a method whose steppers have a `limit`; other : an adaptive method
(define (bridged-method m other)
  (define (start f! y0 tolerance)
    (define s ((method-start m) f! y0 tolerance))
    (define b (bridge s (lambda () (start-stepper other f! (stepper-state s) tolerance))
                      0.0 0.0 #f #f))
    (struct-copy stepper s
                 [try! (lambda (h) (try! b h))]
                 [accept! (lambda () (accept! b))]
                 [interpolant (lambda () ((stepper-interpolant (bridge-used b))))]
                 [limit (lambda () (limit b))]))
  (struct-copy method m [start start]))

;; begin   : -> stepper of the other method from the present state
;; longest : of the last steps, each counting less than the next; tried : the length tried last
;; other   : the other stepper, where the present state is, or #f; used : the one tried last
(struct bridge (main begin [longest #:mutable] [tried #:mutable] [other #:mutable]
                     [used #:mutable])
  #:authentic)

(define collapse (fl/ 1.0 64.0))
(define reach 32.0)
(define forgetting 0.98)

(define (foreseen b) ((stepper-limit (bridge-main b))))

(define (limit b)
  (define-fields bridge b longest)
  (define h (foreseen b))
  (cond [(fl>= h (fl* collapse longest)) h]
        [(fl> h 0.0) (fl* reach h)]
        [(fl> longest 0.0) (fl* 0.5 longest)]
        [else h]))

(define (try! b h)
  (define-fields bridge b main begin)
  (set-bridge-tried! b (flabs h))
  (cond [(fl<= (flabs h) (fl* (fl+ 1.0 1e-6) (foreseen b))) (set-bridge-used! b main)]
        [else (unless (bridge-other b) (set-bridge-other! b (begin)))
              (set-bridge-used! b (bridge-other b))])
  ((stepper-try! (bridge-used b)) h))

(define (accept! b)
  (define-fields bridge b main used longest tried)
  ((stepper-accept! used))
  (unless (eq? used main)
    (flvector-copy! (stepper-state main) (stepper-state used))
    ((stepper-moved! main)))
  (set-bridge-longest! b (flmax tried (fl* forgetting longest)))
  (set-bridge-other! b #f))
