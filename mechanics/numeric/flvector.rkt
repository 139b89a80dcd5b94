#lang racket/base
;; Flvectors as points and directions: operations that racket/flonum leaves out.
;;
;; The inner loops of integration are written with the macros of ode/vector-formulas.rkt, which
;; make no new vectors.

(require racket/flonum
         racket/unsafe/ops)

(provide flvector-finite?
         flvector->list flvector-copy! flvector-swap!
         flvector-map unit-flvector flvector-scaled along difference dot norm greatest distance
         short?)

(define (flvector-finite? v)
  (let loop ([i (flvector-length v)])
    (or (unsafe-fx= i 0)
        (let ([k (unsafe-fx- i 1)])
          (and (unsafe-fl< (unsafe-flabs (unsafe-flvector-ref v k)) +inf.0) (loop k))))))

(define (flvector->list v) (for/list ([x (in-flvector v)]) x))

;; 1.0 in place i of n
(define (unit-flvector i n)
  (define v (make-flvector n))
  (flvector-set! v i 1.0)
  v)

(define flvector-map
  (case-lambda
    [(f v) (for/flvector #:length (flvector-length v) ([x (in-flvector v)]) (f x))]
    [(f v w)
     (for/flvector #:length (flvector-length v) ([x (in-flvector v)] [y (in-flvector w)])
       (f x y))]))

(define (flvector-scaled a v)
  (for/flvector #:length (flvector-length v) ([x (in-flvector v)]) (fl* a x)))

;; As many components as both have.
(define (flvector-copy! to from)
  (define n (unsafe-fxmin (flvector-length to) (flvector-length from)))
  (let loop ([i 0])
    (when (unsafe-fx< i n)
      (unsafe-flvector-set! to i (unsafe-flvector-ref from i))
      (loop (unsafe-fx+ i 1)))))

;; x + a p
(define (along x a p)
  (for/flvector #:length (flvector-length x) ([u (in-flvector x)] [v (in-flvector p)])
    (fl+ u (fl* a v))))

(define (difference v w) (along v -1.0 w))

(define (dot v w)
  (for/fold ([sum 0.0]) ([x (in-flvector v)] [y (in-flvector w)]) (fl+ sum (fl* x y))))

;; Euclid's length.
(define (norm v) (flsqrt (dot v v)))

;; The greatest absolute value of a component, and of a difference of components.
(define (greatest v)
  (for/fold ([m 0.0]) ([x (in-flvector v)]) (flmax m (flabs x))))
(define (distance v w)
  (for/fold ([m 0.0]) ([x (in-flvector v)] [y (in-flvector w)]) (flmax m (flabs (fl- x y)))))

;; Is each component of p at most a part of 1 + |x|?
(define (short? p x part)
  (for/and ([u (in-flvector p)] [v (in-flvector x)])
    (fl<= (flabs u) (fl* part (fl+ 1.0 (flabs v))))))

(define (flvector-swap! v i j)
  (define x (flvector-ref v i))
  (flvector-set! v i (flvector-ref v j))
  (flvector-set! v j x))
