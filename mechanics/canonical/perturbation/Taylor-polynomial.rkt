#lang racket/base
;; The Taylor polynomials of an expression, of which the symbols are polynomials themselves: its
;; homogeneous parts up to a degree, as complex-polynomial.rkt has polynomials.
;;
;; Sums and products are those of truncated series.  A function f of one of them, c + u with the
;; constant c, is f(c) + f′(c) u + f″(c) u²/2 + ⋯, by Horner's rule; the derivatives are those of
;; `calculus/`, for any function that it knows.  Each shared part is expanded once.

(require "complex-polynomial.rkt"
         "../../algebra/expression/constant-value.rkt" "../../algebra/expression/expression.rkt"
         "../../algebra/expression/operation.rkt"
         "../../calculus/derivative.rkt" "../../calculus/expression-function.rkt"
         "../../generic/arithmetic.rkt" "../../generic/elementary.rkt"
         (only-in "../../generic/number-argument.rkt" known-number))

(provide Taylor-parts)

;; A series is a vector of polynomials, of degree 0, 1, …, degree.

;; places : ((symbol constant . polynomial of degree 1) …);  (fail part) where part is no number
;; -> a series
(define (Taylor-parts e places degree fail)
  (define (constant c) (make-series degree (list (monomial c))))
  (define (leaf x)
    (define place (and (symbol? x) (assq x places)))
    (cond [(number? x) (constant x)]
          [place (make-series degree (list (monomial (cadr place)) (cddr place)))]
          [(constant-value x) => constant]
          [else (fail x)]))
  (node-fold e leaf (lambda (node parts) (operation node parts degree (lambda () (fail node))))))

(define (monomial c) (make-hasheqv (if (eqv? c 0) '() (list (cons 0 c)))))

(define (make-series degree parts)
  (define s (build-vector (add1 degree) (lambda (d) (make-hasheqv))))
  (for ([p (in-list parts)] [d (in-range (add1 degree))]) (vector-set! s d p))
  s)

(define (constant-of s) (hash-ref (vector-ref s 0) 0 0))
(define (constant? s) (for/and ([f (in-vector s 1)]) (zero? (hash-count f))))

(define (sum s t) (for/vector ([f (in-vector s)] [g (in-vector t)]) (polynomial-sum f g)))
(define (scale c s) (for/vector ([f (in-vector s)]) (polynomial-scale c f)))

;; To the degree `limit`
(define (product s t [limit (sub1 (vector-length s))])
  (for/vector ([d (in-range (vector-length s))])
    (for/fold ([p (make-hasheqv)]) ([j (in-range (if (> d limit) 0 (add1 d)))])
      (define-values (f g) (values (vector-ref s j) (vector-ref t (- d j))))
      (if (or (zero? (hash-count f)) (zero? (hash-count g)))
          p
          (polynomial-sum p (polynomial-product f g))))))

;; ---------------------------------------------------------------------------

(define (operation node parts degree fail)
  (define head (node-head node))
  (define (binary combine) (for/fold ([s (car parts)]) ([t (in-list (cdr parts))]) (combine s t)))
  (define (reciprocal s) (composed (lambda (x) (g:/ 1 x)) s degree fail))
  (cond
    [(andmap constant? parts)
     (make-series degree
                  (list (monomial (number-or fail (apply-generically head
                                                                     (map constant-of parts))))))]
    [(eq? head op:+) (binary sum)]
    [(eq? head op:*) (binary product)]
    [(eq? head op:-) (if (null? (cdr parts)) (scale -1 (car parts))
                         (binary (lambda (s t) (sum s (scale -1 t)))))]
    [(eq? head op:/) (if (null? (cdr parts)) (reciprocal (car parts))
                         (binary (lambda (s t) (product s (reciprocal t)))))]
    [(one-that-varies parts)
     => (lambda (k)
          (define (f x)
            (apply-generically head (for/list ([s (in-list parts)] [j (in-naturals)])
                                      (if (= j k) x (constant-of s)))))
          (composed f (list-ref parts k) degree fail))]
    [(eq? head op:expt)                 ; exp(t log s)
     (composed g:exp (product (cadr parts) (composed g:log (car parts) degree fail)) degree fail)]
    [(eq? head op:atan) (angle (car parts) (cadr parts) degree fail)]
    [else (fail)]))

;; atan(y, x) is its constant, and the angle from there.
(define (angle y x degree fail)
  (define-values (y0 x0) (values (constant-of y) (constant-of x)))
  (define across (sum (scale x0 y) (scale (- y0) x)))
  (define along (sum (scale x0 x) (scale y0 y)))
  (define turned (product across (composed (lambda (r) (g:/ 1 r)) along degree fail)))
  (sum (make-series degree (list (monomial (number-or fail (g:atan y0 x0)))))
       (composed g:atan turned degree fail)))

(define (number-or fail x)
  (cond [(number? x) x]
        [(known-number x)]
        [else (fail)]))

;; The index of the only argument that is no constant, or #f
(define (one-that-varies parts)
  (define found (for/list ([s (in-list parts)] [k (in-naturals)] #:unless (constant? s)) k))
  (and (null? (cdr found)) (car found)))

(define (composed f s degree fail)
  (define c (constant-of s))
  (define derivatives
    (for/list ([d (in-list (derivatives-at f c degree))]) (number-or fail d)))
  (define u (for/vector ([f (in-vector s)] [d (in-naturals)]) (if (= d 0) (make-hasheqv) f)))
  (define-values (result _)
    (for/fold ([r (make-series degree '())] [k degree]) ([d (in-list (reverse derivatives))])
      (define coefficient (/ d (for/product ([i (in-range 1 (add1 k))]) i)))
      (values (sum (product r u (- degree k)) (make-series degree (list (monomial coefficient))))
              (sub1 k))))
  result)
