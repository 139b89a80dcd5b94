#lang racket/base
;; Programs differentiated: from a list of instructions to a longer one.
;;
;; *Backwards*: each value has an adjoint, the derivative of the result by it; from the last
;; instruction to the first, its adjoint times its partial derivatives is added to those of
;; its operands.  One sweep gives the derivatives by all inputs, for a few times the
;; operations of the program.  *Forwards*: each value has a tangent, its derivative in one
;; direction; what does not depend on the direction is passed over.
;;
;; Sums and products are written here; the partial derivatives of other operations are those
;; of the generic arithmetic.  The solution of A x = b has the adjoint λ of b, where Aᵀ λ is
;; the adjoint of x, and −λ xᵀ is that of A.

(require racket/list
         "program-builder.rkt" "program.rkt"
         "../generic/elementary.rkt" "../generic/kind.rkt")

(provide reload sweep-back! sweep-forward! next-tangent last-dependent
         differentiable? has-derivatives? program-with-gradient)

;; A builder that holds the instructions of p, in the places that they have there.
(define (reload p)
  (define b (make-builder (program-inputs p) real->double-flonum))
  (for ([i (in-vector (program-instructions p))]) (write! b i))
  b)

;; Are there derivatives of all its operations?
(define (has-derivatives? p)
  (for/and ([i (in-vector (program-instructions p))])
    (or (memq (instruction-operation i) written-here) (and (record-of i) #t))))

;; Can it be swept?  A system with all its components only: none can be had of it later.
(define (differentiable? p)
  (define components (for/sum ([i (in-vector (program-instructions p))]) (if (component? i) 1 0)))
  (define unknowns
    (for/sum ([i (in-vector (program-instructions p))])
      (define name (instruction-operation i))
      (if (eq? name 'solve) (system-unknowns i) 0)))
  (and (= components unknowns) (has-derivatives? p)))

(define written-here '(add subtract multiply divide negate sqrt wrapped solve component))

(define (component? i) (eq? 'component (instruction-operation i)))

;; p of one output -> a program of its value and its derivatives by all inputs; or #f
(define (program-with-gradient p)
  (and (differentiable? p)
       (let* ([b (reload p)]
              [value (vector-ref (program-outputs p) 0)]
              [adjoints (sweep-back! b p value)])
         (builder->program b (program-inputs p)
                           (cons value (for/list ([a (in-vector adjoints 0 (program-inputs p))])
                                         a))))))

;; ---------------------------------------------------------------------------
;; Backwards

;; b : a builder reloaded with p -> place index -> the derivative of the operand by it, a vector
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
          [(component? i)
           (define system (place-index (first-operand i)))
           (hash-update! of-solutions system
                         (lambda (parts) (cons (cons (second-operand i) a) parts)) '())]
          [else (add-shares! b i (place k) a add-to!)]))
  adjoints)

;; value : the place of its value, whose adjoint is a
(define (add-shares! b i value a add-to!)
  (define x (first-operand i))
  (define (y) (second-operand i))
  (case (instruction-operation i)
    [(add) (add-to! x a) (add-to! (y) a)]
    [(subtract) (add-to! x a) (add-to! (y) (negate! b a))]
    [(multiply) (add-to! x (multiply! b a (y))) (add-to! (y) (multiply! b a x))]
    [(divide)
     (define share (divide! b a (y)))
     (add-to! x share)
     (add-to! (y) (negate! b (multiply! b share value)))]
    [(negate) (add-to! x (negate! b a))]
    [(sqrt) (add-to! x (divide! b (multiply! b 1/2 a) value))]
    [(wrapped) (add-to! x a)]
    [else
     (for ([operand (in-list (instruction-operands i))] [k (in-naturals)] #:when (place? operand))
       (add-to! operand (multiply! b a (partial! b i k value))))]))

;; parts : ((component . adjoint) ...)
(define (sweep-system-back! b i k parts add-to!)
  (define operands (list->vector (instruction-operands i)))
  (define n (integer-sqrt (vector-length operands)))
  (define width (+ n 1))
  (define (entry row column) (vector-ref operands (+ (* row width) column)))
  (define adjoints
    (solve! b (for*/list ([row (in-range n)] [column (in-range width)])
                (if (= column n)
                    (cond [(assv row parts) => cdr] [else 0])
                    (entry column row)))))
  (define solution (for/list ([column (in-range n)]) (write! b (list 'component (place k) column))))
  (for ([row (in-range n)] [λ (in-list adjoints)])
    (add-to! (entry row n) λ)
    (for ([column (in-range n)] [x (in-list solution)] #:when (place? (entry row column)))
      (add-to! (entry row column) (negate! b (multiply! b λ x))))))

;; ---------------------------------------------------------------------------
;; Forwards

;; tangents-of-inputs : vector of operands; wanted? : index of a place -> is its tangent asked
;; for, or that of what depends on it?  -> the same of all places
(define (sweep-forward! b p tangents-of-inputs [wanted? (lambda (k) #t)])
  (define first (program-inputs p))
  (define tangents (make-vector (+ first (program-length p)) 0))
  (vector-copy! tangents 0 tangents-of-inputs)
  (define (tangent x) (if (place? x) (vector-ref tangents (place-index x)) 0))
  (for ([i (in-vector (program-instructions p))] [k (in-naturals first)])
    (define x (tangent (first-operand i)))
    (define y (if (null? (cddr i)) 0 (tangent (second-operand i))))
    (unless (or (and (eqv? x 0) (eqv? y 0) (short? i)) (not (wanted? k)))
      (vector-set! tangents k (next-tangent b i (place k) x y tangent))))
  tangents)

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

(define (short? i) (or (null? (cddr i)) (null? (cdddr i))))

;; x, y : tangents of the first operands
(define (next-tangent b i value x y tangent)
  (case (instruction-operation i)
    [(add) (add! b x y)]
    [(subtract) (subtract! b x y)]
    [(multiply)
     (add! b (multiply! b x (second-operand i)) (multiply! b (first-operand i) y))]
    [(divide) (divide! b (subtract! b x (multiply! b value y)) (second-operand i))]
    [(negate) (negate! b x)]
    [(sqrt) (divide! b (multiply! b 1/2 x) value)]
    [(wrapped) x]
    [else
     (for/fold ([sum 0]) ([operand (in-list (instruction-operands i))] [k (in-naturals)])
       (define d (tangent operand))
       (if (eqv? d 0) sum (add! b sum (multiply! b d (partial! b i k value)))))]))

;; ---------------------------------------------------------------------------
;; Partial derivatives

;; Of the operation by operand k.
(define (partial! b i k value)
  (define operands (instruction-operands i))
  (define names (for/list ([x (in-list operands)] [name (in-list '(x y))]) (if (place? x) name x)))
  (define form (apply (list-ref (generic-op-partials (record-of i)) k) (append names '(value))))
  (write-expression! b form (hasheq 'x (car operands) 'y (last operands) 'value value)))

(define (record-of i)
  (elementary-operation (instruction-operation i) (length (instruction-operands i))))
