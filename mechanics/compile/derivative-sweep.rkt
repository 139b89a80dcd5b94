#lang racket/base
;; Programs differentiated: from a list of instructions to a longer one.
;;
;; *Backwards*: each value has an adjoint, the derivative of the result by it; from the last
;; instruction to the first, its adjoint times its partial derivatives is added to those of
;; its operands.  One sweep gives the derivatives by all inputs, for a few times the
;; operations of the program.  *Forwards*: each value has a tangent, its derivative in one
;; direction; values that it does not change are passed over, so that sweeps in the direction
;; of each input do for derivatives of which most are 0.
;;
;; Sums and products are written here; the partial derivatives of other operations are those
;; of the generic arithmetic.  The solution of A x = b has the adjoint λ of b, where Aᵀ λ is
;; the adjoint of x, and −λ xᵀ is that of A; its tangent is that of A x' = b' − A' x.

(require racket/list
         "program-builder.rkt" "program.rkt" "shorter-program.rkt"
         "../generic/elementary.rkt" "../generic/kind.rkt")

(provide reload sweep-back! derivative-along last-dependent differentiable?
         program-with-gradient tangent-program jacobian-program)

;; p with all components of its systems, none of which can be had later; and a builder that holds
;; it, in the same places.
(define (reload p)
  (define inputs (program-inputs p))
  (define b (make-builder inputs real->double-flonum))
  (define operands (make-vector (+ inputs (program-length p)) #f))
  (define (moved x) (if (place? x) (vector-ref operands (place-index x)) x))
  (for ([k (in-range inputs)]) (vector-set! operands k (place k)))
  (for ([i (in-vector (program-instructions p))] [k (in-naturals inputs)])
    (vector-set! operands k (rewrite! b i moved)))
  (values b (program inputs (written b)
                     (for/vector ([o (in-vector (program-outputs p))]) (moved o)))))

;; -> the operand of the instruction's value; of a system those of its components
(define (rewrite! b i moved)
  (case (instruction-operation i)
    [(solve) (solve! b (map moved (instruction-operands i)))]
    [(component) (list-ref (moved (first-operand i)) (second-operand i))]
    [else (write! b (moved-instruction i moved))]))

;; Are there derivatives of all its operations?
(define (differentiable? p)
  (for/and ([i (in-vector (program-instructions p))])
    (or (memq (instruction-operation i) written-here) (and (record-of i) #t))))

(define written-here '(add subtract multiply divide negate sqrt wrapped solve component))

;; p of one output -> a program of its value and its derivatives by all inputs; or #f
(define (program-with-gradient p)
  (define (with-gradient)
    (define-values (b q) (reload p))
    (define value (vector-ref (program-outputs q) 0))
    (define adjoints (sweep-back! b q value))
    (define slopes (for/list ([a (in-vector adjoints 0 (program-inputs q))]) a))
    (builder->program b (program-inputs q) (cons value slopes)))
  (and (differentiable? p) (with-gradient)))

;; -> program whose values are the derivatives of the first value by all inputs, then those of
;; the second one ...
(define (tangent-program p)
  (define n (program-inputs p))
  (define-values (b columns) (differentiate p n +inf.0))
  (shorter-program (builder->program b n (append* (apply map list columns)))))

;; -> program whose values are the derivatives of all values by the first of the first n inputs,
;; then those by the second one ..., which is how implicit methods take them; or #f where not all
;; operations have derivatives, or where it would take more operations than `most`
(define (jacobian-program p n #:most [most +inf.0])
  (define-values (b columns) (if (differentiable? p) (differentiate p n most) (values #f #f)))
  (and b
       (<= (written-count b) most)
       (shorter-program (builder->program b (program-inputs p) (append* columns)))))

;; -> a builder that holds them, and for each of the first n inputs the derivatives of the outputs
;; by it, a list of operands; no more are written than `most` operations and those by one input
(define (differentiate p n most)
  (define-values (b q) (reload p))
  (define columns
    (for/list ([j (in-range n)] #:break (> (written-count b) most))
      (define along (derivative-along b q (lambda (k) (if (= k j) 1 0))))
      (for/list ([o (in-vector (program-outputs q))]) (along o))))
  (values b columns))

;; ---------------------------------------------------------------------------
;; Backwards

;; b, p : reloaded -> place index -> the derivative of the operand by it, a vector
(define (sweep-back! b p result)
  (define first (program-inputs p))
  (define adjoints (make-vector (+ first (program-length p)) 0))
  (define (add-to! x term)
    (when (place? x)
      (define k (place-index x))
      (vector-set! adjoints k (add! b (vector-ref adjoints k) term))))
  (define of-solutions (make-hasheqv))
  (add-to! result 1)
  (for ([k (in-range (- (vector-length adjoints) 1) (- first 1) -1)])
    (define i (vector-ref (program-instructions p) (- k first)))
    (define a (vector-ref adjoints k))
    (cond [(eq? 'solve (instruction-operation i))
           (define parts (hash-ref of-solutions k #f))
           (when parts (sweep-system-back! b i k parts add-to!))]
          [(eqv? a 0) (void)]
          [(eq? 'component (instruction-operation i))
           (define system (place-index (first-operand i)))
           (hash-update! of-solutions system
                         (lambda (parts) (cons (cons (second-operand i) a) parts)) '())]
          [else (add-shares! b i (place k) a add-to!)]))
  adjoints)

;; value : the place of its value, whose adjoint is a
(define (add-shares! b i value a add-to!)
  (define x (first-operand i))
  (case (instruction-operation i)
    [(divide)
     (define share (divide! b a (second-operand i)))
     (add-to! x share)
     (add-to! (second-operand i) (negate! b (multiply! b share value)))]
    [(sqrt) (add-to! x (divide! b (multiply! b 1/2 a) value))]
    [else
     (for ([operand (in-list (instruction-operands i))] [k (in-naturals)] #:when (place? operand))
       (add-to! operand (multiply! b a (partial! b i k value))))]))

;; parts : ((component . adjoint) ...)
(define (sweep-system-back! b i k parts add-to!)
  (define n (system-unknowns i))
  (define entry (entries-of i))
  (define adjoints
    (solve-with! b n (lambda (row column) (entry column row))
                 (lambda (row) (cond [(assv row parts) => cdr] [else 0]))))
  (define solution (components! b n k))
  (for ([row (in-range n)] [λ (in-list adjoints)])
    (add-to! (entry row n) λ)
    (for ([column (in-range n)] [x (in-list solution)] #:when (place? (entry row column)))
      (add-to! (entry row column) (negate! b (multiply! b λ x))))))

;; (row column -> operand), with the right-hand side in the last column
(define (entries-of i)
  (define operands (list->vector (instruction-operands i)))
  (define width (+ 1 (system-unknowns i)))
  (lambda (row column) (vector-ref operands (+ (* row width) column))))

;; The components of the system at the place k
(define (components! b n k)
  (for/list ([column (in-range n)]) (write! b (list 'component (place k) column))))

;; ---------------------------------------------------------------------------
;; Forwards

;; b, p : reloaded; direction : input index -> operand; wanted? : place index -> does the derivative
;; of the value there matter?  -> (operand ↦ its derivative in that direction)
(define (derivative-along b p direction [wanted? (lambda (k) #t)])
  (define inputs (program-inputs p))
  (define tangents (make-vector (+ inputs (program-length p)) 0))
  (define (tangent x) (if (place? x) (vector-ref tangents (place-index x)) 0))
  (for ([k (in-range inputs)]) (vector-set! tangents k (direction k)))
  (for ([i (in-vector (program-instructions p))] [k (in-naturals inputs)])
    (unless (or (for/and ([x (in-list (instruction-operands i))]) (eqv? 0 (tangent x)))
                (not (wanted? k)))
      (vector-set! tangents k (next-tangent b i k tangent))))
  tangent)

;; results : vector of operands -> place index -> the last of those that depend on it, or -1
(define (last-dependent p results)
  (define first (program-inputs p))
  (define last (make-vector (+ first (program-length p)) -1))
  (define (reach! x n)
    (when (place? x)
      (define k (place-index x))
      (vector-set! last k (max n (vector-ref last k)))))
  (for ([x (in-vector results)] [n (in-naturals)]) (reach! x n))
  (for ([k (in-range (- (vector-length last) 1) (- first 1) -1)])
    (define n (vector-ref last k))
    (for ([x (in-list (instruction-operands (vector-ref (program-instructions p) (- k first))))])
      (reach! x n)))
  last)

;; k : the place of the value; of a system the vector of its components' tangents
(define (next-tangent b i k tangent)
  (define value (place k))
  (define x (tangent (first-operand i)))
  (case (instruction-operation i)
    [(divide)
     (define y (second-operand i))
     (divide! b (subtract! b x (multiply! b value (tangent y))) y)]
    [(sqrt) (divide! b (multiply! b 1/2 x) value)]
    [(solve) (system-tangent b i k tangent)]
    [(component) (vector-ref x (second-operand i))]
    [else
     (for/fold ([sum 0]) ([operand (in-list (instruction-operands i))] [k (in-naturals)])
       (define d (tangent operand))
       (if (eqv? d 0) sum (add! b sum (multiply! b d (partial! b i k value)))))]))

;; Another system with the same matrix
(define (system-tangent b i k tangent)
  (define n (system-unknowns i))
  (define entry (entries-of i))
  (define solution (components! b n k))
  (define right
    (for/list ([row (in-range n)])
      (for/fold ([sum (tangent (entry row n))]) ([x (in-list solution)] [column (in-naturals)])
        (subtract! b sum (multiply! b (tangent (entry row column)) x)))))
  (list->vector (solve-with! b n entry (lambda (row) (list-ref right row)))))

;; ---------------------------------------------------------------------------
;; Partial derivatives

;; Of the operation by operand k; of quotients and roots others have fewer operations.
(define (partial! b i k value)
  (case (instruction-operation i)
    [(add) 1]
    [(subtract) (if (= k 0) 1 -1)]
    [(multiply) (list-ref (instruction-operands i) (- 1 k))]
    [(negate) -1]
    [(wrapped) (if (= k 0) 1 0)]
    [else (general-partial! b i k value)]))

(define (general-partial! b i k value)
  (define operands (instruction-operands i))
  (define names (for/list ([x (in-list operands)] [name (in-list '(x y))]) (if (place? x) name x)))
  (define form (apply (list-ref (generic-op-partials (record-of i)) k) (append names '(value))))
  (write-expression! b form (hasheq 'x (car operands) 'y (last operands) 'value value)))

(define (record-of i)
  (elementary-operation (instruction-operation i) (length (instruction-operands i))))
