#lang racket/base
;; Products of rows and of matrices, over the generic arithmetic; and which rows belong together.

(require (only-in racket/list append* partition)
         "../../generic/arithmetic.rkt" "../../generic/sums-and-products.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt")

(provide rows-product rows-times-list sum-of-products joined-groups)

(define (rows-product a b)
  (define columns (rows-transpose b))
  (for/vector #:length (vector-length a) ([row (in-vector a)])
    (for/vector #:length (vector-length columns) ([column (in-vector columns)])
      (sum-of-products row column))))

;; The products of rows, lists, with the list xs
(define (rows-times-list rows xs)
  (for/list ([row (in-list rows)])
    (g:for/sum ([a (in-list row)] [x (in-list xs)]) (g:* a x))))

;; Σ vᵢ wᵢ, without the terms that are 0 whatever they are multiplied by.
(define (sum-of-products v w)
  (g:for/sum ([x (in-vector v)] [y (in-vector w)] #:unless (or (eqv? x 0) (eqv? y 0)))
    (g:* x y)))

;; The indices 0 to n − 1 in groups, each rising, that joined? does not join.
(define (joined-groups n joined?)
  (for/fold ([groups '()] #:result (sort groups < #:key car)) ([i (in-range n)])
    (define-values (near far)
      (partition (lambda (group) (ormap (lambda (j) (joined? i j)) group)) groups))
    (cons (sort (cons i (append* near)) <) far)))
