#lang racket/base
;; A residual with far more nodes as a tree than as a graph.
;;
;; Turning a vector by one angle after another doubles the tree with each turn.
;; Turns of the plane commute: the sums of many such chains, done in one order
;; and in the opposite one, differ by nothing, unless one angle is changed.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation)

(provide rotations-residual tree-size graph-size)

(define chains 445)
(define turns 12)
(define symbols '#(a b c d e f))

;; vanishing? : or with one angle of one chain changed?
(define (rotations-residual vanishing?)
  (define-values (there back)
    (for/fold ([there 0] [back 0]) ([i (in-range chains)])
      (define angles (chain-angles i))
      (define changed
        (if (or vanishing? (< i (- chains 1))) angles (cons (e:* 2 (car angles)) (cdr angles))))
      (values (e:+ there (chain-end angles))
              (e:+ back (chain-end (reverse changed))))))
  (e:- there back))

(define (chain-angles i)
  (for/list ([k (in-range turns)])
    (define (pick n) (vector-ref symbols (modulo n 6)))
    (e:+ (e:* (+ 1 (modulo (* i k) 7)) (pick (+ i k)))
         (e:* (+ 1 (modulo (+ i (* 3 k)) 5)) (pick (* (+ i 1) k))))))

(define (chain-end angles)
  (for/fold ([x 'x] [y 'y] #:result (e:+ x (e:* 2 y))) ([u (in-list angles)])
    (define c (e:apply op:cos u))
    (define s (e:apply op:sin u))
    (values (e:- (e:* x c) (e:* y s))
            (e:+ (e:* x s) (e:* y c)))))

(define (tree-size e)
  (node-fold e (lambda (leaf) 1) (lambda (n sizes) (apply + 1 sizes))))

(define (graph-size e)
  (define count 0)
  (node-fold e void (lambda (n values) (set! count (+ count 1))))
  count)
