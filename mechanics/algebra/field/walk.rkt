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

;; The walk of one expression.  resolutions : what stands for its nodes
;; values, turns : of nodes and of angles met, by identity
;; node : the operation that is being carried out
(struct walk (arithmetic resolutions values turns [node #:mutable]) #:authentic)

;; The value of e, whose kernels the atlas holds.
(define (evaluate-in A atlas e)
  (define w (walk A (atlas-resolutions atlas) (make-memo) (make-memo) e))
  (with-handlers ([(lambda (x) (or (obstacle? x) (overspent? x)))
                   (lambda (x) (raise (stuck (walk-node w))))])
    (value-of w e)))

;; ---------------------------------------------------------------------------
;; Operations of an arithmetic

(define (constant A c) ((arithmetic-constant A) c))
(define (kernel-value A k) ((arithmetic-kernel A) k))
(define (sum A . values) ((arithmetic-sum A) values))
(define (product A . values) ((arithmetic-product A) values))
(define (difference A v w) ((arithmetic-difference A) v w))
(define (quotient-of A v w) ((arithmetic-quotient A) v w))
(define (power A v k) ((arithmetic-power A) v k))

;; ---------------------------------------------------------------------------
;; The walk

(define (value-of w e)
  (cond [(number? e) (number-value w e)]
        [(symbol? e) (resolved-value w e (resolution w e))]
        [else ((walk-values w) e (lambda () (node-value w e)))]))

(define (resolution w e) (hash-ref (walk-resolutions w) e))

(define (number-value w x)
  (define A (walk-arithmetic w))
  (cond [(not (exact-constant? x)) (resolved-value w x (resolution w x))]
        [(real? x) (constant A (rational-part x))]
        [else
         (sum A
              (constant A (rational-part x))
              (product A
                       (constant A (imaginary-part x))
                       (resolved-value w imaginary-unit (resolution w imaginary-unit))))]))

(define (node-value w n)
  (define r (resolution w n))
  (if (eq? r #t)
      (operation-value w n)
      (resolved-value w n r)))

;; The value of what stands for n.
(define (resolved-value w n r)
  (cond [(kernel? r) (kernel-value (walk-arithmetic w) r)]
        [(alias? r) (value-of w (alias-expression r))]
        [(surd? r) (surd-value w n r (value-of w (surd-outer r)))]
        [else
         (set-walk-node! w n)
         (if (circular? r) (circular-value w r) (exponential-value w r))]))

(define (operation-value w n)
  (define args (node-args n))
  (if (eq? (node-head n) op:/)
      (divided w n (value-of w (car args)) (cadr args))
      (undivided-value w n (node-head n) args)))

(define (undivided-value w n head args)
  (define A (walk-arithmetic w))
  (define values
    (for/list ([a (in-list (if (eq? head op:expt) (list (car args)) args))]) (value-of w a)))
  (set-walk-node! w n)
  (cond [(eq? head op:+) ((arithmetic-sum A) values)]
        [(eq? head op:*) ((arithmetic-product A) values)]
        [(eq? head op:-) (difference A (car values) (cadr values))]
        [else (power A (car values) (exact-exponent (cadr args)))]))

;; By the factors of a divisor one after the other: they are known then.
(define (divided w n value divisor)
  (define A (walk-arithmetic w))
  (define head
    (and (node? divisor) (eq? #t (resolution w divisor)) (node-head divisor)))
  (cond [(eq? head op:*)
         (for/fold ([v value]) ([d (in-list (node-args divisor))]) (divided w n v d))]
        [(eq? head op:expt)
         (define base (value-of w (car (node-args divisor))))
         (set-walk-node! w n)
         (product A value (power A base (- (exact-exponent (cadr (node-args divisor))))))]
        [else
         (define d (value-of w divisor))
         (set-walk-node! w n)
         (quotient-of A value d)]))

;; ---------------------------------------------------------------------------
;; Roots and exponentials

(define (surd-value w n r outer)
  (define A (walk-arithmetic w))
  (define root (surd-root r))
  (define scale (if root (value-of w (root-scale root)) outer))
  (set-walk-node! w n)
  (define outer-power (power A outer (surd-power r)))
  (if root
      (product A
               outer-power
               (power A scale (- (surd-power r)))
               (power A (kernel-value A (root-kernel root))
                      (* (surd-power r) (/ (root-degree root) (surd-degree r)))))
      outer-power))

(define (exponential-value w r)
  (define A (walk-arithmetic w))
  ((arithmetic-product A)
   (cons (constant A 1)
         (for/list ([m (in-list (angle-multiples (exponential-power-angle r)))])
           (power A (kernel-value A (car m)) (cdr m))))))

;; ---------------------------------------------------------------------------
;; Angles: turns (cosine . sine)

(define (circular-value w r)
  (define t (turn-of w (circular-angle r)))
  (cond [(memq (circular-function r) (list op:sin op:sinh)) (cdr t)]
        [(memq (circular-function r) (list op:cos op:cosh)) (car t)]
        [else (quotient-of (walk-arithmetic w) (cdr t) (car t))]))

(define (turn-of w a)
  ((walk-turns w) a (lambda () (turn-by (walk-arithmetic w) (angle-multiples a)))))

;; By multiples ((circle . integer) ...) of basic angles.
(define (turn-by A multiples)
  (for/fold ([t #f] #:result (or t (cons (constant A 1) (constant A 0))))
            ([m (in-list multiples)])
    (define u (basic-turn A (car m) (cdr m)))
    (if t (turn-product A (circle-sign (car m)) t u) u)))

(define (basic-turn A circle n)
  (define sine (kernel-value A (circle-sine circle)))
  (define t
    (cons (kernel-value A (circle-cosine circle))
          (if (negative? n) (product A (constant A -1) sine) sine)))
  (turn-power A (circle-sign circle) t (abs n)))

(define (turn-power A sign t n)
  (cond [(eqv? n 1) t]
        [(even? n) (turn-power A sign (turn-product A sign t t) (quotient n 2))]
        [else (turn-product A sign t (turn-power A sign t (- n 1)))]))

;; sign : 1 of circles, -1 of hyperbolas
(define (turn-product A sign t u)
  (cons (difference A
                    (product A (car t) (car u))
                    (product A (constant A sign) (product A (cdr t) (cdr u))))
        (sum A (product A (cdr t) (car u)) (product A (car t) (cdr u)))))
