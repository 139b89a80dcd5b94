#lang racket/base
;; An instruction of a flonum program as machine code.
;;
;; An operation is done in the register of an operand that nothing else needs, or in another.  The
;; library of C and the solvers of systems are called, which changes all registers for flonums:
;; values that are needed after the call go to the stack.

(require racket/list
         "assembler.rkt" "executable.rkt" "linear-system-code.rkt" "registers.rkt"
         "straight-instruction.rkt"
         "../../operation/operation-column.rkt")

(provide machine-instruction? operation-C-function C-operation?
         (struct-out context) write-instruction! load!)

;; Is there code for it?
(define (machine-instruction? i)
  (case (instruction-operation i)
    [(component solve) #t]
    [else (and (or (processor-operation (instruction-operation i)) (C-function-of i)) #t)]))

;; name -> the processor's instructions for one flonum and for a pair; or #f
(define (processor-operation name) (hash-ref processor-operations name #f))

(define processor-operations
  (hasheq 'add (cons addsd! addpd!) 'subtract (cons subsd! subpd!) 'multiply (cons mulsd! mulpd!)
          'divide (cons divsd! divpd!) 'larger (cons maxsd! maxpd!) 'sqrt (cons sqrtsd! sqrtpd!)
          'negate (cons xorpd! xorpd!) 'abs (cons andpd! andpd!)))

(define (C-function-of i)
  (operation-C-function (instruction-operation i) (length (instruction-operands i))))

;; -> the address of the function of so many arguments in the library of C; or #f
(define (operation-C-function operation arguments)
  (define name (C-name operation arguments))
  (and name (C-function name)))

;; Is there one, in any such library?
(define (C-operation? operation arguments) (and (C-name operation arguments) #t))

(define (C-name operation arguments)
  (hash-ref library-names (operation-key operation arguments) #f))

;; The functions that Racket takes from there, too: values are the same to the last bit.
(define-column library-names
  [sin 'sin] [cos 'cos] [tan 'tan] [exp 'exp] [log 'log] [asin 'asin] [acos 'acos] [atan 'atan]
  [atan2 'atan2] [expt 'pow]
  [(sqrt abs) (none "the processor has an instruction")]
  [(sinh cosh tanh asinh acosh atanh erf sgn) (none "our own are rounded otherwise")])

;; ---------------------------------------------------------------------------
;; An instruction

;; s : where values are; from : the place of the first instruction's value; elsewhere : place before
;; that -> memory; targets : place -> where it is to be stored, a list of memory; twins : place of a
;; sine or cosine -> that of the other one of the same angle, computed with it; solver : how many
;; unknowns, is the system symmetric? -> label of the procedure that solves it
(struct context (a s from elsewhere targets twins solver) #:authentic)

(define (write-instruction! c i k)
  (define s (context-s c))
  (define name (instruction-operation i))
  (define operands (instruction-operands i))
  (define twin (hash-ref (context-twins c) k #f))
  (unless (eq? twin 'later)
    (cond [twin (write-sine-and-cosine! c name (car operands) k twin)]
          [(eq? name 'solve) (write-solve! c i k)]
          [(eq? name 'component) (write-component! c (second-operand i) k)]
          [(processor-operation name) => (lambda (o) (write-operation! c name o operands k))]
          [else (write-call! c (C-function-of i) operands k)])
    (used! s (filter-map (lambda (o) (own-place c o)) operands) k))
  (store-value! c k)
  (used! s (list (own c k)) k))

;; The values of these instructions are numbered from 0 on where they are kept.
(define (own c k) (- k (context-from c)))
(define (own-place c o) (value-number o (context-from c)))

;; -> a register, memory or a constant
(define (operand c o)
  (cond [(own-place c o) => (lambda (p) (location (context-s c) p))]
        [(place? o) ((context-elsewhere c) (place-index o))]
        [else (constant (real->double-flonum o))]))

(define (load! c o r)
  (define there (operand c o))
  (unless (eqv? there r) (move! (context-s c) r there)))

;; The second operand, from where the processor takes it: a pair in memory, which may begin
;; anywhere, is loaded into a register first.
(define (taken c o but)
  (define s (context-s c))
  (define there (operand c o))
  (cond [(and (values-at-pairs? s) (memory? there))
         (define r (register-for! s but))
         (move! s r there)
         r]
        [else there]))

(define (write-operation! c name instructions operands k)
  (define-values (a s) (values (context-a c) (context-s c)))
  (define apply! ((if (values-at-pairs? s) cdr car) instructions))
  (define-values (x y) (first-and-second c name operands k))
  (define r (or (last-in-register c x k)
                (register-for! s (filter fixnum? (list (operand c x) (operand c y))))))
  (load! c x r)
  (apply! a r (case name
                [(negate) sign]
                [(abs) all-but-sign]
                [(sqrt) r]
                [else (if (equal? x y) r (taken c y (list r)))]))
  (bind-register! s (own c k) r))

;; Returns two operands in the order in which the processor takes them.  In a sum or product the
;; first one is that whose register is free for the result, or that cannot be the second.  A single
;; operand is both.
(define (first-and-second c name operands k)
  (define x (first operands))
  (define y (if (pair? (rest operands)) (second operands) x))
  (define (must-load? o) (and (values-at-pairs? (context-s c)) (memory? (operand c o))))
  (if (and (memq name '(add multiply))
           (not (last-in-register c x k))
           (or (last-in-register c y k) (and (must-load? y) (not (must-load? x)))))
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

;; A system's room begins where the stack does.
(define (write-solve! c i k)
  (define-values (a s) (values (context-a c) (context-s c)))
  (define n (system-unknowns i))
  (for ([o (in-list (instruction-operands i))] [j (in-naturals)])
    (store-sd! a (behind rsp (entry-place n j)) (in-some-register c o)))
  (keep-on-stack! s k)
  (lea! a rdi (behind rsp 0))
  (call! a ((context-solver c) n (symmetric-system? i)))
  (forget-registers! s))

(define (write-component! c j k)
  (define s (context-s c))
  (define r (register-for! s '()))
  (move! s r (behind rsp (solution-place j)))
  (bind-register! s (own c k) r))

;; -> the register that holds the operand, or one where it is for now
(define (in-some-register c o)
  (define there (operand c o))
  (cond [(fixnum? there) there]
        [else (define r (register-for! (context-s c) '()))
              (load! c o r)
              r]))

;; ---------------------------------------------------------------------------
;; Storing

(define (store-value! c k)
  (define targets (hash-ref (context-targets c) k '()))
  (unless (null? targets)
    (define r (in-some-register c (place k)))
    (for ([to (in-list targets)]) (store! (context-s c) to r))))
