#lang racket/base
;; The range of an expression's real values, as far as its structure tells: cos x is from
;; -1 to 1, so cos x - 2 is negative and √((cos x - 2)²) is 2 - cos x.
;;
;; Dependent parts are taken for independent, so the range may be too wide, and never too
;; narrow.

(require "interval.rkt" "signs.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt" "../expression/pi.rkt"
         "../expression/symbols.rkt")

(provide range-signs range-over interval-signs around-pi
         leaf-range node-range)                  ; the same, step by step

;; -> the signs that values of e may have
(define (range-signs e) (interval-signs (node-fold e leaf-range node-range)))

(define (interval-signs r)
  (cond [(positive? (interval-low r)) positive]
        [(negative? (interval-high r)) negative]
        [(>= (interval-low r) 0) nonnegative]
        [(<= (interval-high r) 0) nonpositive]
        [else any-sign]))

(define around-pi (interval pi-digits (+ pi-digits (expt 10 -50))))

;; places : symbol, or literal function applied -> the interval it is in
(define (range-over e places)
  (node-fold e
             (lambda (leaf) (if (unknown? leaf) (places leaf) (leaf-range leaf)))
             (lambda (n parts) (if (unknown? n) (places n) (node-range n parts)))))

(define (leaf-range leaf)
  (cond [(pi-multiple leaf) => (lambda (k) (interval-product (point-interval k) around-pi))]
        [(and (rational? leaf) (exact? leaf)) (point-interval leaf)]
        [else everything]))

;; parts : the ranges of its arguments
(define (node-range n parts)
  (define head (node-head n))
  (define (together f) (for/fold ([s (car parts)]) ([r (in-list (cdr parts))]) (f s r)))
  (cond [(eq? head op:+) (together interval-sum)]
        [(eq? head op:-)
         (interval-sum (car parts) (interval-product (point-interval -1) (cadr parts)))]
        [(square? n) (interval-power (car parts) 2)]
        [(eq? head op:*) (together interval-product)]
        [(eq? head op:/) (interval-quotient (car parts) (cadr parts))]
        [(eq? head op:expt) (interval-power (car parts) (cadr (node-args n)))]
        [(and (eq? head op:atan) (pair? (cdr parts))) (interval -22/7 22/7)]
        [(and (operation? head) (pair? parts) (null? (cdr parts)))
         (interval-of-operation (operation-name head) (car parts))]
        [else everything]))

;; Is it x x?
(define (square? n)
  (define args (node-args n))
  (and (eq? (node-head n) op:*) (= (length args) 2) (equal? (car args) (cadr args))))
