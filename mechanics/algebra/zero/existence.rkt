#lang racket/base
;; Has an expression a value anywhere?
;;
;; An expression without a value anywhere equals anything: 1/z with z = 0, however z is
;; written, and log(-1 - x²).  So a proof asks for a point where every part of the expression
;; as it was given has a value, and where the declarations hold.

(require (only-in racket/list remove-duplicates)
         "assignment.rkt" "../ball/ball-tape.rkt" "point-value.rkt"
         (only-in "../assumption/assumption-set.rkt" assumptions-domain assumptions-relations)
         (only-in "../assumption/reference-point.rkt" find-reference)
         "../expression/expression.rkt" "../expression/flat-graph.rkt"
         "../expression/operation.rkt" "../expression/symbols.rkt")

(provide somewhere-defined? everywhere-defined? domain-expressions
         decisive-leaves leaves-under-functions)

;; t : tape; A : assumptions
(define (somewhere-defined? t A)
  (define all (cons t (map expression->tape (assumptions-domain A))))
  (or (andmap everywhere-defined? all)
      (and (null? (assumptions-relations A)) (andmap defined-among-positive? all))
      (let ([value (if (contains-complex? t) complex-value tape-value)])
        (and (find-reference (list (tape->expression t)) A
                             (lambda (lookup) (defined? t lookup value)))
             #t))))

;; Has it a value where all leaves are positive, as √(k/m) does?  Then its divisors are made of
;; leaves and positive numbers without a minus sign, and so are its radicands and
;; the arguments of its logarithms.  Unknown functions may have any values, positive ones too.
(define (defined-among-positive? t)
  (define positive (make-vector (tape-length t) #f))
  (for/and ([e (in-vector (tape-items t))] [ks (in-vector (tape-operands t))] [k (in-naturals)])
    (define (positive-operand? k) (vector-ref positive k))
    (vector-set! positive k
                 (cond [(number? e) (and (rational? e) (positive? e))]
                       [(or (symbol? e) (unknown? e)) #t]
                       [else (and (memq (node-head e) keep-positive)
                                  (andmap positive-operand? ks))]))
    (cond [(number? e) (rational? e)]
          [(or (symbol? e) (total? e)) #t]
          [(eq? (node-head e) op:/) (positive-operand? (cadr ks))]
          [(memq (node-head e) (list op:sqrt op:log op:expt)) (positive-operand? (car ks))]
          [else #f])))

;; Of positive arguments they are positive.
(define keep-positive
  (append (list op:+ op:* op:/ op:sqrt op:expt op:abs)
          (operations-where total positive) (operations-where total odd increasing)))

;; Polynomials in sines, exponentials and the like.
(define (everywhere-defined? t)
  (for/and ([e (in-vector (tape-items t))])
    (cond [(node? e) (total? e)]
          [(number? e) (rational? (magnitude e))]
          [else #t])))

(define (total? n)
  (or (literal-head? (node-head n))
      (and (memq (node-head n) total) #t)
      (integer-power-above-0? n)))

(define total (append (list op:+ op:- op:* op:up op:down) (operations-where total)))

(define (integer-power-above-0? e)
  (and (eq? (node-head e) op:expt) (exact-nonnegative-integer? (cadr (node-args e)))))

;; The leaves that stand where not every number may: in a denominator, under a root, a
;; logarithm, ...  -> table: leaf -> #t
(define (decisive-leaves t)
  (leaves-marked
   (spread-marks t 0 (lambda (e head mark i) (if (or (eqv? mark 1) (decided-by? e i)) 1 0)))
   1))

;; Does the i-th argument of the node decide whether it has a value?
(define (decided-by? n i)
  (not (or (total? n) (and (eq? (node-head n) op:/) (eqv? i 0)))))

;; ---------------------------------------------------------------------------
;; The domain of a question (common-domain.rkt).  Its expressions stay as they were given, as
;; log(1 − 2) would become a complex number.  One that holds a number that is not real, as e^(it),
;; has complex values, and is left out.

;; xs : values -> those of the expressions among them that may lack a real value somewhere
(define (domain-expressions xs)
  (filter partial? (remove-duplicates xs eq?)))

(define (partial? x)
  (and (node? x)
       (all-numbers-real? x)
       (not (everywhere-defined? (expression->plain-tape x)))))

(define (all-numbers-real? e)
  (all-leaves? (lambda (leaf) (or (symbol? leaf) (rational? leaf))) e))

;; ---------------------------------------------------------------------------
;; Under functions

;; Where the leaves that stand under a sine, an exponential or the like are 0, these have exact
;; values.
;; -> the leaves standing somewhere below a function, and those that stand nowhere else
(define (leaves-under-functions t)
  ;; a mark has bit 1 for outside, bit 2 for below; a literal application is a leaf
  (define (below e head mark i)
    (cond [(or (eqv? mark 0) (memq head algebraic)) mark]
          [(literal-head? head) 0]
          [else 2]))
  (define marked (spread-marks t 1 below))
  (values (leaves-marked marked 2 3) (leaves-marked marked 2)))

(define algebraic (list op:+ op:- op:* op:/ op:expt op:sqrt op:abs))

;; ---------------------------------------------------------------------------
;; Marks, from the root down

;; below : node, its head, its marks, number of an operand -> marks to add to the operand's
;; root : marks of the last item
;; -> list of unknowns with their marks, which are bits
(define (spread-marks t root below)
  (define n (tape-length t))
  (define marks (make-vector n 0))
  (vector-set! marks (- n 1) root)
  (for/fold ([unknowns '()]) ([k (in-range (- n 1) -1 -1)])
    (define e (vector-ref (tape-items t) k))
    (define head (vector-ref (tape-heads t) k))
    (define mark (vector-ref marks k))
    (for ([j (in-list (vector-ref (tape-operands t) k))] [i (in-naturals)])
      (vector-set! marks j (bitwise-ior (below e head mark i) (vector-ref marks j))))
    (if (or (operation? head) (not (unknown? e))) unknowns (cons (cons e mark) unknowns))))

;; -> table of the unknowns that have one of these marks
(define (leaves-marked unknowns . wanted)
  (for/hash ([u (in-list unknowns)] #:when (memv (cdr u) wanted)) (values (car u) #t)))

;; ---------------------------------------------------------------------------
;; At a point

;; Has each part of it a value there?  Literal functions have one for equal arguments.
(define (defined? t lookup value)
  (define seen (make-assignment))
  (define (number leaf arguments)
    (assigned seen leaf arguments (lambda () (inexact->exact (lookup leaf '())))))
  (not (symbol? (value t number precision))))

(define precision 80)
