#lang racket/base
;; From programs to what computes Taylor coefficients of the motions they are the rates of.
;;
;; The nodes of a graph (jet-graph.rkt) become rows of coefficients, and kernels
;; (numeric/Taylor) that compute them, closures made once for an integration: no code is
;; generated.  A node that is a polynomial in the time, as the time is itself, ends: beyond its
;; degree nothing is computed, so that cos ωt costs one multiplication for an order.

(require racket/fixnum
         racket/flonum
         racket/list
         "jet-coefficient-rows.rkt" "jet-degrees.rkt" "jet-graph.rkt" "jet-nodes.rkt"
         "jet-operation-kernels.rkt"
         "jet-sum-kernels.rkt" "../program.rkt"
         "../../numeric/Taylor/expansion.rkt" "../../numeric/Taylor/kernels.rkt"
         "../../numeric/Taylor/linear-system.rkt"
         "../../operation/operation-column.rkt")

(provide program->expansion-maker maker->expander expansion-maker-branches?)

;; p : a program of the rates of as many inputs as it has outputs, the first ones; or, with
;; #:follow?, of any functions of the first `varying` inputs; constants : the values of those
;; beyond, if they are known by now
;; -> expansion-maker, or a string that says why there is none
(define (program->expansion-maker p varying #:follow? [follow? #f] #:constants [constants '()])
  (define g (program->graph p varying constants))
  (cond [(string? g) g]
        [else
         (define degrees (if follow? (node-degrees g #f) (node-degrees g (graph-outputs g))))
         (expansion-maker (lambda (order inputs) (make-expansion g degrees order inputs))
                          (graph-work g degrees) (branches? p))]))

;; make : order flvector -> expansion, given the values of all inputs, of which those beyond
;; stay; work : what it takes; branches? : as in numeric/Taylor/expansion.rkt
(struct expansion-maker (make work branches?)
  #:authentic
  #:property prop:procedure 0)

;; With these inputs.
(define (maker->expander m inputs)
  (expander (lambda (order) (m order inputs)) (expansion-maker-work m)
            (expansion-maker-branches? m)))

;; Roots, arcs and the like have several branches.
(define (branches? p)
  (for/or ([i (in-vector (program-instructions p))])
    (not (memq (instruction-operation i) of-one-branch))))

(define of-one-branch
  (append '(add subtract multiply divide negate solve component log) (operation-names meromorphic)))

(define (make-expansion g degrees order inputs)
  (define nodes (graph-nodes g))
  (define r (make-rows degrees order))
  (define uses (sole-uses g))
  (define shared (factor-groups g degrees uses))
  (for ([n (in-vector nodes)] [id (in-naturals)])
    (unless (eq? 'sum (vector-ref uses id))
      (emit-node! r nodes id uses shared)))
  (for ([x (in-flvector inputs)] [id (in-naturals)]) (flvector-set! (row r id) 0 x))
  (define states (for/list ([id (in-range (graph-varying g))]) (row r id)))
  (define slopes (for/list ([id (in-vector (graph-outputs g))]) (row r id)))
  (define moving
    (for/list ([state (in-list states)] [slope (in-list slopes)] [id (in-naturals)]
               #:unless (< (degree r id) +inf.0))
      (list state slope)))
  (define (last id) (if (< (degree r id) order) (inexact->exact (degree r id)) order))
  (expansion order (list->vector states) (list->vector slopes)
             (for/fxvector ([id (in-range (graph-varying g))]) (max 1 (last id)))
             (list->vector (append* moving))
             (starts r) (ending-kernels r) (endless-kernels r)))

;; ---------------------------------------------------------------------------
;; Nodes

(define (emit-node! r nodes id uses shared)
  (define n (vector-ref nodes id))
  (define operands (cdr n))
  (case (node-kind n)
    [(input unused) (void)]
    [(one) (flvector-set! (row r id) 0 1.0)]
    [(linear) (emit-sum! r nodes id uses)]
    [(product) (emit-product! r nodes id shared)]
    [(power) (emit-power! r id (car operands) (cadr operands))]
    [(quotient)
     (define-values (x a b) (values (row r id) (row r (car operands)) (row r (cadr operands))))
     (emit-start! r (lambda () (flvector-set! x 0 (fl/ (flvector-ref a 0) (flvector-ref b 0)))))
     (apply emit! r id (sum-kernels x (list (weighed 1.0 a)) #f))
     (emit! r id (leading-kernel x b (degree r (cadr operands))))]
    [(law) (emit-law! r id (car operands) (cdr operands) (find-node nodes (list 'partner id)))]
    [(integral) (emit-integral! r id (car operands) (cdr operands))]
    [(still) (emit-value! r id (car operands) (cdr operands))]
    [(system) (emit-system! r nodes id operands)]
    [(partner component) (void)]))    ; with the law or the system

;; ---------------------------------------------------------------------------
;; Powers

(define (emit-power! r id base n)
  (define-values (x b) (values (row r id) (row r base)))
  (define f (power-body n))
  (emit-start! r (lambda () (flvector-set! x 0 (f (flvector-ref b 0)))))
  (emit! r id (case n
                [(1/2) (root-kernel x b)]
                [(-1) (reciprocal-kernel x b)]
                [else (power-kernel x b (real->double-flonum n))])))

;; Halves of small whole numbers by multiplication and roots.
(define (power-body n)
  (define m (* 2 n))
  (cond [(and (integer? m) (<= (abs m) 12))
         (define-values (whole half?) (values (quotient (abs m) 2) (odd? m)))
         (lambda (b)
           (define x
             (for/fold ([x (if half? (flsqrt b) 1.0)]) ([_ (in-range whole)]) (fl* x b)))
           (if (< n 0) (fl/ 1.0 x) x))]
        [else
         (define exponent (real->double-flonum n))
         (lambda (b) (flexpt b exponent))]))

;; ---------------------------------------------------------------------------
;; Systems

(define (find-node nodes n)
  (for/first ([m (in-vector nodes)] [id (in-naturals)] #:when (equal? m n)) id))

(define (emit-system! r nodes id entries)
  (define n (integer-sqrt (length entries)))
  (define width (+ n 1))
  (define (ids of-right?)
    (for/list ([x (in-list entries)] [k (in-naturals)]
               #:when (eq? of-right? (= n (remainder k width))))
      x))
  (define (rows ids) (for/vector ([x (in-list ids)]) (row r x)))
  (define matrix (ids #f))
  (define varying (for/vector ([x (in-list matrix)]) (> (degree r x) 0)))
  (define xs
    (for/vector ([k (in-range n)])
      (define component (find-node nodes (list 'component id k)))
      (if component (row r component) (spare-row r))))
  (define-values (start! step!)
    (system-kernels (rows matrix) (lambda (k) (vector-ref varying k)) (rows (ids #t)) xs))
  (emit-start! r start!)
  (emit! r id step!))
