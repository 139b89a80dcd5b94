#lang racket/base
;; Programs: an expression graph as a list of flonum operations.
;;
;; A program has inputs, instructions and outputs.  What an instruction or an
;; output refers to is an *operand*: a real number, or the place of an earlier
;; value, counted from the inputs on.  The same operation on the same operands
;; is done once, wherever in the graph it occurs (value numbering), numbers are
;; combined exactly until they meet a value, and what no output needs is left
;; out.

(require "../algebra/operation.rkt" "../algebra/expression.rkt" "../algebra/tape.rkt")

(provide
 ;; the program
 (struct-out program) program-length (struct-out place)
 instruction-operation instruction-operands
 ;; from expressions
 expressions->program)

;; inputs : how many
;; instructions : vector; the value of the k-th has the place inputs + k
;; outputs : vector of operands
(struct program (inputs instructions outputs) #:transparent)

(define (program-length p) (vector-length (program-instructions p)))

;; An input or the value of an instruction.  Transparent: two of one index are
;; the same operand.
(struct place (index) #:transparent)

;; (operation operand ...).  The operations are add, subtract, multiply, divide,
;; negate, functions under their own names, and solve, of a system [A b] given row
;; by row, followed at once by its components: (component system k).
(define (instruction-operation i) (car i))
(define (instruction-operands i) (cdr i))

;; inputs : symbols; es : expressions.  (fail e) is called, not to return, with
;; an expression that has no value: another symbol, an unknown function.
;; as-constant : real -> what stands for it in an instruction
(define (expressions->program inputs es fail #:constants [as-constant real->double-flonum])
  (define b (make-builder (length inputs) as-constant))
  (define leaves
    (for/hasheq ([s (in-list inputs)] [i (in-naturals)]) (values s (place i))))
  (define outputs (translate b (expressions->tape es) leaves fail))
  (prune (program (length inputs) (written b) (list->vector outputs))))

;; ---------------------------------------------------------------------------
;; Building

;; places : instruction -> place; instructions : index -> instruction
(struct builder (inputs as-constant places instructions) #:authentic)

(define (make-builder inputs as-constant)
  (builder inputs as-constant (make-hash) (make-hasheqv)))

;; Numbers that meet a value are constants, so that 2 and 2.0 make one instruction.
(define (do! b operation . operands)
  (write! b (cons operation
                  (for/list ([x (in-list operands)])
                    (if (number? x) ((builder-as-constant b) x) x)))))

(define (write! b instruction)
  (define places (builder-places b))
  (or (hash-ref places instruction #f)
      (let ([p (place (+ (builder-inputs b) (hash-count places)))])
        (hash-set! places instruction p)
        (hash-set! (builder-instructions b) (place-index p) instruction)
        p)))

(define (written b)
  (define n (builder-inputs b))
  (for/vector ([k (in-range (hash-count (builder-places b)))])
    (hash-ref (builder-instructions b) (+ n k))))

;; ---------------------------------------------------------------------------
;; From a graph

;; All expressions on one tape: as operands of a node without meaning.
(define (expressions->tape es) (expression->tape (make-node op:up es)))

(define (translate b t leaves fail)
  (define items (tape-items t))
  (define last (- (vector-length items) 1))
  (define operands (make-vector last #f))
  (define (operands-of k)
    (for/list ([j (in-list (vector-ref (tape-operands t) k))]) (vector-ref operands j)))
  (for ([e (in-vector items 0 last)] [k (in-naturals)])
    (vector-set! operands k
                 (cond [(number? e) (real-or-fail e e fail)]
                       [(symbol? e) (or (hash-ref leaves e #f) (fail e))]
                       [else (apply-head! b e (operands-of k) fail)])))
  (operands-of last))

(define (real-or-fail x e fail) (if (real? x) x (fail e)))

(define (apply-head! b e operands fail)
  (define head (node-head e))
  (cond [(eq? head op:solution) (solve! b operands)]
        [(eq? head op:component) (list-ref (cadr operands) (car operands))]
        [(or (literal-head? head) (not (operation-numeric head))) (fail e)]
        [(andmap number? operands) (combine-numbers head operands e fail)]
        [(eq? head op:+) (fold-operands add! b operands)]
        [(eq? head op:*) (fold-operands multiply! b operands)]
        [(eq? head op:-) (subtract! b (car operands) (cadr operands))]
        [(eq? head op:/) (divide! b (car operands) (cadr operands))]
        [(eq? head op:expt) (power! b (car operands) (cadr operands))]
        [else (apply do! b (operation-name head) operands)]))

(define (combine-numbers head operands e fail)
  (define value
    (with-handlers ([exn:fail:contract? (lambda (x) #f)])
      (apply (operation-numeric head) operands)))
  (real-or-fail value e fail))

(define (fold-operands combine! b operands)
  (for/fold ([result (car operands)]) ([x (in-list (cdr operands))])
    (combine! b result x)))

;; A system of n equations is one instruction; n more read its solution, which
;; has no other place.  -> their places
(define (solve! b operands)
  (define n (count-unknowns (length operands)))
  (define system (apply do! b 'solve operands))
  (for/list ([k (in-range n)]) (write! b (list 'component system k))))

;; n (n + 1) -> n
(define (count-unknowns entries) (integer-sqrt entries))

;; ---------------------------------------------------------------------------
;; Arithmetic.  Signs move outwards, to become subtractions or to meet others.

(define (add! b x y)
  (cond [(and (number? x) (number? y)) (+ x y)]
        [(eqv? x 0) y]
        [(eqv? y 0) x]
        [(negated b y) => (lambda (z) (subtract! b x z))]
        [(negated b x) => (lambda (z) (subtract! b y z))]
        [else (do-in-order! b 'add x y)]))

(define (subtract! b x y)
  (cond [(and (number? x) (number? y)) (- x y)]
        [(eqv? y 0) x]
        [(eqv? x 0) (negate! b y)]
        [(negated b y) => (lambda (z) (add! b x z))]
        [else (do! b 'subtract x y)]))

(define (multiply! b x y)
  (cond [(and (number? x) (number? y)) (* x y)]
        [(or (eqv? x 0) (eqv? y 0)) 0]
        [(number? y) (multiply! b y x)]
        [(and (number? x) (= x 1)) y]
        [(and (number? x) (= x -1)) (negate! b y)]
        [(and (number? x) (scaled b x y)) => (lambda (factors) (apply multiply! b factors))]
        [(negated b x) => (lambda (z) (negate! b (multiply! b z y)))]
        [(negated b y) => (lambda (z) (negate! b (multiply! b x z)))]
        [else (do-in-order! b 'multiply x y)]))

(define (divide! b x y)
  (cond [(eqv? x 0) 0]
        [(eqv? y 1) x]
        [(and (number? y) (not (eqv? y 0))) (multiply! b (/ 1 y) x)]
        [(negated b x) => (lambda (z) (negate! b (divide! b z y)))]
        [(negated b y) => (lambda (z) (negate! b (divide! b x z)))]
        [else (do! b 'divide x y)]))

(define (negate! b x)
  (cond [(number? x) (- x)]
        [(negated b x)]
        [else (do! b 'negate x)]))

;; y if x is the value -y; or #f.
(define (negated b x)
  (define i (and (place? x) (hash-ref (builder-instructions b) (place-index x) #f)))
  (and i
       (eq? (instruction-operation i) 'negate)
       (car (instruction-operands i))))

;; (c z) if x y is c z with a number c; or #f.
(define (scaled b x y)
  (define i (hash-ref (builder-instructions b) (place-index y) #f))
  (define factors (if (and i (eq? (instruction-operation i) 'multiply)) (cdr i) '(#f)))
  (define c (and (number? (car factors)) (* x (car factors))))
  (and c (< 1e-100 (abs c) 1e100) (cons c (cdr factors))))

;; x + y and y + x are one instruction.
(define (do-in-order! b operation x y)
  (if (before? y x) (do! b operation y x) (do! b operation x y)))

(define (before? x y)
  (cond [(number? x) (and (number? y) (< x y))]
        [(number? y) #f]
        [else (< (place-index x) (place-index y))]))

;; ---------------------------------------------------------------------------
;; Powers: whole and half exponents by multiplication and square roots.

(define greatest-unrolled 64)

(define (power! b x n)
  (define half-turns (and (rational? n) (exact? n) (* 2 n)))
  (cond [(or (number? x) (not half-turns) (not (integer? half-turns))
             (> (abs n) greatest-unrolled))
         (do! b 'expt x n)]
        [(negative? n) (divide! b 1 (power! b x (- n)))]
        [(integer? n) (whole-power! b x n)]
        [else (multiply! b (whole-power! b x (quotient half-turns 2)) (do! b 'sqrt x))]))

(define (whole-power! b x n)
  (cond [(eqv? n 0) 1]
        [(eqv? n 1) x]
        [(even? n) (let ([root (whole-power! b x (quotient n 2))]) (multiply! b root root))]
        [else (multiply! b x (whole-power! b x (- n 1)))]))

;; ---------------------------------------------------------------------------
;; What outputs need

(define (prune p)
  (define n (program-inputs p))
  (define instructions (program-instructions p))
  (define needed (make-vector (vector-length instructions) #f))
  (define (need! operand)
    (when (and (place? operand) (>= (place-index operand) n))
      (vector-set! needed (- (place-index operand) n) #t)))
  (for ([o (in-vector (program-outputs p))]) (need! o))
  (for ([k (in-range (- (vector-length instructions) 1) -1 -1)]
        #:when (vector-ref needed k))
    (for-each need! (instruction-operands (vector-ref instructions k))))
  (renumber p needed))

(define (renumber p needed)
  (define n (program-inputs p))
  (define new-index (make-vector (vector-length needed) #f))
  (define kept
    (for/fold ([kept 0]) ([needed? (in-vector needed)] [k (in-naturals)] #:when needed?)
      (vector-set! new-index k (+ n kept))
      (+ kept 1)))
  (define (moved operand)
    (if (and (place? operand) (>= (place-index operand) n))
        (place (vector-ref new-index (- (place-index operand) n)))
        operand))
  (program n
           (for/vector #:length kept
                       ([i (in-vector (program-instructions p))] [k? (in-vector needed)]
                        #:when k?)
             (cons (instruction-operation i) (map moved (instruction-operands i))))
           (for/vector ([o (in-vector (program-outputs p))]) (moved o))))
