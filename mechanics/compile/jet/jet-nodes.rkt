#lang racket/base
;; Nodes of graphs for Taylor coefficients, each once.
;;
;;     (input i)  (one)  (linear c (id . c_i) ...)  (product id id)  (power id n)
;;     (quotient id id)  (law name id ...)  (partner id)  (still name id ...)
;;     (integral name id slope)
;;     (system id ...)  (component id k)  (unused)
;;
;; A law is an operation that has equations (generic/operation-rule/operation-equations.rkt), and
;; `partner` is the partner of its value; an `integral` has no equations, but its derivative at a is
;; another node.  `still` is any operation on nodes that do not vary.

(provide node-kind node-operands
         make-nodes nodes-count nodes-fail nodes-varying node! node-of still?)

(define (node-kind n) (car n))

;; The ids of the nodes it depends on.
(define (node-operands n)
  (case (car n)
    [(input one) '()]
    [(linear) (map car (cddr n))]
    [(power component) (list (cadr n))]
    [(law integral still) (cddr n)]
    [else (cdr n)]))

;; ids : node -> id; nodes : id -> node; still : ids of nodes that do not vary; varying : how many
;; inputs may; fail : operation -> does not return
(struct nodes (ids by-id still varying fail) #:authentic)

(define (make-nodes varying fail) (nodes (make-hash) (make-hasheqv) (make-hasheqv) varying fail))

(define (nodes-count b) (hash-count (nodes-ids b)))

(define (node! b n)
  (define ids (nodes-ids b))
  (or (hash-ref ids n #f)
      (let ([id (hash-count ids)])
        (hash-set! ids n id)
        (hash-set! (nodes-by-id b) id n)
        (when (still-node? b n) (hash-set! (nodes-still b) id #t))
        id)))

(define (node-of b id) (hash-ref (nodes-by-id b) id))

(define (still-node? b n)
  (case (node-kind n)
    [(input) (>= (cadr n) (nodes-varying b))]
    [else (andmap (lambda (id) (still? b id)) (node-operands n))]))
(define (still? b id) (hash-ref (nodes-still b) id #f))
