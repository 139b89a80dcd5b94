#lang racket/base
;; The machine code of a method with that of a right-hand side.
;;
;; The formulas of the method (method-formulas.rkt) become procedures: the first slope; a step tried, and
;; accepted; what an interpolant needs, and its value.  They do what the Racket code of the method
;; does, operation for operation, on vectors whose places method-memory.rkt tells.
;;
;; A step of few components is straight code (step-code.rkt); else its stages are loops over vectors
;; and calls of the rates (loop-code.rkt).

(require "right-hand-side.rkt" "loop-code.rkt" "method-memory.rkt" "step-code.rkt"
         "../machine/assembler.rkt" "../machine/elements.rkt" "../machine/executable.rkt"
         "../machine/straight-code.rkt")

(provide (struct-out method-formulas) room-length kept-length
         (protect-out method-code))

;; Of a step with more components, or rates of more instructions, straight code is no faster or
;; takes too long to write.
(define-values (most-components most-instructions) (values 8 200))

;; rates : machine-rates; -> list of procedures, or #f
(define (method-code formulas n m)
  (define instructions (machine-rates-instructions m))
  (define straight?
    (and (<= n most-components) (<= (vector-length instructions) most-instructions)))
  (define a (make-assembly))
  (define rates
    (written a (lambda ()
                 (write-procedure! a n (machine-rates-parameters m) instructions
                                   (machine-rates-outputs m)))))
  (define-syntax-rule (entry (type ...) form)
    (list (label-place (written a (lambda () form))) type ...))
  (define-values (v x) (values 'flvector 'flonum))
  (define entries
    (list (entry (v v v) (write-begin! a n formulas rates))
          (entry (x v v v v v)
                 (if straight?
                     (write-straight-try! a n formulas m)
                     (write-try! a n formulas rates)))
          (entry (v v v v v v) (write-accept! a n formulas rates))
          (entry (x v v v v v v) (write-prepare! a n formulas rates))
          (entry (x v v) (write-value! a n formulas))))
  (machine-procedures (assembly->bytes a) entries))

;; -> the label of what is written
(define (written a write)
  (define l (make-label))
  (label-here! a l)
  (write)
  l)

;; ---------------------------------------------------------------------------
;; Procedures: what each is given, in this order, h before the flvectors

;; y slope parameters
(define (write-begin! a n formulas rates)
  (with-vectors a '(y slope parameters)
    (lambda (places) (call-rates! a places 'y 'slope rates))))

;; h y z slope room parameters: z, the slopes, and the error
(define (write-try! a n formulas rates)
  (define slope (slope-name formulas))
  (with-vectors a (list 'y 'z slope 'room 'parameters)
    (lambda (given)
      (define places (with-room formulas n given))
      (emit-elements! a n places `((store k0 (at ,slope i))))
      (write-stages! a n places 'y 'z (method-formulas-slopes formulas) rates)
      (write-error! a n places (method-formulas-error formulas)))))

;; The same as straight code; m : machine-rates
(define (write-straight-try! a n formulas m)
  (define slope (slope-name formulas))
  (define parameters (machine-rates-parameters m))
  (define-values (instructions results)
    (step-code m (method-formulas-slopes formulas) (method-formulas-error formulas)))
  (with-vectors a (list 'y 'z slope 'room 'parameters)
    (lambda (given)
      (define places (with-room formulas n given))
      (define (input k)
        (cond [(< k n) (component places 'y k)]
              [(< k (+ n n)) (component places slope (- k n))]
              [(= k (+ n n)) (length-in-room places)]
              [else (component places 'parameters (- k n n 1))]))
      (store-sd! a (length-in-room places) 0)
      (write-straight-code! a instructions (+ n n 1 parameters) input
                            (stores-of results places)))))

;; results : name -> operands, as step-code.rkt says; those that have a place in memory are stored
(define (stores-of results places)
  (for*/list ([(name operands) (in-hash results)]
              #:when (and (hash-ref places name #f) (not (eq? name 'y)))
              [(o i) (in-parallel operands (in-naturals))])
    (cons o (component places name i))))

;; old y z slope room parameters: y becomes z, and old what it was
(define (write-accept! a n formulas rates)
  (define slope (slope-name formulas))
  (with-vectors a (list 'old 'y 'z slope 'room 'parameters)
    (lambda (given)
      (define places (with-room formulas n given))
      (emit-elements! a n places '((store old (at y i)) (store y (at z i))))
      (if (last-taken? formulas)
          (emit-elements! a n places `((store slope (at ,(method-formulas-last formulas) i))))
          (call-rates! a places 'y slope rates)))))

;; h old y slope room kept parameters: further slopes, and the coefficients
(define (write-prepare! a n formulas rates)
  (with-vectors a (list 'old 'y (slope-name formulas) 'room 'kept 'parameters)
    (lambda (given)
      (define base (vector-at-base (hash-ref given 'kept)))
      (define places (with-coefficients formulas n (with-room formulas n given) base))
      (write-stages! a n places 'old #f (method-formulas-further formulas) rates)
      (write-coefficients! a n places (method-formulas-coefficients formulas)))))
