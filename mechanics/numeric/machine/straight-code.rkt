#lang racket/base
;; Flonum programs as machine code of the processor, without a compiler.
;;
;; An instruction becomes one or two of the processor (instruction-code.rkt), in the order given:
;; the same operations on the same operands as Racket's compiler has them, so that the values are
;; the same to the last bit.  Writing one takes less than a microsecond.

(require racket/list
         "assembler.rkt" "executable.rkt" "instruction-code.rkt" "linear-system-code.rkt"
         "registers.rkt" "straight-instruction.rkt")

(provide machine-instruction? straight-code? write-straight-code! write-procedure!)

;; So many values may be on the stack: 64 KiB, where a system may have cut it to a few hundred for
;; a place.
(define most-values 8192)

;; Can there be a procedure of these instructions, a vector, here?  from : the place of the first
;; one's value, if it is known; without it, long lists are refused
(define (straight-code? instructions [from #f])
  (and (machine?)
       (for/and ([i (in-vector instructions)]) (machine-instruction? i))
       (or (<= (vector-length instructions) most-values)
           (and from (<= (most-alive instructions from) most-values)))))

;; The greatest number of values that are computed and still to be used.
(define (most-alive instructions from)
  (define alive (make-hasheqv))
  (for/fold ([most 0]) ([k (in-range (- (vector-length instructions) 1) -1 -1)])
    (hash-remove! alive k)
    (for* ([o (in-list (instruction-operands (vector-ref instructions k)))]
           [p (in-value (value-number o from))]
           #:when p)
      (hash-set! alive p #t))
    (max most (hash-count alive))))

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

;; Code within a procedure, where rsp is a multiple of 16; registers for flonums and those that a
;; function of C may change do.  from : the place of the first instruction's value; elsewhere :
;; place before that -> memory; stores : list of (operand . memory), where values go, as soon as
;; they are known; pairs? : are all values pairs of flonums, two components of vectors?
(define (write-straight-code! a instructions from elsewhere stores #:pairs? [pairs? #f])
  (define twins (sines-and-cosines instructions from))
  (define s (make-values-at a pairs? (uses-of instructions from twins)
                            (for/fold ([most 0]) ([i (in-vector instructions)])
                              (max most (system-room i)))))
  (define-values (own others)
    (partition (lambda (x) (value-number (car x) from)) stores))
  (define targets
    (for/fold ([targets (hasheqv)]) ([x (in-list own)])
      (hash-update targets (place-index (car x)) (lambda (to) (cons (cdr x) to)) '())))
  (define c (context a s from elsewhere targets twins (solver a)))
  (define reserve! (later-add! a rsp))
  (for ([i (in-vector instructions)] [k (in-naturals from)]) (write-instruction! c i k))
  (for ([x (in-list others)])
    (load! c (car x) 0)
    (store! s (cdr x) 0))
  (define size (* 16 (quotient (+ (stack-bytes s) 15) 16)))
  (reserve! (- size))
  (add! a rsp size))

;; -> (unknowns symmetric? -> label of the procedure that solves such systems)
(define ((solver a) n symmetric?)
  (subroutine! a (list n symmetric?)
               (lambda ()
                 (cond [(not symmetric?) (write-elimination! a n)]
                       [(<= n most-unrolled) (write-definite-solver! a n ((solver a) n #f))]
                       [else (write-Cholesky! a n ((solver a) n #f))]))))

;; elimination : label of the code that solves the system where it is not positive definite
(define (write-definite-solver! a n elimination)
  (define-values (instructions solution margins) (definite-solution n))
  (define (at place) (behind rdi place))
  (write-straight-code! a instructions (* n (+ n 1))
                        (lambda (k) (at (entry-place n k)))
                        (for/list ([x (in-list (append solution margins))] [k (in-naturals)])
                          (cons x (at (* 8 k)))))
  (write-margin-tests! a n elimination)
  (ret! a))

;; place - from -> the instructions that use it
(define (uses-of instructions from twins)
  (define uses (make-vector (vector-length instructions) '()))
  (for ([k (in-range (- (vector-length instructions) 1) -1 -1)]
        #:unless (eq? 'later (hash-ref twins (+ from k) #f)))
    (for* ([o (in-list (remove-duplicates (instruction-operands (vector-ref instructions k))))]
           [p (in-value (value-number o from))]
           #:when p)
      (vector-set! uses p (cons (+ from k) (vector-ref uses p)))))
  uses)

;; place -> place of the other one, for the first of a sine and a cosine; 'later for the second
(define (sines-and-cosines instructions from)
  (define together (C-function 'sincos))
  (define seen (make-hash))
  (for/fold ([twins (hasheqv)])
            ([i (in-vector instructions)] [k (in-naturals from)]
             #:when (and together (memq (instruction-operation i) '(sin cos))))
    (define other (hash-ref seen (cons (other-one (instruction-operation i)) (first-operand i)) #f))
    (hash-set! seen (cons (instruction-operation i) (first-operand i)) k)
    (if (and other (not (hash-ref twins other #f)))
        (hash-set (hash-set twins other k) k 'later)
        twins)))

(define (other-one name) (if (eq? name 'sin) 'cos 'sin))
