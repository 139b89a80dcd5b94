#lang racket/base
;; Places in an expression taken as a tree, and replacing the part there.
;;
;; A place is a list of positions of operands, from the root down.  A changed
;; expression is rebuilt raw: no constructor tidies up the result of a rewrite.

(require mechanics/algebra/expression/expression)

(provide places at-place replace-at tree-size)

;; All places, outer ones first, at most `limit` of them.
(define (places e [limit 400])
  (define found
    (let walk ([e e] [here '()])
      (cons (reverse here)
            (if (node? e)
                (apply append
                       (for/list ([a (in-list (node-args e))] [i (in-naturals)])
                         (walk a (cons i here))))
                '()))))
  (define sorted (sort found < #:key length))
  (for/list ([p (in-list sorted)] [_ (in-range limit)]) p))

(define (at-place e place)
  (for/fold ([e e]) ([i (in-list place)]) (list-ref (node-args e) i)))

(define (replace-at e place new)
  (if (null? place)
      new
      (make-node (node-head e)
                 (for/list ([a (in-list (node-args e))] [i (in-naturals)])
                   (if (eqv? i (car place)) (replace-at a (cdr place) new) a)))))

(define (tree-size e)
  (node-fold e (lambda (leaf) 1) (lambda (n sizes) (apply + 1 sizes))))
