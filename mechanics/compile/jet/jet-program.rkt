#lang racket/base
;; From programs for rates to makers of the Taylor coefficients of their motions.
;;
;; The nodes of a graph (jet-graph.rkt) become rows of coefficients, and recurrences
;; (numeric/Taylor) that compute them.  A node that is a polynomial in the time, as the time is
;; itself, ends: beyond its degree nothing is computed, so that cos ωt costs one multiplication for
;; an order.

(require racket/list
         "jet-coefficient-rows.rkt" "jet-degrees.rkt" "jet-graph.rkt" "jet-nodes.rkt"
         "jet-operation-recurrences.rkt"
         "jet-sum-recurrences.rkt" "../cache.rkt" "../program.rkt"
         "../../numeric/Taylor/expansion.rkt" "../../numeric/Taylor/recurrence-list.rkt"
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
         (define kept (made-of-program p 'Taylor-codes (lambda () (box (hash)))))
         (define rs (graph->recurrences kept g degrees follow?))
         (expansion-maker (lambda (order inputs) (recurrences->expansion rs order inputs))
                          (graph-work g degrees (recurrences-coded? rs)) (branches? p))]))

;; make : order flvector -> expansion, given the values of all inputs, of which those beyond
;; stay; work : the cost; branches? : as in numeric/Taylor/expansion.rkt
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

(define (graph->recurrences kept g degrees follow?)
  (define nodes (graph-nodes g))
  (define r (make-rows degrees))
  (define uses (sole-uses g))
  (define shared (factor-groups g degrees uses))
  (for ([n (in-vector nodes)] [id (in-naturals)])
    (unless (eq? 'sum (vector-ref uses id))
      (emit-node! r nodes id uses shared)))
  (rows->recurrences kept r (range (graph-varying g)) (vector->list (graph-outputs g)) follow?))

;; ---------------------------------------------------------------------------
;; Nodes

(define (emit-node! r nodes id uses shared)
  (define n (vector-ref nodes id))
  (define operands (cdr n))
  (case (node-kind n)
    [(input unused) (void)]
    [(one) (emit-start! r (make-recurrence 'constant (row-of r id) 1.0))]
    [(linear) (emit-sum! r nodes id uses)]
    [(product) (emit-product! r nodes id shared)]
    [(power) (emit-power! r id (car operands) (cadr operands))]
    [(quotient)
     (define-values (x a b)
       (apply values (for/list ([k (in-list (cons id operands))]) (row-of r k))))
     (emit-start! r (make-recurrence 'ratio x a b))
     (apply emit! r id (sum-recurrences x (list (weighed 1.0 a)) #f))
     (emit! r id (leading-recurrence x b))]
    [(law) (emit-law! r id (car operands) (cdr operands) (find-node nodes (list 'partner id)))]
    [(integral) (emit-integral! r id (car operands) (cdr operands))]
    [(still) (emit-value! r id (car operands) (cdr operands))]
    [(system) (emit-system! r nodes id operands)]
    [(partner component) (void)]))    ; with the law or the system

;; ---------------------------------------------------------------------------
;; Powers

(define (emit-power! r id base n)
  (define-values (x b) (values (row-of r id) (row-of r base)))
  (emit-start! r (make-recurrence 'power-value x b n))
  (emit! r id (case n
                [(1/2) (make-recurrence 'root x b)]
                [(-1) (make-recurrence 'reciprocal x b)]
                [else (make-recurrence 'power x b (real->double-flonum n))])))

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
  (define (rows ids) (for/vector ([x (in-list ids)]) (row-of r x)))
  (define matrix (ids #f))
  (define varying (for/vector ([x (in-list matrix)]) (> (degree r x) 0)))
  (define xs
    (for/vector ([k (in-range n)])
      (define component (find-node nodes (list 'component id k)))
      (if component (row-of r component) (spare-row r))))
  (emit-always! r id (make-recurrence 'system (rows matrix) varying (rows (ids #t)) xs)))
