#lang racket/base
;; How long the Taylor coefficients of a graph take, before any are computed.
;;
;; Coefficient k of a product is a sum of k + 1 terms; that of a linear combination takes as long
;; for every k.  So an expansion of order n takes a + b n + c n², where b counts the rows and c the
;; convolutions.

(require "jet-graph.rkt" "jet-nodes.rkt"
         "../../generic/operation-equations.rkt"
         "../../numeric/Taylor/expansion.rkt")

(provide graph-work)

;; degrees : of the nodes (jet-degrees.rkt).  Constants take nothing.
(define (graph-work g degrees)
  (define (endless? id) (= +inf.0 (vector-ref degrees id)))
  (for/fold ([w (work 0 0 0)])
            ([n (in-vector (graph-nodes g))] [id (in-naturals)]
             #:unless (eqv? 0 (vector-ref degrees id)))
    (define-values (rows convolutions)
      (if (endless? id) (values (rows-of n) (convolutions-of n endless?)) (values 0 0)))
    (work (+ 1 (work-nodes w)) (+ rows (work-rows w)) (+ convolutions (work-convolutions w)))))

(define (rows-of n)
  (case (node-kind n)
    [(system) (length (node-operands n))]
    [else 1]))

(define (convolutions-of n endless?)
  (define operands (node-operands n))
  (case (node-kind n)
    [(product)
     (cond [(eqv? (car operands) (cadr operands)) 1/2]
           [(andmap endless? operands) 1]
           [else 0])]
    [(power) (if (eqv? 1/2 (caddr n)) 1/2 3/2)]
    [(quotient) (if (endless? (cadr operands)) 1 0)]
    [(law) (if (ormap endless? operands)
               (convolutions-of-law (equations-of (cadr n) (length operands)))
               0)]
    [(integral) (if (ormap endless? operands) 1 0)]
    [(system) (length operands)]
    [else 0]))

(define (convolutions-of-law equations)
  (for/sum ([e (in-list equations)])
    (+ (length (equation-terms e)) (if (equation-leading e) 1 0))))
