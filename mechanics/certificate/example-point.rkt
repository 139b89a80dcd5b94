#lang racket/base
;; A point where all hypotheses of a claim hold, so that the claim is not empty: numbers for its
;; symbols, constant functions for its unknown functions.
;;
;; The numbers are between 1 and 3/2, where sines and cosines are positive; or, if none of these
;; will do, others.

(require racket/list
         "Coq-names.rkt" "Coq-term.rkt"
         (only-in "../algebra/assumption/reference-point.rkt" real-value)
         "../algebra/expression/expression.rkt" "../algebra/expression/nodes.rkt"
         "../algebra/expression/operation.rkt"
         "../algebra/expression/read.rkt" "../algebra/expression/substitute.rkt"
         "../value/algebra.rkt")

(provide example-values put-numbers)

;; relations : ((sign left right) ...); ns : names -> alist: symbol or function -> number
(define (example-values relations ns)
  (define unknowns (append (names-symbols ns) (names-functions ns)))
  (define angles (append-map angles-in (append-map cdr relations)))
  (define (found good?)
    (for/first ([k (in-range most-tries)]
                #:when (let ([values (place unknowns k)])
                         (and (good? values) (all-hold? relations values))))
      (place unknowns k)))
  (define (all-acute? values) (andmap (lambda (a) (acute? a values)) angles))
  (or (found (lambda (values)
               (and (all-acute? values)
                    (all-hold? relations values)
                    (andmap (lambda (d) (easy? d values)) relations))))
      (found all-acute?)
      (found (lambda (values) #t))
      (give-up "no point was found where all its hypotheses hold")))

;; The angles of which a sine, cosine or tangent is in e, an expression or a datum
(define (angles-in e)
  (if (node? e)
      (for/list ([n (in-list (nodes-in e))]
                 #:when (memq (node-head n) (list op:sin op:cos op:tan)))
        (car (node-args n)))
      '()))

;; The relation with numbers for its sines and cosines, near 0 and near 1: where all of these hold,
;; no more need be known of them.
(define (with-waves-anyhow d)
  (for*/list ([s (in-list '(1/100 99/100))] [c (in-list '(1/100 99/100))])
    (define (put e)
      (if (node? e)
          (in-place-of (for*/list ([n (in-list (nodes-in e))]
                                   #:when (memq (node-head n) (list op:sin op:cos)))
                         (cons n (if (eq? op:sin (node-head n)) s c)))
                       e)
          e))
    (cons (car d) (map put (cdr d)))))

;; Does it hold whatever the waves are in it, or in what its left side simplifies to?
(define (easy? d values)
  (define left (cadr d))
  (or (null? (angles-in left))
      (all-hold? (with-waves-anyhow d) values)
      (let ([simple (simplify-expression (put-numbers left values))])
        (all-hold? (with-waves-anyhow (list* (car d) simple (cddr d))) values))))

(define (acute? angle values)
  (define x (value-at angle values))
  (and x (< 0 x 3/2)))

(define most-tries 400)

(define (place unknowns k)
  (for/list ([u (in-list unknowns)] [i (in-naturals)]) (cons u (coordinate i k))))

;; The i-th number of the k-th place
(define (coordinate i k)
  (define (pick xs) (list-ref xs (modulo (+ i (* k (+ i 1)) (quotient k (+ i 2))) (length xs))))
  (cond [(eqv? k 0) 1]
        [(< k 4) (/ (+ i 1) (expt 4 k))]
        [(< k 12) (+ 1 (/ (modulo (+ 1 (* i (+ k 1))) 8) 16))]
        [(< k 60) (pick '(1 3/2 2 3 1/2 5 1/4 4))]
        [(< k 200) (pick '(1 -1 2 1/2 -2 0 3 -1/2 1/10))]
        [else (pick '(1/10 1/2 -1/4 1 1/100 -1/2 2 10 0 -1))]))

(define (all-hold? relations values)
  (for/and ([d (in-list relations)]) (holds? d values)))

(define (holds? d values)
  (define (side x) (value-at (if (expression? x) x (datum->expression x)) values))
  (define a (side (cadr d)))
  (define b (side (caddr d)))
  (and a b
       (case (car d)
         [(>) (> a (+ b margin))]
         [(<) (< a (- b margin))]
         [(>=) (>= a (- b margin))]
         [(<=) (<= a (+ b margin))]
         [(<>) (> (abs (- a b)) margin)]
         [else (< (abs (- a b)) margin)])))

(define margin 1e-9)

(define (value-at e values) (real-value e (lambda (leaf _) (value leaf values))))

(define (value leaf values)
  (cdr (or (assoc leaf values) (assoc (function-of leaf) values))))

;; e with numbers for its symbols and for its unknown functions applied, nothing evaluated
(define (put-numbers e values)
  (node-fold e
             (lambda (leaf) (let ([known (assoc leaf values)]) (if known (cdr known) leaf)))
             (lambda (n parts)
               (if (literal-head? (node-head n))
                   (cdr (assoc (function-of n) values))
                   (make-node (node-head n) parts)))))
