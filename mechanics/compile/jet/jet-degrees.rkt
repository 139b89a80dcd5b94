#lang racket/base
;; Which nodes of a graph are polynomials in the time, of which degree; and how long the Taylor
;; coefficients of the others take, before any are computed.
;;
;; Coefficient k of a product is a sum of k + 1 terms; that of a linear combination takes as long
;; for every k.  So an expansion of order n takes a + b n + c n², where b counts the rows and c the
;; convolutions.

(require "jet-graph.rkt" "jet-nodes.rkt"
         "../../generic/operation-rule/operation-equations.rkt"
         (only-in "../../numeric/finite-number.rkt" lesser)
         "../../numeric/Taylor/expansion.rkt")

(provide node-degrees graph-work)

;; slopes : the ids of the rates of the first inputs, or #f if nothing is known of these
;; -> vector of exact integers, +inf.0 for no polynomial.  An input of degree d + 1 has a rate of
;; degree d, so that degrees are found by repetition.
(define (node-degrees g slopes)
  (let loop ([inputs (make-vector (graph-varying g) +inf.0)])
    (define degrees (degrees-from g inputs))
    (define better
      (for/vector ([d (in-vector inputs)] [k (in-naturals)])
        (if slopes (lesser d (+ 1 (vector-ref degrees (vector-ref slopes k)))) d)))
    (if (equal? better inputs)
        degrees
        (loop (for/vector ([d (in-vector better)]) (bounded d))))))

(define (degrees-from g inputs)
  (define nodes (graph-nodes g))
  (define degrees (make-vector (vector-length nodes) +inf.0))
  (define (degree id) (vector-ref degrees id))
  (for ([n (in-vector nodes)] [id (in-naturals)])
    (define operands (map degree (node-operands n)))
    (vector-set!
     degrees id
     (bounded
      (case (node-kind n)
        [(input) (if (< id (vector-length inputs)) (vector-ref inputs id) 0)]
        [(one) 0]
        [(linear) (apply max 0 operands)]
        [(product) (apply + operands)]
        [else (if (andmap zero? operands) 0 +inf.0)]))))
  degrees)

;; Longer polynomials are treated as if they did not end.
(define greatest 4)
(define (bounded d) (if (> d greatest) +inf.0 d))

;; ---------------------------------------------------------------------------
;; Work

;; degrees : of the nodes; coded? : is there machine code for them?  Constants take nothing.
(define (graph-work g degrees coded?)
  (define (endless? id) (= +inf.0 (vector-ref degrees id)))
  (for/fold ([w (work 0 0 0 0 coded?)])
            ([n (in-vector (graph-nodes g))] [id (in-naturals)]
             #:unless (eqv? 0 (vector-ref degrees id)))
    (define-values (rows convolutions)
      (if (endless? id) (values (rows-of n) (convolutions-of n endless?)) (values 0 0)))
    (define functions (if (eq? 'law (node-kind n)) 1 0))
    (work (+ 1 (work-nodes w)) (+ functions (work-functions w))
          (+ rows (work-rows w)) (+ convolutions (work-convolutions w))
          coded?)))

(define (rows-of n) (if (eq? 'system (node-kind n)) (length (node-operands n)) 1))

(define (convolutions-of n endless?)
  (define operands (node-operands n))
  (define-syntax-rule (if-any-endless convolutions)
    (if (ormap endless? operands) convolutions 0))
  (case (node-kind n)
    [(product)
     (cond [(apply eqv? operands) 1/2]
           [(andmap endless? operands) 1]
           [else 0])]
    [(power) (if (eqv? 1/2 (caddr n)) 1/2 3/2)]
    [(quotient) (if (endless? (cadr operands)) 1 0)]
    [(law) (if-any-endless (convolutions-of-law (equations-of (cadr n) (length operands))))]
    [(integral) (if-any-endless 1)]
    [(system) (length operands)]
    [else 0]))

(define (convolutions-of-law equations)
  (for/sum ([e (in-list equations)])
    (+ (length (equation-terms e)) (if (equation-leading e) 1 0))))
