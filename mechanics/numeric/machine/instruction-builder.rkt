#lang racket/base
;; A list of instructions being written, each instruction once.

(require "straight-instruction.rkt")

(provide make-builder builder-constant builder-inputs
         do! write! written written-count instruction-of)

;; inputs : how many; constant : real -> its constant in an instruction
;; instructions : index -> instruction; short, long : key of an instruction -> place
;; codes : name or number -> a small number for it
(struct builder (inputs constant instructions short long codes) #:authentic)

(define (make-builder inputs [constant real->double-flonum])
  (builder inputs constant (make-hasheqv) (make-hasheqv) (make-hash) (make-hasheqv)))

;; Numbers that meet a value are constants, so that 2 and 2.0 make one instruction.
(define (do! b operation . operands)
  (write! b (cons operation
                  (for/list ([x (in-list operands)])
                    (if (number? x) ((builder-constant b) x) x)))))

;; -> the place of the instruction's value
(define (write! b instruction)
  (define key (short-key b instruction))
  (define places (if key (builder-short b) (builder-long b)))
  (or (hash-ref places (or key instruction) #f)
      (let* ([instructions (builder-instructions b)]
             [p (place (+ (builder-inputs b) (hash-count instructions)))])
        (hash-set! places (or key instruction) p)
        (hash-set! instructions (place-index p) instruction)
        p)))

;; A fixnum finds an instruction of one or two operands; most have no more.
(define (short-key b i)
  (define operands (cdr i))
  (define x (and (pair? operands) (operand-code b (car operands))))
  (define two? (and x (pair? (cdr operands))))
  (define y (if two? (operand-code b (cadr operands)) 0))
  (and x
       (or (not two?) (null? (cddr operands)))
       (< (max x y) code-limit)
       (+ y (* code-limit (+ x (* code-limit (code-of b (car i))))))))

(define code-limit (expt 2 25))

;; The code of an operand is not 0.
(define (operand-code b x)
  (+ 1 (if (place? x) (* 2 (place-index x)) (+ 1 (* 2 (code-of b x))))))

(define (code-of b x)
  (define codes (builder-codes b))
  (or (hash-ref codes x #f)
      (let ([n (hash-count codes)])
        (hash-set! codes x n)
        n)))

;; The instruction whose value an operand is; #f for a number or an input.
(define (instruction-of b x)
  (and (place? x) (hash-ref (builder-instructions b) (place-index x) #f)))

(define (written-count b) (hash-count (builder-instructions b)))

;; -> vector of all instructions
(define (written b)
  (define n (builder-inputs b))
  (for/vector #:length (written-count b) ([k (in-range (written-count b))])
    (hash-ref (builder-instructions b) (+ n k))))
