#lang racket/base
;; Evaluating an expression whose kernels are known, in any arithmetic.
;;
;; The same walk makes fractions of polynomials, degree bounds, residues modulo
;; a prime: an `arithmetic` says what constants and kernels are and how values
;; combine.  Sines and cosines of angles that are combinations of basic ones
;; come from powers of cos θ + i sin θ (cosh u + j sinh u with j² = 1).

(require "../expression/exact-numbers.rkt" "../expression/expression.rkt"
         "../expression/operation.rkt"
         "../kernel/find-kernels.rkt" "../kernel/kernel.rkt"
         "../polynomial/polynomial.rkt")

(provide (struct-out arithmetic) evaluate-in
         raise-obstacle (struct-out stuck))

;; constant : exact rational -> value        kernel : kernel -> value
;; sum, product : values -> value            difference, quotient : value value -> value
;; power : value integer -> value
(struct arithmetic (constant kernel sum product difference quotient power)
  #:authentic)

;; An arithmetic that cannot go on, dividing by zero or growing past its bounds,
;; raises an obstacle, or spends more than it may; the walk raises the node at
;; which it happened, `stuck`.
(struct obstacle ())
(struct stuck (node))

(define (raise-obstacle) (raise (obstacle)))

;; The value of e, whose kernels the atlas holds.
(define (evaluate-in A atlas e)
  (define current e)
  (define resolutions (atlas-resolutions atlas))
  (define memo (make-memo))
  (define turns (make-turns A))
  (define (walk e)
    (cond [(number? e) (number-value e)]
          [(symbol? e) (resolved e)]
          [else (memo e (lambda () (node-value e)))]))
  (define (resolved e) (resolved-value e (hash-ref resolutions e)))
  (define (number-value x)
    (define constant (arithmetic-constant A))
    (cond [(not (exact-constant? x)) (resolved x)]
          [(real? x) (constant (rational-part x))]
          [else
           ((arithmetic-sum A)
            (list (constant (rational-part x))
                  ((arithmetic-product A)
                   (list (constant (imaginary-part x)) (resolved imaginary-unit)))))]))
  (define (node-value n)
    (define r (hash-ref resolutions n))
    (if (eq? r #t)
        (operation-value n (node-head n) (node-args n))
        (resolved-value n r)))
  (define (resolved-value n r)
    (cond [(kernel? r) ((arithmetic-kernel A) r)]
          [(alias? r) (walk (alias-expression r))]
          [(surd? r) (surd-value n r (walk (surd-outer r)))]
          [else
           (set! current n)
           (if (circular? r) (circular-value r) (exponential-value r))]))
  (define (operation-value n head args)
    (if (eq? head op:/)
        (divide n (walk (car args)) (cadr args))
        (simple-operation-value n head args)))
  ;; By the factors of a divisor one after the other: they are known then.
  (define (divide n value divisor)
    (define head (and (node? divisor) (eq? #t (hash-ref resolutions divisor)) (node-head divisor)))
    (cond [(eq? head op:*)
           (for/fold ([v value]) ([d (in-list (node-args divisor))]) (divide n v d))]
          [(eq? head op:expt)
           (define base (walk (car (node-args divisor))))
           (set! current n)
           ((arithmetic-product A)
            (list value
                  ((arithmetic-power A) base (- (exact-exponent (cadr (node-args divisor)))))))]
          [else
           (define d (walk divisor))
           (set! current n)
           ((arithmetic-quotient A) value d)]))
  (define (simple-operation-value n head args)
    (define values (map walk (if (eq? head op:expt) (list (car args)) args)))
    (set! current n)
    (cond [(eq? head op:+) ((arithmetic-sum A) values)]
          [(eq? head op:*) ((arithmetic-product A) values)]
          [(eq? head op:-) ((arithmetic-difference A) (car values) (cadr values))]
          [else ((arithmetic-power A) (car values) (exact-exponent (cadr args)))]))
  (define (circular-value r)
    (define turn (turns (circular-angle r)))
    (cond [(memq (circular-function r) (list op:sin op:sinh)) (cdr turn)]
          [(memq (circular-function r) (list op:cos op:cosh)) (car turn)]
          [else ((arithmetic-quotient A) (cdr turn) (car turn))]))
  (define (exponential-value r)
    ((arithmetic-product A)
     (cons ((arithmetic-constant A) 1)
           (for/list ([m (in-list (angle-multiples (exponential-power-angle r)))])
             ((arithmetic-power A) ((arithmetic-kernel A) (car m)) (cdr m))))))
  (define (surd-value n r outer)
    (define root (surd-root r))
    (define scale (if root (walk (root-scale root)) outer))
    (set! current n)
    (define (power v k) ((arithmetic-power A) v k))
    (define outer-power (power outer (surd-power r)))
    (if root
        ((arithmetic-product A)
         (list outer-power
               (power scale (- (surd-power r)))
               (power ((arithmetic-kernel A) (root-kernel root))
                      (* (surd-power r) (/ (root-degree root) (surd-degree r))))))
        outer-power))
  (with-handlers ([(lambda (x) (or (obstacle? x) (overspent? x)))
                   (lambda (x) (raise (stuck current)))])
    (walk e)))

;; ---------------------------------------------------------------------------
;; Angles

;; (make-turns A) -> (angle -> (cosine . sine))
(define (make-turns A)
  (define memo (make-memo))
  (define zero ((arithmetic-constant A) 0))
  (define one ((arithmetic-constant A) 1))
  (define (product . values) ((arithmetic-product A) values))
  (define (scale c v) (product ((arithmetic-constant A) c) v))
  (define (multiply sign t u)
    (cons ((arithmetic-difference A)
           (product (car t) (car u))
           (scale sign (product (cdr t) (cdr u))))
          ((arithmetic-sum A)
           (list (product (cdr t) (car u)) (product (car t) (cdr u))))))
  (define (power sign t n)
    (cond [(eqv? n 1) t]
          [(even? n) (power sign (multiply sign t t) (quotient n 2))]
          [else (multiply sign t (power sign t (- n 1)))]))
  (define (multiple circle n)
    (define kernel (arithmetic-kernel A))
    (define sine (kernel (circle-sine circle)))
    (define t (cons (kernel (circle-cosine circle))
                    (if (negative? n) (scale -1 sine) sine)))
    (power (circle-sign circle) t (abs n)))
  (define (turn multiples)
    (for/fold ([t #f] #:result (or t (cons one zero))) ([m (in-list multiples)])
      (define u (multiple (car m) (cdr m)))
      (if t (multiply (circle-sign (car m)) t u) u)))
  (lambda (a) (memo a (lambda () (turn (angle-multiples a))))))
