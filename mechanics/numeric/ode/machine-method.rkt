#lang racket/base
;; Explicit methods of Runge and Kutta's kind, made of their formulas (method-formulas.rkt).
;;
;; Steps are Racket code at first.  Where the rates of a system have machine code, it and the
;; formulas become procedures of whole steps (method-code.rkt), the same to the last bit.  Writing
;; this code costs as much time as it saves in some hundred steps.  So a system's first steps,
;; counted over all its integrations, are Racket code; then the integration under way switches.

(require racket/flonum
         (only-in racket/list index-of)
         "right-hand-side.rkt" "method-formulas.rkt" "method-code.rkt" "method-memory.rkt"
         "stepper.rkt"
         "vector-formulas.rkt"
         "../record-fields.rkt" "../flvector.rkt")

(provide explicit-method)

;; m : explicit-formulas
(define (explicit-method name order m)
  (adaptive-method name order (lambda (f! y0) (start m f! y0))))

;; y     : the present state; z : the state that the step tried leads to; slope : f(y)
;; old   : the state where the last step began; step : its length
;; w, ks : vectors that the Racket code works in; width : n times the coefficients of an interpolant
;; rates : machine-rates of f!, or #f; machine : machine-steps, or #f while steps are Racket code
(struct integration (m f! n width y z old w ks slope rates [step #:mutable] [machine #:mutable])
  #:authentic)

;; The procedures of method-code.rkt; room : the flvector they work in; parameters : of the rates
(struct machine-steps (rates! try! accept! prepare! value! room parameters) #:authentic)

(define (start m f! y0)
  (define n (flvector-length y0))
  (define y (flvector-copy y0))
  (define-vectors n z old w)
  (define ks (make-vectors (length (explicit-formulas-names m)) n))
  (define slope (if (final-among-stages? m) (make-flvector n) (final-slope m ks)))
  (define r (integration m f! n (kept-length m n) y z old w ks slope
                         (expandable-machine-rates f!) 0.0 #f))
  (go-over! r)
  (take-first-slope! r)
  (make-stepper y (lambda () slope)
                (lambda (h) (try! r h))
                (lambda () (accept! r))
                (lambda () (interpolant r))))

(define (final-slope m ks)
  (vector-ref ks (index-of (explicit-formulas-names m) (explicit-formulas-final m))))

(define (take-first-slope! r)
  (define-fields integration r f! y slope machine)
  (if machine
      ((machine-steps-rates! machine) y slope (machine-steps-parameters machine))
      (f! y slope)))

(define (try! r h)
  (set-integration-step! r h)
  (unless (integration-machine r) (go-over! r))
  (define-fields integration r y z slope machine)
  (if machine
      (machine-try! machine h y z slope)
      (racket-try! r h)))

(define (machine-try! s h y z slope)
  (define-fields machine-steps s try! room parameters)
  (try! h y z slope room parameters)
  (error-in-room room))

(define (racket-try! r h)
  (define-fields integration r m f! n y z w ks slope)
  (flvector-copy! (vector-ref ks 0) slope)
  ((explicit-formulas-stages m) f! n y z w h ks)
  ((explicit-formulas-estimate m) n y z h ks))

(define (accept! r)
  (define-fields integration r y z old slope machine)
  (cond [machine
         (define-fields machine-steps machine accept! room parameters)
         (accept! old y z slope room parameters)]
        [else
         (define-fields integration r m f! ks rates)
         (flvector-copy! old y)
         (flvector-copy! y z)
         (if (final-among-stages? m) (flvector-copy! slope (final-slope m ks)) (f! y slope))
         (when rates (step-taken! rates))]))

(define (interpolant r)
  (define-fields integration r m f! n width y old w ks slope step machine)
  (define kept (make-flvector width))
  (cond [machine
         (define-fields machine-steps machine prepare! value! room parameters)
         (prepare! step old y slope room kept parameters)
         (lambda (theta out) (value! theta room kept out))]
        [else ((explicit-formulas-further m) f! n old #f w step ks)
              ((explicit-formulas-coefficients m) n step ks old y kept)
              (nested-polynomial n kept)]))

;; ---------------------------------------------------------------------------
;; Machine code

;; Steps are machine code from now on, if that pays and there is memory for it.
(define (go-over! r)
  (define-fields integration r m f! n rates)
  (when (and rates (machine-rates-pay? rates))
    (define procedures (rates-code rates m (lambda () (method-code m rates))))
    (when procedures
      (set-integration-machine!
       r (apply machine-steps
                (append procedures (list (make-flvector (room-length m n))
                                         (expandable-parameters f!))))))))
