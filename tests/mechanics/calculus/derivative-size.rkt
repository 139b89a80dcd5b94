#lang racket/base
;; The derivative of a graph is a graph of its size, however large the tree would
;; be that is written on paper: a few nodes for each node, at any depth.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/generic/sums-and-products
         mechanics/algebra/expression/expression
         mechanics/calculus/derivative
         "../support/checks.rkt")

;; Of the graph as it was made, equal nodes made apart counted apart.
(define (nodes e)
  (define count 0)
  (define (count! . _) (set! count (+ count 1)))
  (node-fold e void count!)
  count)

(define (composition n) (lambda (x) (for/fold ([y x]) ([_ (in-range n)]) (g:sin y))))
(define (product n)
  (lambda (x) (for/fold ([y x]) ([k (in-range n)]) (g:* y (g:sin (g:+ x (add1 k)))))))
(define (squares n) (lambda (x) (for/fold ([y x]) ([_ (in-range n)]) (g:+ (g:square y) x))))
(define (fraction n) (lambda (x) (for/fold ([y x]) ([_ (in-range n)]) (g:/ x (g:+ 1 y)))))
(define (powers n) (lambda (x) (for/fold ([y x]) ([_ (in-range n)]) (g:expt y (g:+ 1 x)))))
(define (sums n) (lambda (x) (g:for/sum ([k (in-range n)]) (g:sin (g:* (add1 k) x)))))

(for ([make (list composition product squares fraction powers sums)]
      [name '("compositions" "products" "squares" "fractions" "powers" "sums")])
  (test-case (format "derivatives of nested ~a are linear in nodes" name)
    (define (size n order) (nodes (((g:expt D order) (make n)) 'x)))
    (for ([order '(1 2)] [factor '(4 16)])
      (check-true (<= (size 200 order) (* factor (size 200 0))))
      ;; growth from 100 to 200 is that from 0 to 100
      (check-true (<= (size 200 order) (* 2.1 (size 100 order)))))))

(test-case "derivatives nested by hand are linear in nodes too"
  (define (size n) (nodes ((D (D (squares n))) 'x)))
  (check-true (<= (size 200) (* 2.1 (size 100)))))
