#lang racket/base
;; Places where an integrand may have a peak that samples miss.
;;
;; A narrow peak, as that of e^(−10¹⁰ (x − c)²), is written by its place: a part of the integrand
;; is linear or quadratic in x, and has its zero, or its turning point, there.

(require racket/list
         "../algebra/expression/expression.rkt" "../algebra/expression/operation.rkt"
         "../error/refusal.rkt"
         "../generic/tracing.rkt"
         "../numeric/finite-number.rkt")

(provide peak-places)

(define most-places 8)

;; f : a function of one number -> flonums; none where f takes decisions by its argument
(define (peak-places f)
  (define x (make-placeholder "x"))
  (define e (if-raised raised? #f (call-traced (lambda () (f x)) void)))
  (define found (remove-duplicates (if (node? e) (append-map special-places (parts e x)) '())))
  (take found (min most-places (length found))))

;; The polynomials up to degree 2 that are parts of e, as vectors c₀, c₁, c₂
(define (parts e x)
  (define found '())
  (define (leaf u)
    (cond [(eq? u x) (vector 0.0 1.0 0.0)]
          [(rational? u) (vector (exact->inexact u) 0.0 0.0)]
          [else #f]))
  (define (node n args)
    (define p (and (andmap values args) (combined (node-head n) args)))
    (when p (set! found (cons p found)))
    p)
  (node-fold e leaf node)
  found)

(define (combined head ps)
  (define (each f p q) (for/vector ([a (in-vector p)] [b (in-vector q)]) (f a b)))
  (cond [(eq? head op:+) (for/fold ([s (car ps)]) ([p (in-list (cdr ps))]) (each + s p))]
        [(eq? head op:-) (each - (car ps) (cadr ps))]
        [(eq? head op:*)
         (for/fold ([s (car ps)]) ([p (in-list (cdr ps))]) #:break (not s) (product s p))]
        [(and (eq? head op:expt) (eqv? 2.0 (constant (cadr ps)))) (product (car ps) (car ps))]
        [(and (operation? head) (operation-numeric head) (andmap constant ps))
         => (lambda (_)
              (define y (apply (operation-numeric head) (map constant ps)))
              (and (real? y) (vector y 0.0 0.0)))]
        [else #f]))

(define (constant p)
  (and (= 0.0 (vector-ref p 1)) (= 0.0 (vector-ref p 2)) (vector-ref p 0)))

;; #f beyond degree 2
(define (product p q)
  (define (c i j) (* (vector-ref p i) (vector-ref q j)))
  (and (= 0.0 (c 1 2) (c 2 1) (c 2 2))
       (vector (c 0 0) (+ (c 0 1) (c 1 0)) (+ (c 0 2) (c 1 1) (c 2 0)))))

;; Zeros and turning point
(define (special-places p)
  (define-values (c b a) (vector->values p))
  (define root (sqrt (- (* b b) (* 4.0 a c))))
  (filter finite?
          (cond [(and (= a 0.0) (= b 0.0)) '()]
                [(= a 0.0) (list (- (/ c b)))]
                [(real? root)
                 (list (/ (- b) (* 2.0 a)) (/ (- root b) (* 2.0 a)) (/ (- (+ root b)) (* 2.0 a)))]
                [else (list (/ (- b) (* 2.0 a)))])))
