#lang racket/base
;; The value in its field of an expression whose kernels are known.
;;
;; Sines and cosines of angles that are combinations of basic ones come from powers of
;; cos θ + i sin θ (cosh u + j sinh u with j² = 1).

(require "field.rkt" "work-bounds.rkt"
         "../expression/exact-numbers.rkt" "../expression/expression.rkt"
         "../expression/operation.rkt"
         "../kernel/find-kernels.rkt" "../kernel/kernel.rkt"
         "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt")

(provide field-fraction within-bounds (struct-out obstruction))

;; The walk of one expression.  values, turns : of nodes and of angles met, by identity
;; node : the operation that is being carried out
(struct walk (field values turns [node #:mutable]) #:authentic)

;; Where the value would be divided by zero or grow past the bounds, the walk raises the
;; node at which that happened.
(struct obstruction (node))

;; The reduced fraction an expression stands for.
(define (field-fraction F e)
  (define w (walk F (make-memo) (make-memo) e))
  (reduce-fraction F (within-bounds F (lambda () (walk-node w)) (lambda () (value-of w e)))))

;; The value of (work); past the bounds an obstruction at (node) is raised.
(define (within-bounds F node work)
  (begin0
    (with-handlers ([(lambda (x) (or (obstacle? x) (overspent? x)))
                     (lambda (x) (raise (obstruction (node))))])
      (work))
    (end-steps! (field-fuel F))))

(define (constant F c) (fraction-constant (field-ring F) c))

(define (value-of w e)
  (cond [(number? e) (number-value w e)]
        [(symbol? e) (resolved-value w e (resolution w e))]
        [else ((walk-values w) e (lambda () (node-value w e)))]))

(define (resolution w e) (hash-ref (atlas-resolutions (field-atlas (walk-field w))) e))

(define (number-value w x)
  (define F (walk-field w))
  (cond [(not (exact-constant? x)) (resolved-value w x (resolution w x))]
        [(real? x) (constant F (rational-part x))]
        [else
         (field-sum F
                    (constant F (rational-part x))
                    (field-product F
                                   (constant F (imaginary-part x))
                                   (resolved-value w imaginary-unit
                                                   (resolution w imaginary-unit))))]))

(define (node-value w n)
  (define r (resolution w n))
  (if (eq? r #t)
      (operation-value w n)
      (resolved-value w n r)))

;; The value of n, by its resolution r.
(define (resolved-value w n r)
  (cond [(kernel? r) (field-variable (walk-field w) r)]
        [(alias? r) (value-of w (alias-expression r))]
        [(surd? r) (surd-value w n r (value-of w (surd-outer r)))]
        [else
         (set-walk-node! w n)
         (if (circular? r) (circular-value w r) (exponential-value w r))]))

(define (operation-value w n)
  (define F (walk-field w))
  (define head (node-head n))
  (define args (node-args n))
  (define (by-values operate)           ; operate : F and the values of the operands
    (define operands (for/list ([a (in-list args)]) (value-of w a)))
    (set-walk-node! w n)
    (apply operate F operands))
  (cond [(eq? head op:+) (by-values field-sum)]
        [(eq? head op:*) (by-values field-product)]
        [(eq? head op:-) (by-values field-difference)]
        [(eq? head op:/) (divided w n (value-of w (car args)) (cadr args))]
        [else (powered w n (car args) (exact-exponent (cadr args)))]))

(define (powered w n base k)
  (define b (value-of w base))
  (set-walk-node! w n)
  (field-power (walk-field w) b k))

;; The quotient, by one factor of the divisor after the other: so the denominator is factored.
(define (divided w n value divisor)
  (define F (walk-field w))
  (define head
    (and (node? divisor) (eq? #t (resolution w divisor)) (node-head divisor)))
  (cond [(eq? head op:*)
         (for/fold ([v value]) ([d (in-list (node-args divisor))]) (divided w n v d))]
        [(eq? head op:expt)
         (define-values (base exponent) (apply values (node-args divisor)))
         (field-product F value (powered w n base (- (exact-exponent exponent))))]
        [else
         (define d (value-of w divisor))
         (set-walk-node! w n)
         (field-quotient F value d)]))

;; ---------------------------------------------------------------------------
;; Roots and exponentials

(define (surd-value w n r outer)
  (define F (walk-field w))
  (define root (surd-root r))
  (define scale (if root (value-of w (root-scale root)) outer))
  (set-walk-node! w n)
  (define outer-power (field-power F outer (surd-power r)))
  (if root
      (field-product F
                     outer-power
                     (field-power F scale (- (surd-power r)))
                     (field-power F (field-variable F (root-kernel root))
                                  (* (surd-power r) (/ (root-degree root) (surd-degree r)))))
      outer-power))

(define (exponential-value w r)
  (define F (walk-field w))
  (apply field-product F
         (constant F 1)
         (for/list ([m (in-list (angle-multiples (exponential-power-angle r)))])
           (field-power F (field-variable F (car m)) (cdr m)))))

;; ---------------------------------------------------------------------------
;; Angles: turns (cosine . sine)

(define (circular-value w r)
  (define t (turn-of w (circular-angle r)))
  (cond [(memq (circular-function r) (list op:sin op:sinh)) (cdr t)]
        [(memq (circular-function r) (list op:cos op:cosh)) (car t)]
        [else (field-quotient (walk-field w) (cdr t) (car t))]))

(define (turn-of w a)
  ((walk-turns w) a (lambda () (turn-by (walk-field w) (angle-multiples a)))))

;; By multiples ((circle . integer) ...) of basic angles.
(define (turn-by F multiples)
  (for/fold ([t #f] #:result (or t (cons (constant F 1) (constant F 0))))
            ([m (in-list multiples)])
    (define u (basic-turn F (car m) (cdr m)))
    (if t (turn-product F (circle-sign (car m)) t u) u)))

(define (basic-turn F circle n)
  (define sine (field-variable F (circle-sine circle)))
  (define t
    (cons (field-variable F (circle-cosine circle))
          (if (negative? n) (field-product F (constant F -1) sine) sine)))
  (turn-power F (circle-sign circle) t (abs n)))

(define (turn-power F sign t n)
  (cond [(eqv? n 1) t]
        [(even? n) (turn-power F sign (turn-product F sign t t) (quotient n 2))]
        [else (turn-product F sign t (turn-power F sign t (- n 1)))]))

;; sign : 1 of circles, -1 of hyperbolas
(define (turn-product F sign t u)
  (define (product a b) (field-product F a b))
  (cons (field-difference F
                          (product (car t) (car u))
                          (product (constant F sign) (product (cdr t) (cdr u))))
        (field-sum F (product (cdr t) (car u)) (product (car t) (cdr u)))))
