#lang racket/base
;; Formulas of explicit methods (method-formulas.rkt) as instructions.
;;
;; A step of few components is one list of instructions, with the rates in it again for each of its
;; stages: a stage takes the results of the one before from registers, twice as fast as through
;; memory.

(require racket/list
         "right-hand-side.rkt" "method-formulas.rkt"
         "../machine/elements.rkt" "../machine/instruction-builder.rkt"
         "../machine/straight-instruction.rkt")

(provide step-code reaching square-statements write-error! polynomial)

;; r : machine-rates; m : explicit-formulas
;; The inputs of the step are y, its slope k0, h, and the parameters of the rates.
;; -> its instructions, and name -> vector of operands: z, the slopes, error and divisor
(define (step-code r m)
  (define n (machine-rates-inputs r))
  (define b (make-builder (+ n n 1 (machine-rates-parameters r))))
  (define (vector-from k) (build-vector n (lambda (i) (place (+ k i)))))
  (define (with-vector vectors s)
    (hash-set vectors (first s)
              (for/vector #:length n ([i (in-range n)]) (write-formula! b i vectors (second s)))))
  (define stages (explicit-formulas-stages m))
  (define end (stage-formulas-end stages))
  (define with-slopes
    (for/fold ([vectors (hasheq 'y (vector-from 0) 'k0 (vector-from n)
                                'h (vector (place (+ n n))))])
              ([s (in-list (stage-formulas-slopes stages))])
      (define reached (with-vector vectors (reaching 'w 'y (rest s))))
      (hash-set reached (first s) (write-rates! b (hash-ref reached 'w) r))))
  (define with-z
    (if (pair? end)
        (with-vector with-slopes (reaching 'z 'y end))
        (hash-set with-slopes 'z (hash-ref with-slopes 'w))))
  (define results
    (write-error! b n with-z m (lambda (s i) (write-formula! b i with-z (second s)))))
  (values (written b) results))

;; The statement (numeric/machine/elements.rkt) that a vector becomes from + h Σ a k
(define (reaching to from terms) (list to `(fl+ (at ,from i) (fl* h (weighted i ,@terms)))))

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
    (vector-set! computed k (write! b (moved-instruction i moved))))
  (for/vector #:length n ([o (in-vector (machine-rates-outputs r))]) (moved o)))

;; ---------------------------------------------------------------------------
;; The error of a step

;; Statements: the squares whose means the error is made of, each named as the mean is
(define (square-statements m)
  (for/list ([mean (in-list (mean-formulas m))])
    (define x
      `(fl/ (weighted i ,@(rest mean)) (fl+ 1.0 (flmax (flabs (at y i)) (flabs (at z i))))))
    (list (first mean) `(fl* ,x ,x))))

;; square : statement of squares, index -> operand
;; -> vectors, name -> vector of operands, with error and divisor
(define (write-error! b n vectors m square)
  (define with-means
    (for/fold ([vectors vectors]) ([s (in-list (square-statements m))])
      (define sum (for/fold ([sum 0.0]) ([i (in-range n)]) (do! b 'add sum (square s i))))
      (hash-set vectors (first s) (vector (do! b 'sqrt (do! b 'divide sum n))))))
  (for/fold ([vectors with-means])
            ([s (in-list `(,@(error-formulas m) (error (fl/ dividend divisor))))])
    (hash-set vectors (first s) (vector (write-formula! b 0 vectors (second s))))))

;; ---------------------------------------------------------------------------
;; Within a step

;; The formula x + θ (c₀ + (1 − θ) (c₁ + θ (c₂ + ...))); theta, other : the names of θ and 1 − θ
(define (polynomial m theta other)
  (let nested ([names (coefficient-names m)] [factor theta] [next other])
    (define c `(at ,(first names) i))
    (if (null? (rest names))
        c
        `(fl+ ,c (fl* ,factor ,(nested (rest names) next factor))))))
