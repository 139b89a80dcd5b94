#lang racket/base
;; Programs made ready for Taylor coefficients: sums of products of as few quantities as
;; there may be.
;;
;; The values of instructions are forms (jet-linear-combinations.rkt), linear combinations of nodes
;; (jet-nodes.rkt); at the end there are the nodes that the outputs need, by their ids, those of the
;; inputs first.

(require "jet-linear-combinations.rkt" "jet-nodes.rkt" "../program.rkt"
         "../../algebra/expression/expression.rkt" "../../algebra/expression/operation.rkt"
         "../../algebra/expression/pi.rkt"
         "../../generic/elementary.rkt" "../../generic/kind.rkt"
         "../../generic/operation-rule/operation-equations.rkt"
         "../../operation/operation-column.rkt")

(provide program->graph (struct-out graph))

;; nodes : vector, by id; outputs : vector of ids; varying : how many inputs are not constant
(struct graph (nodes outputs inputs varying) #:authentic)

;; The first `varying` inputs are functions of time, the others constants, of the values in the
;; list if there are any.
;; -> graph, or a string that says why there is none
(define (program->graph p varying [constants '()])
  (let/ec return
    (define (fail name) (return (format "the operation `~a` has no Taylor recurrence" name)))
    (define b (make-nodes varying fail))
    (define n (program-inputs p))
    (define places (make-vector (+ n (program-length p)) #f))
    (define uses (program-uses p))
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

;; Exponents, and factors that are nothing or 1, are recognized as exact numbers.
(define (exact-if-whole c)
  (if (and (integer? c) (not (zero? c))) (inexact->exact c) c))

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
(define-fact-column partners together-with)

(define (apply-law! b name fs)
  (define ids (for/list ([f (in-list fs)]) (whole! b f)))
  (define main (hash-ref partners name #f))
  (node-form
   (cond [(andmap (lambda (id) (still? b id)) ids) (node! b (list* 'still name ids))]
         [main (node! b (list 'partner (node! b (list 'law main (car ids)))))]
         [(equations-of name (length ids)) (node! b (list* 'law name ids))]
         [(memq name (operation-names meromorphic))
          (node! b (list 'integral name (car ids) (whole! b (derivative! b name (car fs)))))]
         [else ((nodes-fail b) name)])))

;; The derivative of the operation at the form f, a form.
(define (derivative! b name f)
  (define slope (car (generic-op-partials (elementary-operation name 1))))
  (node-fold (slope 'x 'value)
             (lambda (leaf)
               (cond [(number? leaf) (number-form leaf)]
                     [(pi-symbol? leaf) (number-form (pi-flonum leaf))]
                     [(eq? leaf 'x) f]
                     [else ((nodes-fail b) name)]))
             (lambda (n fs)
               (define op (node-head n))
               (if (andmap number-form? fs)
                   (number-form (apply (operation-numeric op) (map form-constant fs)))
                   (apply-operation! b (operation-name op) fs)))))

(define (apply-operation! b name fs)
  (define (fold f) (for/fold ([sum (car fs)]) ([g (in-list (cdr fs))]) (f sum g)))
  (case name
    [(+) (fold add)]
    [(*) (fold (lambda (f g) (multiply! b f g)))]
    [(-) (add (car fs) (scale -1 (cadr fs)))]
    [(/) (divide! b (car fs) (cadr fs) #f)]
    [(expt) (expt! b (car fs) (cadr fs))]
    [else (apply-law! b name fs)]))

;; ---------------------------------------------------------------------------
;; Nodes that outputs need; others are unused

(define (pruned b outputs inputs)
  (define nodes (make-vector (nodes-count b) '(unused)))
  (define (need! id) (vector-set! nodes id (node-of b id)))
  (for ([id (in-range inputs)]) (need! id))
  (for ([id (in-vector outputs)]) (need! id))
  (for ([id (in-range (- (vector-length nodes) 1) -1 -1)])
    (for-each need! (node-operands (vector-ref nodes id))))
  (graph nodes outputs inputs (nodes-varying b)))
