#lang racket/base
;; The machine code of an explicit method with that of a right-hand side.
;;
;; The procedures work as the Racket code of the method does, operation for operation, on vectors
;; whose places method-memory.rkt tells.
;;
;; A step of few components is straight code (step-code.rkt).  Else its stages are loops over
;; vectors, two components at a time, and calls of the rates.

(require racket/list
         "right-hand-side.rkt" "method-formulas.rkt" "method-memory.rkt" "step-code.rkt"
         "../machine/assembler.rkt" "../machine/elements.rkt" "../machine/executable.rkt"
         "../machine/instruction-builder.rkt" "../machine/straight-code.rkt"
         "../machine/straight-instruction.rkt")

(provide (protect-out method-code))

;; A step of at most so many components, with rates of at most so many instructions, is straight
;; code; beyond, that is no faster, or takes too long to write.
(define-values (most-components most-instructions) (values 8 200))

;; m : explicit-formulas; r : machine-rates -> list of procedures, or #f:
;;     y slope parameters                     the first slope
;;     h y z slope room parameters            a step tried: z, the slopes, and the error
;;     old y z slope room parameters          it is accepted: z becomes y, and that old
;;     h old y slope room kept parameters     further slopes, and the coefficients kept
;;     theta room kept out                    the state within the step
(define (method-code m r)
  (define n (machine-rates-inputs r))
  (define instructions (machine-rates-instructions r))
  (define straight?
    (and (<= n most-components) (<= (vector-length instructions) most-instructions)))
  (define a (make-assembly))
  (define rates
    (written-here a (write-procedure! a n (machine-rates-parameters r) instructions
                                      (machine-rates-outputs r))))
  (define (entry h? names write)
    (define l (written-here a (write-procedure-of-vectors! a m n h? names write)))
    (list* (label-place l) (append (if h? '(flonum) '()) (map (lambda (_) 'flvector) names))))
  (define entries
    (list (entry #f '(y slope parameters)
                 (lambda (places) (call-rates! a places 'y 'slope rates)))
          (entry #t '(y z slope room parameters)
                 (lambda (places)
                   (if straight?
                       (write-straight-try! a m r places)
                       (write-try! a n m places rates))))
          (entry #f '(old y z slope room parameters)
                 (lambda (places) (write-accept! a n m places rates)))
          (entry #t '(old y slope room kept parameters)
                 (lambda (places) (write-prepare! a n m places rates)))
          (entry #t '(room kept out) (lambda (places) (write-value! a n m places)))))
  (machine-procedures (assembly->bytes a) entries))

;; Returns a label that is where the code of the form begins.
(define-syntax-rule (written-here a form)
  (let ([l (make-label)])
    (label-here! a l)
    form
    l))

;; ---------------------------------------------------------------------------
;; Straight code

(define (write-straight-try! a m r places)
  (define n (machine-rates-inputs r))
  (define-values (instructions results) (step-code r m))
  (define stored (list* 'z 'k0 (stage-names (explicit-formulas-stages m))))
  (define (input k)
    (cond [(< k n) (component places 'y k)]
          [(< k (+ n n)) (component places 'slope (- k n))]
          [(= k (+ n n)) (hash-ref places 'h)]
          [else (component places 'parameters (- k n n 1))]))
  (write-straight-code! a instructions (+ n n 1 (machine-rates-parameters r)) input
                        (append (stores-of results places '(error divisor))
                                (for*/list ([name (in-list stored)]
                                            [(o i) (in-indexed (hash-ref results name))])
                                  (cons o (component places name i))))))

;; results : name -> vector of operands; names : of numbers
(define (stores-of results places names)
  (for/list ([name (in-list names)])
    (cons (vector-ref (hash-ref results name) 0) (hash-ref places name))))

;; ---------------------------------------------------------------------------
;; Loops

(define (write-try! a n m places rates)
  (emit-elements! a n places '((k0 (at slope i))))
  (write-stages! a n places 'y 'z (explicit-formulas-stages m) rates)
  (emit-elements! a n places (square-statements m))
  (write-error-code! a n places m))

;; Writes the error of a step, from the squares in the room.
(define (write-error-code! a n places m)
  (define squares (square-statements m))
  (define b (make-builder (+ 1 (* n (length squares)))))
  (define results
    (write-error! b n (hasheq 'h (vector (place 0))) m
                  (lambda (s i) (place (+ 1 i (* n (index-of squares s)))))))
  (define (input k)
    (if (= k 0)
        (hash-ref places 'h)
        (component places (first (list-ref squares (quotient (- k 1) n))) (remainder (- k 1) n))))
  (write-straight-code! a (written b) (builder-inputs b) input
                        (stores-of results places '(error divisor))))

(define (write-accept! a n m places rates)
  (emit-elements! a n places '((old (at y i)) (y (at z i))))
  (if (final-among-stages? m)
      (emit-elements! a n places `((slope (at ,(explicit-formulas-final m) i))))
      (call-rates! a places 'y 'slope rates)))

(define (write-prepare! a n m places rates)
  (write-stages! a n places 'old #f (explicit-formulas-further m) rates)
  (emit-elements! a n places (coefficient-formulas m)))

;; The procedure receives θ in the place of h.
(define (write-value! a n m places)
  (define other (hash-ref places 'other))
  (movapd! a 1 (constant 1.0))
  (subpd! a 1 0)
  (store-pd! a other 1)
  (emit-elements! a n places `((out ,(polynomial m 'h 'other)))))

(define (write-stages! a n places from to stages rates)
  (define end (stage-formulas-end stages))
  (for ([s (in-list (stage-formulas-slopes stages))])
    (emit-elements! a n places (list (reaching 'w from (rest s))))
    (call-rates! a places 'w (first s) rates))
  (cond [(pair? end) (emit-elements! a n places (list (reaching to from end)))]
        [end (emit-elements! a n places `((,to (at w i))))]))

;; rates : label of a procedure (numeric/machine/straight-code.rkt)
(define (call-rates! a places from to rates)
  (for ([r (in-list (list rdi rsi rdx))] [name (in-list (list from to 'parameters))])
    (lea! a r (component places name 0)))
  (call! a rates))
