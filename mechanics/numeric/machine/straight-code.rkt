#lang racket/base
;; Straight flonum code as machine code of the processor, without a compiler.
;;
;; An instruction becomes one or two of the processor (instruction-code.rkt), in the order given:
;; the same operations on the same operands as Racket's compiler has them, so that the values are
;; the same to the last bit.  Writing one takes less than a microsecond.

(require racket/list
         "assembler.rkt" "executable.rkt" "instruction-code.rkt" "registers.rkt"
         "straight-instruction.rkt")

(provide machine-instruction? straight-code? write-straight-code! write-procedure!
         longest-straight)

;; So many instructions may be in a procedure: their values take no more than 64 KiB of the stack,
;; which a system may have cut to a few hundred for a place.
(define longest-straight 8192)

;; Can there be a procedure of these instructions, a vector, here?
(define (straight-code? instructions)
  (and (machine?)
       (<= (vector-length instructions) longest-straight)
       (for/and ([i (in-vector instructions)]) (machine-instruction? i))))

;; ---------------------------------------------------------------------------
;; A procedure

;; Writes a procedure as one of C is, of three addresses: of inputs, of outputs, which do not
;; overlap with these, and of parameters.  The places of the values of instructions are those after
;; the inputs and the parameters, so many; outputs : operands
(define (write-procedure! a inputs parameters instructions outputs)
  (define kept (list rbx r12 r13))      ; leaves rsp a multiple of 16
  (for ([r (in-list kept)] [given (in-list (list rdi rsi rdx))])
    (push! a r)
    (mov! a r given))
  (write-straight-code! a instructions (+ inputs parameters)
                        (lambda (k)
                          (if (< k inputs) (behind rbx (* 8 k)) (behind r13 (* 8 (- k inputs)))))
                        (for/list ([o (in-vector outputs)] [i (in-naturals)])
                          (cons o (behind r12 (* 8 i)))))
  (for ([r (in-list (reverse kept))]) (pop! a r))
  (ret! a))

;; ---------------------------------------------------------------------------
;; Straight code

;; Code within a procedure, where rsp is a multiple of 16; rax, rdi, rsi and registers for flonums
;; change.  stores : list of (operand . memory), where values go, as soon as they are known
(define (write-straight-code! a instructions from elsewhere stores)
  (define pairs (sines-and-cosines instructions from))
  (define s (make-values-at a (uses-of instructions from pairs)))
  (define-values (own others)
    (partition (lambda (x) (and (place? (car x)) (>= (place-index (car x)) from))) stores))
  (define targets
    (for/fold ([targets (hasheqv)]) ([x (in-list own)])
      (hash-update targets (place-index (car x)) (lambda (to) (cons (cdr x) to)) '())))
  (define c (context a s from elsewhere targets pairs))
  (define reserve! (later-add! a rsp))
  (for ([i (in-vector instructions)] [k (in-naturals from)]) (write-instruction! c i k))
  (for ([x (in-list others)])
    (load! c (car x) 0)
    (store-sd! a (cdr x) 0))
  (define size (* 16 (quotient (+ (stack-size s) 1) 2)))
  (reserve! (- size))
  (add! a rsp size))

;; place - from -> the instructions that use it
(define (uses-of instructions from pairs)
  (define uses (make-vector (vector-length instructions) '()))
  (for ([k (in-range (- (vector-length instructions) 1) -1 -1)]
        #:unless (eq? 'later (hash-ref pairs (+ from k) #f)))
    (for ([o (in-list (remove-duplicates (instruction-operands (vector-ref instructions k))))]
          #:when (and (place? o) (>= (place-index o) from)))
      (define p (- (place-index o) from))
      (vector-set! uses p (cons (+ from k) (vector-ref uses p)))))
  uses)

;; place -> place of the other one, for the first of a sine and a cosine; 'later for the second
(define (sines-and-cosines instructions from)
  (define together (C-function 'sincos))
  (define seen (make-hash))
  (for/fold ([pairs (hasheqv)])
            ([i (in-vector instructions)] [k (in-naturals from)]
             #:when (and together (memq (instruction-operation i) '(sin cos))))
    (define other (hash-ref seen (cons (other-one (instruction-operation i)) (first-operand i)) #f))
    (hash-set! seen (cons (instruction-operation i) (first-operand i)) k)
    (if (and other (not (hash-ref pairs other #f)))
        (hash-set (hash-set pairs other k) k 'later)
        pairs)))

(define (other-one name) (if (eq? name 'sin) 'cos 'sin))
