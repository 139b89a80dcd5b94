#lang racket/base
;; The domain of a claim: where each of its subexpressions has a value.
;;
;; Coq's functions are total: 1/0 is 0 there, and so is √(-1).  A theorem about them says
;; nothing of the claim where a divisor vanishes or a radicand is negative.  So each subexpression
;; that can lack a value gives a hypothesis.  They are written from the expression as it stands:
;; √(-x²) has the hypothesis 0 ≤ -x², and what simplification would cancel counts.

(require racket/list
         "Coq-term.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/nodes.rkt"
         "../algebra/expression/operation.rkt")

(provide domain-relations square-of-distance)

;; -> relations ((<> d 0) (>= r 0) ...), their sides expressions, each once
(define (domain-relations es)
  (remove-duplicates
   (filter (lambda (d) (not (plain-fact? d)))
           (append-map (lambda (e) (append-map node-domain (nodes-in e))) es))))

(define (node-domain n)
  (define args (node-args n))
  (define a (and (pair? args) (car args)))
  (define (of head . known) (and (eq? (node-head n) head) known))
  (cond [(of op:/) (list (list '<> (cadr args) 0))]
        [(of op:expt) (power-domain a (cadr args))]
        [(of op:sqrt) (list (list '>= a 0))]
        [(of op:log) (list (list '> a 0))]
        [(of op:tan) (list (list '<> (e:apply op:cos a) 0))]
        [(and (of op:atan) (pair? (cdr args))) (list (list '<> (square-of-distance n) 0))]
        [(or (of op:asin) (of op:acos)) (list (list '>= a -1) (list '<= a 1))]
        [else '()]))

;; x² + y², of a node of the angle of the point (x, y)
(define (square-of-distance n)
  (define (square e) (make-node op:* (list e e)))
  (make-node op:+ (map square (reverse (node-args n)))))

(define (power-domain base k)
  (define-values (kind n) (split-power k))
  (case kind
    [(base) (if (negative? n) (list (list '<> base 0)) '())]
    [(root) (list (list (if (negative? n) '> '>=) base 0))]
    [else (list (list '> base 0))]))

;; Is it a true relation between numbers?
(define (plain-fact? d)
  (define x (cadr d))
  (and (real? x)
       (case (car d)
         [(<>) (not (= x (caddr d)))]
         [(>=) (>= x (caddr d))]
         [(<=) (<= x (caddr d))]
         [else (> x (caddr d))])))
