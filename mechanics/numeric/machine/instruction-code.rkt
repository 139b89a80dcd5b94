#lang racket/base
;; An instruction of straight flonum code as machine code.
;;
;; An operation is done in the register of an operand that nothing else needs, or in another.  What
;; the library of C computes is called, which changes all registers for flonums: values that are
;; needed after it go to the stack.  (larger x y) is y where one is no number.

(require racket/list
         "assembler.rkt" "executable.rkt" "registers.rkt" "straight-instruction.rkt"
         "../../operation/column.rkt")

(provide machine-instruction? (struct-out context) write-instruction! load!)

;; ---------------------------------------------------------------------------
;; What there is code for

(define (machine-instruction? i)
  (case (instruction-operation i)
    [(add subtract multiply divide negate abs sqrt larger) #t]
    [else (calls? i)]))

(define (calls? i) (and (function-of i) #t))

;; -> the function of the library of C, its address; or #f
(define (function-of i)
  (define name
    (hash-ref library-names
              (operation-key (instruction-operation i) (length (instruction-operands i))) #f))
  (and name (C-function name)))

;; Only those that Racket takes from there, too: values are the same to the last bit.
(define-column library-names
  [sin 'sin] [cos 'cos] [tan 'tan] [exp 'exp] [log 'log] [asin 'asin] [acos 'acos] [atan 'atan]
  [expt 'pow]
  [(sqrt abs) (none "the processor has an instruction")]
  [(atan2 sinh cosh tanh asinh acosh atanh erf sgn) (none "our own are rounded otherwise")])

;; ---------------------------------------------------------------------------
;; An instruction

;; s : where values are; from : the place of the first instruction's value; elsewhere : place before
;; that -> memory; targets : place -> where it is to be stored, a list of memory; pairs : place of a
;; sine or cosine -> that of the other one of the same angle, computed with it
(struct context (a s from elsewhere targets pairs) #:authentic)

(define (write-instruction! c i k)
  (define s (context-s c))
  (define name (instruction-operation i))
  (define operands (instruction-operands i))
  (define pair (hash-ref (context-pairs c) k #f))
  (cond [(eq? pair 'later) (void)]
        [else
         (cond [pair (write-sine-and-cosine! c name (car operands) k pair)]
               [(function-of i) => (lambda (f) (write-call! c f operands k))]
               [else (write-operation! c name operands k)])
         (used! s (filter values (map (lambda (o) (own-place c o)) operands)) k)])
  (store-value! c k)
  (used! s (list (own c k)) k))

;; The values of these instructions are numbered from 0 on where they are kept.
(define (own c k) (- k (context-from c)))
(define (own-place c o)
  (and (place? o) (>= (place-index o) (context-from c)) (own c (place-index o))))

;; What an instruction of the processor takes.
(define (operand c o)
  (cond [(own-place c o) => (lambda (p) (location (context-s c) p))]
        [(place? o) ((context-elsewhere c) (place-index o))]
        [else (constant (real->double-flonum o))]))

(define (load! c o r)
  (define there (operand c o))
  (unless (eqv? there r)
    ((if (fixnum? there) movapd! movsd!) (context-a c) r there)))

(define (write-operation! c name operands k)
  (define a (context-a c))
  (define-values (x y) (first-and-second c name operands k))
  (define r (or (last-in-register c x k)
                (register-for! (context-s c) (filter fixnum? (list (operand c x) (operand c y))))))
  (define-syntax-rule (apply! instruction! operand)
    (begin (load! c x r)
           (instruction! a r operand)))
  (case name
    [(add) (apply! addsd! (operand c y))]
    [(subtract) (apply! subsd! (operand c y))]
    [(multiply) (apply! mulsd! (operand c y))]
    [(divide) (apply! divsd! (operand c y))]
    [(larger) (apply! maxsd! (operand c y))]
    [(negate) (apply! xorpd! sign)]
    [(abs) (apply! andpd! all-but-sign)]
    [(sqrt) (sqrtsd! a r (operand c x))])
  (bind-register! (context-s c) (own c k) r))

;; Of a sum or product that operand comes first whose register is free for the result; where there
;; is but one, it is both.
(define (first-and-second c name operands k)
  (define x (first operands))
  (define y (if (pair? (rest operands)) (second operands) x))
  (if (and (memq name '(add multiply))
           (not (last-in-register c x k))
           (last-in-register c y k))
      (values y x)
      (values x y)))

;; The register of a value that the k-th instruction is the last to use, or #f.
(define (last-in-register c o k)
  (define p (own-place c o))
  (and p
       (not (used-after? (context-s c) p k))
       (in-register (context-s c) p)))

;; ---------------------------------------------------------------------------
;; Calls, which change all registers for flonums

(define (write-call! c function operands k)
  (define s (context-s c))
  (keep-on-stack! s k)
  (load-arguments! c operands)
  (call-address! (context-a c) function)
  (forget-registers! s)
  (bind-register! s (own c k) 0))

(define (load-arguments! c operands)
  (define-values (x y) (values (car operands) (and (pair? (cdr operands)) (cadr operands))))
  (cond [(and y (eqv? 0 (operand c y)))
         (define other (if (eqv? 2 (operand c x)) 3 2))
         (movapd! (context-a c) other 0)
         (load! c x 0)
         (movapd! (context-a c) 1 other)]
        [else
         (load! c x 0)
         (when y (load! c y 1))]))

(define (write-sine-and-cosine! c name x k other)
  (define-values (a s) (values (context-a c) (context-s c)))
  (keep-on-stack! s k)
  (load! c x 0)
  (define-values (this that)
    (values (bind-slot! s (own c k)) (bind-slot! s (own c other))))
  (define-values (sine cosine) (if (eq? name 'sin) (values this that) (values that this)))
  (lea! a rdi sine)
  (lea! a rsi cosine)
  (call-address! a (C-function 'sincos))
  (forget-registers! s))

;; ---------------------------------------------------------------------------
;; Storing

(define (store-value! c k)
  (define targets (hash-ref (context-targets c) k '()))
  (unless (null? targets)
    (define r (or (in-register (context-s c) (own c k)) (loaded! c k)))
    (for ([to (in-list targets)]) (store-sd! (context-a c) to r))))

;; -> a register where it is for now
(define (loaded! c k)
  (define r (register-for! (context-s c) '()))
  (movsd! (context-a c) r (location (context-s c) (own c k)))
  r)
