#lang racket/base
;; A method of integration, with the right-hand side, as one piece of machine code.
;;
;; Where the rates of a system have machine code, it and the formulas of a method become procedures
;; of whole steps (method-code.rkt), the same to the last bit as the Racket code of the method.
;; Writing them takes what some hundred steps save; so that many are taken in Racket code first, by
;; all integrations of the system together, and the one that is under way goes over.

(require racket/flonum
         "right-hand-side.rkt" "method-code.rkt" "stepper.rkt")

(provide (protect-out as-machine-code))

;; start, of a method that has these formulas (stepper.rkt) -> the same, by machine code where the
;; rates have such and it pays
(define ((as-machine-code formulas start) f! y0)
  (define rates (expandable-machine-rates f!))
  (cond [(not rates) (start f! y0)]
        [(and (machine-rates-pay? rates) (code-for rates formulas y0))
         => (lambda (code) (stepper-from-start code y0 (expandable-parameters f!) formulas))]
        [else (goes-over rates (expandable-parameters f!) formulas (start f! y0))]))

(define (code-for rates formulas y)
  (rates-code rates formulas (lambda () (method-code formulas (flvector-length y) rates))))

;; s : the stepper of Racket code -> one that goes on as machine code when that pays
(define (goes-over rates ps formulas s)
  (define now s)
  (define (go-over!)
    (define code (code-for rates formulas (stepper-state s)))
    (when code
      (define slope (flvector-copy ((stepper-slope s))))
      (set! now (stepper-of code (stepper-state s) slope ps formulas))))
  (define (try! h)
    (when (and (eq? now s) (machine-rates-pay? rates)) (go-over!))
    ((stepper-try! now) h))
  (define (accept!)
    ((stepper-accept! now))
    (when (eq? now s) (step-taken! rates)))
  (stepper (stepper-state s)
           (lambda () ((stepper-slope now)))
           try!
           accept!
           (lambda () ((stepper-interpolant now)))))

;; ---------------------------------------------------------------------------
;; Steps of machine code

(define (stepper-from-start code y0 ps formulas)
  (define begin! (car code))
  (define y (flvector-copy y0))
  (define slope (make-flvector (flvector-length y)))
  (begin! y slope ps)
  (stepper-of code y slope ps formulas))

;; y, slope : the present ones, which steps overwrite; ps : parameters
(define (stepper-of code y slope ps formulas)
  (define-values (try! accept! prepare! value!) (apply values (cdr code)))
  (define n (flvector-length y))
  (define-values (z old) (values (make-flvector n) (make-flvector n)))
  (define room (make-flvector (room-length formulas n)))
  (define step 0.0)
  (define (try h)
    (set! step h)
    (try! h y z slope room ps)
    (if (fl= (flvector-ref room 1) 0.0) 0.0 (flvector-ref room 0)))
  (define (interpolant)
    (define kept (make-flvector (kept-length formulas n)))
    (prepare! step old y slope room kept ps)
    (lambda (theta out) (value! theta kept out)))
  (stepper y (lambda () slope) try (lambda () (accept! old y z slope room ps)) interpolant))
