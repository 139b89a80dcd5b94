#lang racket/base
;; Programs made ready for Taylor coefficients: sums of products of as few quantities as
;; there may be.
;;
;; Of one coefficient a linear combination costs next to nothing, a product a convolution.  So
;; sums, differences and multiples are not quantities of their own but *forms*, Σ c_i x_i + c,
;; until a product or a function needs them whole; x − y and y − x are one quantity with a
;; sign.  Powers of one base are gathered, q √q in a denominator being q^(−3/2).  What remains
;; are *nodes*:
;;
;;     (input i)  (one)  (linear c (id . c_i) ...)  (product id id)  (power id n)
;;     (quotient id id)  (law name id ...)  (partner id)  (still name id ...)
;;     (system id ...)  (component id k)
;;
;; A law is an operation that has equations (generic/operation-equations.rkt); `partner` is
;; the partner of its value.  `still` is any operation on what does not vary.

(require "program.rkt"
         "../generic/operation-equations.rkt")

(provide program->graph (struct-out graph) node-kind node-operands)

;; nodes : vector, by id; outputs : vector of ids; varying : how many inputs are not constant
(struct graph (nodes outputs inputs varying) #:authentic)

(define (node-kind n) (car n))

;; The ids of the nodes it depends on.
(define (node-operands n)
  (case (car n)
    [(input one) '()]
    [(linear) (map car (cddr n))]
    [(power component) (list (cadr n))]
    [(law still) (cddr n)]
    [else (cdr n)]))

;; constant + Σ coefficient node; terms : (id . coefficient) by rising id
(struct form (constant terms) #:authentic)

(define (number-form c) (form c '()))
(define (node-form id [c 1]) (if (eqv? c 0) (number-form 0) (form 0 (list (cons id c)))))
(define (number-form? f) (null? (form-terms f)))

;; ids : node -> id; nodes : id -> node; still : ids of what does not vary; varying : how many
;; inputs may; fail : operation -> does not return
(struct builder (ids nodes still varying fail) #:authentic)

;; The first `varying` inputs are functions of time, the others constants, of the values in the
;; list if there are any.
;; -> graph, or a string that says why there is none
(define (program->graph p varying [constants '()])
  (let/ec return
    (define (fail name) (return (format "the operation `~a` has no Taylor recurrence" name)))
    (define b (builder (make-hash) (make-hasheqv) (make-hasheqv) varying fail))
    (define n (program-inputs p))
    (define places (make-vector (+ n (program-length p)) #f))
    (define uses (count-uses p))
    (define (operand x) (if (place? x) (vector-ref places (place-index x)) (number-form x)))
    (for ([i (in-range n)]) (vector-set! places i (node-form (node! b (list 'input i)))))
    (for ([c (in-list constants)] [i (in-naturals varying)])
      (vector-set! places i (number-form (exact-if-whole c))))
    (for ([i (in-vector (program-instructions p))] [k (in-naturals n)])
      (define (shared? k) (> (vector-ref uses k) 1))
      (vector-set! places k (instruction->form b i k operand shared?)))
    (define outputs
      (for/vector ([o (in-vector (program-outputs p))])
        (define f (operand o))
        (if (form? f) (whole! b f) (fail 'solve))))
    (pruned b outputs n)))

;; Exact numbers are what exponents are told by, and factors that are nothing or 1.
(define (exact-if-whole c)
  (if (and (integer? c) (not (zero? c))) (inexact->exact c) c))

(define (count-uses p)
  (define uses (make-vector (+ (program-inputs p) (program-length p)) 0))
  (define (note! x)
    (when (place? x) (vector-set! uses (place-index x) (+ 1 (vector-ref uses (place-index x))))))
  (for ([i (in-vector (program-instructions p))]) (for-each note! (instruction-operands i)))
  (for ([o (in-vector (program-outputs p))]) (note! o))
  uses)

(define (node! b n)
  (define ids (builder-ids b))
  (or (hash-ref ids n #f)
      (let ([id (hash-count ids)])
        (hash-set! ids n id)
        (hash-set! (builder-nodes b) id n)
        (when (still-node? b n) (hash-set! (builder-still b) id #t))
        id)))

(define (node-of b id) (hash-ref (builder-nodes b) id))

(define (still-node? b n)
  (case (node-kind n)
    [(input) (>= (cadr n) (builder-varying b))]
    [else (andmap (lambda (id) (still? b id)) (node-operands n))]))
(define (still? b id) (hash-ref (builder-still b) id #f))

;; ---------------------------------------------------------------------------
;; Instructions

;; k : the place of the value; shared? : place -> is its value used more than once?
(define (instruction->form b i k operand shared?)
  (define operands (instruction-operands i))
  (define (argument k) (operand (list-ref operands k)))
  (case (instruction-operation i)
    [(add) (kept b (add (argument 0) (argument 1)) (shared? k))]
    [(subtract) (kept b (add (argument 0) (scale -1 (argument 1))) (shared? k))]
    [(negate) (scale -1 (argument 0))]
    [(multiply) (multiply! b (argument 0) (argument 1))]
    [(divide) (divide! b (argument 0) (argument 1) (shared-divisor? (cadr operands) shared?))]
    [(sqrt) (power! b (argument 0) 1/2)]
    [(expt) (expt! b (argument 0) (argument 1))]
    [(solve) (node! b (cons 'system (for/list ([x (in-list operands)]) (whole! b (operand x)))))]
    [(component) (node-form (node! b (list 'component (argument 0) (cadr operands))))]
    [else (apply-law! b (instruction-operation i) (map operand operands))]))

(define (shared-divisor? x shared?) (and (place? x) (shared? (place-index x))))

;; A sum that is used again is a quantity of its own.
(define (kept b f shared?)
  (cond [(and shared? (not (number-form? f)))
         (define-values (c id) (single! b f))
         (node-form id c)]
        [else f]))

(define (add f g)
  (form (+ (form-constant f) (form-constant g))
        (let merge ([xs (form-terms f)] [ys (form-terms g)])
          (cond [(null? xs) ys]
                [(null? ys) xs]
                [(< (caar xs) (caar ys)) (cons (car xs) (merge (cdr xs) ys))]
                [(> (caar xs) (caar ys)) (cons (car ys) (merge xs (cdr ys)))]
                [else
                 (define c (+ (cdar xs) (cdar ys)))
                 (define rest (merge (cdr xs) (cdr ys)))
                 (if (zero? c) rest (cons (cons (caar xs) c) rest))]))))

(define (scale c f)
  (cond [(zero? c) (number-form 0)]
        [else (form (* c (form-constant f))
                    (for/list ([t (in-list (form-terms f))]) (cons (car t) (* c (cdr t)))))]))

;; f as c times a node -> c, id
(define (single! b f)
  (define terms (form-terms f))
  (cond [(null? terms) (values (form-constant f) (node! b '(one)))]
        [(and (null? (cdr terms)) (zero? (form-constant f))) (values (cdar terms) (caar terms))]
        [(< (cdar terms) 0) (values -1 (linear! b (scale -1 f)))]
        [else (values 1 (linear! b f))]))

(define (linear! b f) (node! b (list* 'linear (form-constant f) (form-terms f))))

;; The id of f itself.
(define (whole! b f)
  (define-values (c id) (single! b f))
  (if (= c 1) id (linear! b f)))

;; ---------------------------------------------------------------------------
;; Products and powers

(define (multiply! b f g)
  (cond [(number-form? f) (scale (form-constant f) g)]
        [(number-form? g) (scale (form-constant g) f)]
        [else
         (define-values (c x) (single! b f))
         (define-values (d y) (single! b g))
         (node-form (product! b x y) (* c d))]))

(define (product! b x y)
  (define-values (base m) (base-and-exponent b x))
  (define-values (other n) (base-and-exponent b y))
  (define sum (+ m n))
  (if (and (= base other) (not (whole? sum)) (not (and (whole? m) (whole? n))))
      (node! b (list 'power base sum))
      (node! b (list 'product (min x y) (max x y)))))

(define (whole? n) (exact-nonnegative-integer? n))

(define (base-and-exponent b id)
  (define n (node-of b id))
  (case (node-kind n)
    [(power) (values (cadr n) (caddr n))]
    [(product)
     (define-values (base m) (base-and-exponent b (cadr n)))
     (define-values (other k) (base-and-exponent b (caddr n)))
     (if (and (= base other) (whole? m) (whole? k)) (values base (+ m k)) (values id 1))]
    [else (values id 1)]))

(define (divide! b f g shared?)
  (cond [(number-form? g) (scale (/ 1 (form-constant g)) f)]
        [else
         (define-values (d y) (single! b g))
         (define-values (base n) (base-and-exponent b y))
         ;; what divides several is inverted once
         (cond [(or (number-form? f) shared? (not (whole? n)))
                (scale (/ 1 d) (multiply! b f (node-form (power-node! b base (- n)))))]
               [else
                (define-values (c x) (single! b f))
                (node-form (node! b (list 'quotient x y)) (/ c d))])]))

(define (power-node! b id n)
  (cond [(eqv? n 1) id]
        [else
         (define-values (base m) (base-and-exponent b id))
         (if (and (not (eqv? m 1)) (integer? n) (not (whole? (* m n))))
             (node! b (list 'power base (* m n)))
             (node! b (list 'power id n)))]))

(define (power! b f n)
  (define-values (c id) (single! b f))
  (if (or (> c 0) (integer? n))
      (node-form (power-node! b id n) (if (eqv? c 1) 1 (expt c n)))
      (node-form (power-node! b (linear! b f) n))))

(define (expt! b f g)
  (cond [(and (number-form? g) (rational? (form-constant g)))
         (power! b f (inexact->exact (form-constant g)))]
        [(and (still? b (whole! b f)) (still? b (whole! b g)))
         (node-form (node! b (list 'still 'expt (whole! b f) (whole! b g))))]
        [else
         (define logarithm (apply-law! b 'log (list f)))
         (apply-law! b 'exp (list (multiply! b g logarithm)))]))

;; ---------------------------------------------------------------------------
;; Functions

;; Pairs are one law: cos is the partner of sin.
(define partners (hasheq 'cos 'sin 'cosh 'sinh))

(define (apply-law! b name fs)
  (define ids (for/list ([f (in-list fs)]) (whole! b f)))
  (define main (and (= 1 (length ids)) (hash-ref partners name #f)))
  (node-form
   (cond [(andmap (lambda (id) (still? b id)) ids) (node! b (list* 'still name ids))]
         [main (node! b (list 'partner (node! b (list 'law main (car ids)))))]
         [(equations-of name (length ids)) (node! b (list* 'law name ids))]
         [else ((builder-fail b) name)])))

;; ---------------------------------------------------------------------------
;; What outputs need, numbered anew

(define (pruned b outputs inputs)
  (define count (hash-count (builder-ids b)))
  (define needed (make-vector count #f))
  (for ([id (in-vector outputs)]) (vector-set! needed id #t))
  (for ([i (in-range inputs)]) (vector-set! needed i #t))
  (for ([id (in-range (- count 1) -1 -1)] #:when (vector-ref needed id))
    (for ([x (in-list (node-operands (node-of b id)))]) (vector-set! needed x #t)))
  (define new (make-vector count #f))
  (for/fold ([k 0]) ([id (in-range count)] #:when (vector-ref needed id))
    (vector-set! new id k)
    (+ k 1))
  (graph (for/vector ([id (in-range count)] #:when (vector-ref needed id))
           (renamed (node-of b id) (lambda (x) (vector-ref new x))))
         (for/vector ([id (in-vector outputs)]) (vector-ref new id))
         inputs (builder-varying b)))

(define (renamed n new)
  (case (node-kind n)
    [(input one) n]
    [(linear) (list* 'linear (cadr n)
                     (for/list ([t (in-list (cddr n))]) (cons (new (car t)) (cdr t))))]
    [(power component) (list (car n) (new (cadr n)) (caddr n))]
    [(law still) (list* (car n) (cadr n) (map new (cddr n)))]
    [else (cons (car n) (map new (cdr n)))]))
