#lang racket/base
;; Formulas over vectors: as instructions, and as machine code, the same for each component, two
;; components at a time.
;;
;; A *formula* is one of Racket code (numeric/ode/vector-formulas.rkt): a number; a symbol, which
;; stands for one; (at v i), the component of a vector; (fl+ f g), and so with fl-, fl*, fl/ and
;; flmax; (flabs f), (flsqrt f); or (weighted i [f v] ...), the sum of products with components of
;; vectors.  The operations are done in the order written: the values are the same to the last bit.

(require racket/flonum
         racket/list
         "assembler.rkt" "instruction-builder.rkt" "straight-code.rkt" "straight-instruction.rkt")

(provide write-formula! statements->instructions emit-elements! (struct-out vector-at))

;; vectors : name -> vector of operands, of one for a number
;; -> the operand of the component of index i
(define (write-formula! b i vectors f)
  (define (operand f) (write-formula! b i vectors f))
  (cond [(real? f) f]
        [(symbol? f) (vector-ref (hash-ref vectors f) 0)]
        [else
         (case (car f)
           [(at) (vector-ref (hash-ref vectors (cadr f)) i)]
           [(weighted)
            (for/fold ([sum #f]) ([p (in-list (cddr f))])
              (define x (do! b 'multiply (operand (first p)) (operand `(at ,(second p) i))))
              (if sum (do! b 'add sum x) x))]
           [else
            (define operands (map operand (cdr f)))
            (if (and (eq? (car f) 'fl/) (andmap real? operands))
                (apply fl/ operands)
                (apply do! b (hash-ref instruction-names (car f)) operands))])]))

(define instruction-names
  (hasheq 'fl+ 'add 'fl- 'subtract 'fl* 'multiply 'fl/ 'divide
          'flmax 'larger 'flabs 'abs 'flsqrt 'sqrt))

;; ---------------------------------------------------------------------------
;; Loops

;; A vector is so many bytes behind the address in a register.
(struct vector-at (base distance) #:authentic)

;; Up to so many components are written one pair after the other, not as a loop.
(define most-unrolled 8)

;; n : how many components; places : name -> vector-at, or the memory of a number, twice side by
;; side; statements : list of (name formula), whose value is stored where the name has a place, and
;; for which the name stands in the statements behind
;; Registers for flonums and those that a function of C may change do.
(define (emit-elements! a n places statements)
  (define names (hash-keys places))
  (define-values (instructions results) (statements->instructions names statements))
  (define (components! pairs? distance index)
    (define (memory-of name)
      (define p (hash-ref places name))
      (if (vector-at? p) (behind (vector-at-base p) (+ (vector-at-distance p) distance) index) p))
    (define given (for/vector ([name (in-list names)]) (memory-of name)))
    (write-straight-code! a instructions (vector-length given)
                          (lambda (k) (vector-ref given k))
                          (for/list ([r (in-list results)] #:when (hash-has-key? places (car r)))
                            (cons (cdr r) (memory-of (car r))))
                          #:pairs? pairs?))
  (define in-pairs (* 2 (quotient n 2)))
  (cond [(<= n most-unrolled)
         (for ([i (in-range 0 in-pairs 2)]) (components! #t (* 8 i) #f))]
        [else
         (define again (make-label))
         (mov-number! a rax 0)
         (label-here! a again)
         (components! #t 0 rax)
         (add! a rax 16)
         (compare-number! a rax (* 8 in-pairs))
         (jump! a 'less again)])
  (when (odd? n) (components! #f (* 8 in-pairs) #f)))

;; -> instructions of one component, whose inputs are those of the names; list of (name . operand)
(define (statements->instructions names statements)
  (define b (make-builder (length names)))
  (define inputs
    (for/hasheq ([name (in-list names)] [k (in-naturals)]) (values name (vector (place k)))))
  (define-values (_ results)
    (for/fold ([vectors inputs] [results '()]) ([s (in-list statements)])
      (define x (write-formula! b 0 vectors (second s)))
      (values (hash-set vectors (first s) (vector x)) (cons (cons (first s) x) results))))
  (values (written b) (reverse results)))
