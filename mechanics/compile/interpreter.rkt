#lang racket/base
;; Programs run by an interpreter, at once.
;;
;; What Racket's compiler makes (code.rkt) takes as long to make as some thousand runs of it save:
;; too long for a motion of a hundred steps of a big system.  So the instructions become numbers in
;; an fxvector, four to each: operation, place of the value, places of one or two operands.  All
;; values are in one flvector: inputs, values of instructions, and constants behind them.  A
;; loop goes through it, at some nanoseconds an instruction.
;;
;; Where the processor is known, a stretch of machine code is one instruction
;; (machine-code.rkt), and little is left to interpret.

(require racket/fixnum
         racket/flonum
         racket/unsafe/ops
         "flonum-functions.rkt" "program.rkt"
         "../numeric/linear-algebra/factored-system.rkt" "../numeric/linear-algebra/symmetric-system.rkt")

(provide (protect-out program->interpreter-maker))

;; code      : fxvector; outputs : fxvector of places; inputs : how many
;; start     : flvector of all values, with the constants in their places
;; functions : vector of functions of flonums, for operations without a number of their own
;; systems   : vector of systems; stretches : vector of procedures of the values
(struct bytecode (code outputs inputs start functions systems stretches) #:authentic)

;; n unknowns; entries : fxvector of the places of the rows [A b]; first : place of the first
;; component, after which the others are, as many as `components`
(struct system (n entries components solve!) #:authentic)

;; -> (-> (input output -> void)), as program->maker has it
;; stretches : place -> (procedure . length), instructions that are one
(define (program->interpreter-maker p #:stretches [stretches (hasheqv)])
  (define m (assemble p stretches))
  (lambda () (interpreter-runner m)))

;; ---------------------------------------------------------------------------
;; Assembling

(define operation-numbers
  (hasheq 'multiply 0 'add 1 'subtract 2 'divide 3 'negate 4 'sin 5 'cos 6 'sqrt 7
          'solve 8 'call 9 'stretch 10))

(define (assemble p stretches)
  (define first-constant (+ (program-inputs p) (program-length p)))
  (define constants (make-hasheqv))
  (define (place-of x)
    (if (place? x)
        (place-index x)
        (hash-ref! constants (real->double-flonum x)
                   (lambda () (+ first-constant (hash-count constants))))))
  (define parts (assemble-instructions p place-of stretches))
  (define outputs
    (for/fxvector #:length (vector-length (program-outputs p)) ([x (in-vector (program-outputs p))])
      (place-of x)))
  (define start (make-flvector (+ first-constant (hash-count constants))))
  (for ([(x k) (in-hash constants)]) (flvector-set! start k x))
  (bytecode (assembled-code parts) outputs (program-inputs p) start
           (assembled-functions parts) (assembled-systems parts) (assembled-stretches parts)))

(struct assembled (code functions systems stretches) #:authentic)

(define (assemble-instructions p place-of stretches)
  (define instructions (program-instructions p))
  (define-values (functions systems procedures) (values (growing) (growing) (growing)))
  (define (operation-of i)
    (define name (instruction-operation i))
    (define operands (instruction-operands i))
    (case name
      [(solve)
       (values name (grow! systems (assemble-system instructions i place-of)) 0)]
      [(multiply add subtract divide)
       (values name (place-of (car operands)) (place-of (cadr operands)))]
      [(negate sin cos sqrt) (values name (place-of (car operands)) 0)]
      [else (values 'call (grow! functions (assemble-call name (map place-of operands))) 0)]))
  (define (number name) (hash-ref operation-numbers name))
  (define end (vector-length instructions))
  (define code
    (let loop ([j 0])
      (define i (and (< j end) (vector-ref instructions j)))
      (define k (+ j (program-inputs p)))
      (define stretch (hash-ref stretches k #f))
      (cond [(not i) '()]
            [stretch
             (list* (number 'stretch) k (grow! procedures (car stretch)) 0
                    (loop (+ j (cdr stretch))))]
            [(eq? 'component (instruction-operation i)) (loop (+ j 1))]
            [else
             (define-values (name a b) (operation-of i))
             (list* (number name) k a b (loop (+ j 1)))])))
  (assembled (apply fxvector code) (grown functions) (grown systems) (grown procedures)))

;; values -> the value of a function of what is at those places
(define (assemble-call name places)
  (define f (flonum-body name (length places)))
  (case (length places)
    [(1) (define a (car places))
         (lambda (v) (f (flvector-ref v a)))]
    [(2) (define-values (a b) (values (car places) (cadr places)))
         (lambda (v) (f (flvector-ref v a) (flvector-ref v b)))]
    [else (lambda (v) (apply f (for/list ([k (in-list places)]) (flvector-ref v k))))]))

;; The components follow the system.
(define (assemble-system instructions i place-of)
  (define operands (instruction-operands i))
  (system (system-unknowns i) (apply fxvector (map place-of operands))
          (components-of instructions i)
          (if (symmetric-system? i) solve-symmetric! solve-dense!)))

;; The numbers of the components that there are, in their order.
(define (components-of instructions i)
  (define from (for/first ([x (in-vector instructions)] [k (in-naturals)] #:when (eq? x i)) k))
  (for/fxvector ([x (in-vector instructions (+ from 1))]
                 #:break (not (eq? 'component (instruction-operation x))))
    (cadr (instruction-operands x))))

(define (growing) (box '()))
(define (grow! g x)
  (set-box! g (cons x (unbox g)))
  (- (length (unbox g)) 1))
(define (grown g) (list->vector (reverse (unbox g))))

;; ---------------------------------------------------------------------------
;; Running

(define-syntax-rule (code-at code k) (unsafe-fxvector-ref code k))
(define-syntax-rule (value-at v k) (unsafe-flvector-ref v k))

(define (interpreter-runner m)
  (define values (flvector-copy (bytecode-start m)))
  (define room (for/vector ([s (in-vector (bytecode-systems m))]) (make-room (system-n s))))
  (define inputs (bytecode-inputs m))
  (define outputs (bytecode-outputs m))
  (lambda (input output)
    (let loop ([k 0])
      (when (unsafe-fx< k inputs)
        (unsafe-flvector-set! values k (value-at input k))
        (loop (unsafe-fx+ k 1))))
    (run-code m values room)
    (let loop ([k 0])
      (when (unsafe-fx< k (unsafe-fxvector-length outputs))
        (unsafe-flvector-set! output k (value-at values (code-at outputs k)))
        (loop (unsafe-fx+ k 1))))))

(define (run-code m v room)
  (define code (bytecode-code m))
  (define end (fxvector-length code))
  (let loop ([k 0])
    (when (unsafe-fx< k end)
      (let ([operation (code-at code k)]
            [to (code-at code (unsafe-fx+ k 1))]
            [a (code-at code (unsafe-fx+ k 2))]
            [b (code-at code (unsafe-fx+ k 3))])
        (define-syntax-rule (set x) (unsafe-flvector-set! v to x))
        (define-syntax-rule (is? n) (unsafe-fx= operation n))
        (cond [(is? 0) (set (unsafe-fl* (value-at v a) (value-at v b)))]
              [(is? 1) (set (unsafe-fl+ (value-at v a) (value-at v b)))]
              [(is? 2) (set (unsafe-fl- (value-at v a) (value-at v b)))]
              [(is? 3) (set (unsafe-fl/ (value-at v a) (value-at v b)))]
              [(is? 4) (set (unsafe-fl* -1.0 (value-at v a)))]
              [(is? 5) (set (unsafe-flsin (value-at v a)))]
              [(is? 6) (set (unsafe-flcos (value-at v a)))]
              [(is? 7) (set (unsafe-flsqrt (value-at v a)))]
              [(is? 8) (run-system (unsafe-vector-ref (bytecode-systems m) a)
                                   (unsafe-vector-ref room a) v to)]
              [(is? 9) (set ((unsafe-vector-ref (bytecode-functions m) a) v))]
              [else ((unsafe-vector-ref (bytecode-stretches m) a) v)])
        (loop (unsafe-fx+ k 4))))))

;; ---------------------------------------------------------------------------
;; Systems

(struct room (matrix exchanges right) #:authentic)
(define (make-room n) (room (make-flvector (* n n)) (make-fxvector n) (make-flvector n)))

;; Components are behind the place `to`.
(define (run-system s r v to)
  (define n (system-n s))
  (define-values (A b) (values (room-matrix r) (room-right r)))
  (fill! A b n (system-entries s) v)
  ((system-solve! s) A n (room-exchanges r) b)
  (for ([k (in-fxvector (system-components s))] [place (in-naturals (+ to 1))])
    (flvector-set! v place (flvector-ref b k))))

(define (fill! A b n entries v)
  (let row ([i 0] [k 0])
    (when (unsafe-fx< i n)
      (let ([next (unsafe-fx+ k n)] [shift (unsafe-fx* -1 i)])
        (let column ([k k])
          (if (unsafe-fx< k next)
              (begin
                (unsafe-flvector-set! A (unsafe-fx+ k shift) (value-at v (code-at entries k)))
                (column (unsafe-fx+ k 1)))
              (unsafe-flvector-set! b i (value-at v (code-at entries k)))))
        (row (unsafe-fx+ i 1) (unsafe-fx+ next 1))))))
