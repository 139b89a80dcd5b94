#lang racket/base
;; Sums of roots as expressions, and the sums of roots that expressions of exact numbers are.

(require "radical-power.rkt" "radical-sum.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt")

(provide radicals->expression expression->radicals power-of-constant)

(define (radicals->expression s) (radicals-fold s root-node e:+ e:*))

(define (root-node n exponent)
  (if (eqv? exponent 1/2) (make-node op:sqrt (list n)) (make-node op:expt (list n exponent))))

;; -> #f where e holds anything but exact numbers, arithmetic and roots, and where a value on the
;; way is no short sum of roots
(define (expression->radicals e)
  (let/ec return
    (define (short s) (if (and s (radicals-small? s)) s (return #f)))
    (define (leaf x) (if (and (rational? x) (exact? x)) (rational->radicals x) (return #f)))
    (define (node n parts) (short (apply-to-radicals (node-head n) parts)))
    (node-fold e leaf node)))

(define (apply-to-radicals head parts)
  (define s (car parts))
  (define t (and (pair? (cdr parts)) (cadr parts)))
  (cond [(eq? head op:+) (for/fold ([sum s]) ([x (in-list (cdr parts))]) (radicals-add sum x))]
        [(eq? head op:*) (for/fold ([p s]) ([x (in-list (cdr parts))]) (radicals-multiply p x))]
        [(eq? head op:-) (radicals-subtract s t)]
        [(eq? head op:/)
         (define inverse (power-of-radicals t -1))
         (and inverse (radicals-multiply s inverse))]
        [(eq? head op:sqrt) (power-of-radicals s 1/2)]
        [(eq? head op:expt)
         (define exponent (radicals->rational t))
         (and exponent (power-of-radicals s exponent))]
        [else #f]))

(define (power-of-radicals s exponent)
  (if (equal? s (rational->radicals 0))
      (and (positive? exponent) s)
      (radicals-expt s exponent)))

;; e : a node;  k : rational  -> e^k as a sum of roots, an expression, or #f
(define (power-of-constant e k)
  (define s (expression->radicals e))
  (define power (and s (power-of-radicals s k)))
  (and power (radicals-small? power) (radicals->expression power)))
