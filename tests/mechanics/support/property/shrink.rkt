#lang racket/base
;; The least expression that still fails.
;;
;; Parts are replaced by their own parts or by leaves, and operands left out, as
;; long as the property still fails: each step makes the expression smaller, so
;; it ends, and the steps tried are counted.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation
         "places.rkt")

(provide shrink)

(define try-limit 600)

;; fails : expression -> #f or what went wrong
(define (shrink e fails)
  (define tries 0)
  (define (step e)
    (for*/or ([p (in-list (places e))]
              [part (in-value (at-place e p))]
              [new (in-list (smaller part))])
      (define candidate (replace-at e p new))
      (set! tries (+ tries 1))
      (and (< tries try-limit)
           (less? candidate e)
           (fails candidate)
           candidate)))
  (let loop ([e e])
    (define better (step e))
    (if better (loop better) e)))

;; Fewer nodes; or as many, and simpler leaves.
(define (less? a b)
  (define d (- (tree-size a) (tree-size b)))
  (or (< d 0) (and (eqv? d 0) (< (weight a) (weight b)))))

(define (weight e)
  (node-fold e
             (lambda (leaf)
               (cond [(eqv? leaf 1) 0]
                     [(exact-integer? leaf) (+ 1 (abs leaf))]
                     [(number? leaf) 40]
                     [(eq? leaf 'a) 20]
                     [else 30]))
             (lambda (n weights) (apply + weights))))

(define (smaller e)
  (cond [(node? e)
         (append (if (literal-head? (node-head e)) '() (filter-scalars (node-args e)))
                 (fewer-operands e)
                 (list 'a 1))]
        [(symbol? e) '(a 1)]
        [(exact-integer? e) '(1 2)]
        [else '(1 2 1/2)]))

(define (filter-scalars es)
  (filter (lambda (e) (not (and (node? e) (memq (node-head e) (list op:up op:down))))) es))

(define (fewer-operands e)
  (define args (node-args e))
  (if (and (memq (node-head e) (list op:+ op:*)) (> (length args) 2))
      (for/list ([i (in-range (length args))])
        (make-node (node-head e)
                   (for/list ([a (in-list args)] [j (in-naturals)] #:unless (eqv? i j)) a)))
      '()))
