#lang racket/base
;; A step of a method as straight code, the rates in it again for each of its stages.
;;
;; All is one list of instructions: what one stage computes the next takes from registers.  Of few
;; components that is twice as fast as loops over vectors, for which each slope goes through memory.

(require racket/flonum
         "right-hand-side.rkt"
         "../machine/straight-instruction.rkt")

(provide step-code)

;; r : the rates; slopes, error : as method-formulas.rkt has them
;; The inputs of the step are y, its slope k0, h, and the parameters of the rates.
;; -> its instructions, and name -> vector of operands: z, the slopes, error and divisor
(define (step-code r slopes error)
  (define n (machine-rates-inputs r))
  (define b (make-builder (+ n n 1 (machine-rates-parameters r))))
  (define (vector-from k) (build-vector n (lambda (i) (place (+ k i)))))
  (define start (hasheq 'y (vector-from 0) 'k0 (vector-from n) 'h (vector (place (+ n n)))))
  (define (reached vectors terms)
    (for/vector ([i (in-range n)])
      (write! b i vectors `(fl+ (at y i) (fl* h (weighted i ,@terms))))))
  (define-values (stages end) (values (car slopes) (cadr slopes)))
  (define-values (with-slopes at-last)
    (for/fold ([vectors start] [_ #f]) ([s (in-list stages)])
      (define w (reached vectors (cdr s)))
      (values (hash-set vectors (car s) (write-rates! b w r)) w)))
  (define z (if (pair? end) (reached with-slopes end) at-last))
  (define results (write-error! b n (hash-set with-slopes 'z z) error))
  (values (instructions-of b) results))

;; The rates at w -> their operands
(define (write-rates! b w r)
  (define n (vector-length w))
  (define instructions (machine-rates-instructions r))
  (define inputs (+ n (machine-rates-parameters r)))
  (define computed (make-vector (vector-length instructions) #f))
  (define (moved o)
    (define k (and (place? o) (place-index o)))
    (cond [(not k) o]
          [(< k n) (vector-ref w k)]
          [(< k inputs) (place (+ k n 1))]
          [else (vector-ref computed (- k inputs))]))
  (for ([i (in-vector instructions)] [k (in-naturals)])
    (vector-set! computed k
                 (apply emit! b (instruction-operation i) (map moved (instruction-operands i)))))
  (for/vector #:length n ([o (in-vector (machine-rates-outputs r))]) (moved o)))

(define (write-error! b n vectors error)
  (define-values (means formulas dividend divisor) (apply values error))
  (define scales
    (for/vector ([i (in-range n)])
      (write! b i vectors '(fl+ 1.0 (flmax (flabs (at y i)) (flabs (at z i)))))))
  (define (mean terms)
    (define sum
      (for/fold ([sum 0.0]) ([i (in-range n)])
        (define e (write! b i vectors `(weighted i ,@terms)))
        (define x (emit! b 'divide e (vector-ref scales i)))
        (emit! b 'add sum (emit! b 'multiply x x))))
    (vector (emit! b 'sqrt (emit! b 'divide sum (->fl n)))))
  (define with-means
    (for/fold ([vectors vectors]) ([m (in-list means)])
      (hash-set vectors (car m) (mean (cdr m)))))
  (define with-all
    (for/fold ([vectors with-means]) ([f (in-list formulas)])
      (hash-set vectors (car f) (vector (write! b 0 vectors (cadr f))))))
  (define d (write! b 0 with-all divisor))
  (hash-set* with-all
             'divisor (vector d)
             'error (vector (emit! b 'divide (write! b 0 with-all dividend) d))))

;; ---------------------------------------------------------------------------
;; Formulas (numeric/machine/elements.rkt), of the components of index i

;; vectors : name -> vector of operands, of one for a number
(define (write! b i vectors f)
  (define (operand f) (write! b i vectors f))
  (define (two name) (emit! b name (operand (cadr f)) (operand (caddr f))))
  (cond [(real? f) f]
        [(symbol? f) (vector-ref (hash-ref vectors f) 0)]
        [else
         (case (car f)
           [(at) (vector-ref (hash-ref vectors (cadr f)) i)]
           [(fl+) (two 'add)]
           [(fl-) (two 'subtract)]
           [(fl*) (two 'multiply)]
           [(fl/) (if (andmap real? (cdr f)) (apply fl/ (cdr f)) (two 'divide))]
           [(flmax) (two 'larger)]
           [(flabs) (emit! b 'abs (operand (cadr f)))]
           [(flsqrt) (emit! b 'sqrt (operand (cadr f)))]
           [(weighted)
            (for/fold ([sum #f]) ([p (in-list (cddr f))])
              (define x (emit! b 'multiply (operand (car p)) (operand `(at ,(cadr p) i))))
              (if sum (emit! b 'add sum x) x))])]))

;; next : the place of the next value; written : instructions, the latest first
(struct builder ([next #:mutable] [written #:mutable]) #:authentic)

(define (make-builder first) (builder first '()))
(define (instructions-of b) (list->vector (reverse (builder-written b))))

(define (emit! b . instruction)
  (define k (builder-next b))
  (set-builder-next! b (+ k 1))
  (set-builder-written! b (cons instruction (builder-written b)))
  (place k))
