#lang racket/base
;; Polynomials through data.
;;
;; By barycentric weights (Berrut and Trefethen 2004): with wᵢ = 1/Πⱼ≠ᵢ (xᵢ − xⱼ),
;;
;;     p(x) = Σ wᵢ yᵢ/(x − xᵢ) / Σ wᵢ/(x − xᵢ),
;;
;; in n divisions for each x, and as stable as it can be.  At a point itself, where
;; that is 0/0, Lagrange's products are taken, through which derivatives pass.
;;
;; With slopes given too: Newton's divided differences, each point taken twice.

(require "interpolation-data.rkt"
         "../../generic/arithmetic.rkt" "../../generic/compare.rkt" "../../generic/function.rkt"
         "../../generic/sums-and-products.rkt")

(provide barycentric-interpolation-function Hermite-interpolation-function)

(define (barycentric-interpolation-function ys-given xs-given)
  (define who 'barycentric-interpolation-function)
  (define xs (points who xs-given))
  (define ys (values-at who "values" ys-given xs))
  (check-distinct who xs)
  (define weights (barycentric-weights xs))
  (unary-function
   (described who xs)
   (x)
   (let ([place (location who x)])
     (if (for/or ([xi (in-vector xs)]) (g:= xi place))
         (by-products xs ys x)
         (by-weights xs ys weights x)))))

;; Up to a factor, which cancels: differences in units of a quarter of the interval, so
;; that products of many neither overflow nor vanish.
(define (barycentric-weights xs)
  (define unit
    (g:/ (g:- (for/fold ([m (vector-ref xs 0)]) ([x (in-vector xs)]) (g:max m x))
              (for/fold ([m (vector-ref xs 0)]) ([x (in-vector xs)]) (g:min m x)))
         4))
  (for/vector #:length (vector-length xs) ([xi (in-vector xs)] [i (in-naturals)])
    (g:/ 1 (product-of-differences xs xi i unit))))

(define (product-of-differences xs x i unit)
  (g:for/product ([xj (in-vector xs)] [j (in-naturals)] #:unless (= i j))
    (g:/ (g:- x xj) unit)))

(define (by-weights xs ys weights x)
  (define-values (numerator denominator)
    (for/fold ([numerator 0] [denominator 0])
              ([xi (in-vector xs)] [y (in-vector ys)] [w (in-vector weights)])
      (define part (g:/ w (g:- x xi)))
      (values (g:+ numerator (g:* part y)) (g:+ denominator part))))
  (g:/ numerator denominator))

(define (by-products xs ys x)
  (g:for/sum ([xi (in-vector xs)] [y (in-vector ys)] [i (in-naturals)])
    (g:* (g:/ (product-of-differences xs x i 1)
              (product-of-differences xs xi i 1))
         y)))

(define ((described who xs))
  `(,who through ,(vector-length xs) points))

;; ---------------------------------------------------------------------------

;; The polynomial of least degree with these values and slopes.
(define (Hermite-interpolation-function ys-given slopes-given xs-given)
  (define who 'Hermite-interpolation-function)
  (define xs (points who xs-given))
  (define ys (values-at who "values" ys-given xs))
  (define slopes (values-at who "slopes" slopes-given xs))
  (check-distinct who xs)
  (define nodes (twice xs))
  (define coefficients (divided-differences nodes (twice ys) slopes))
  (unary-function
   (described who xs)
   (x)
   (newton-value coefficients (vector->list nodes) x)))

(define (twice v)
  (for*/vector #:length (* 2 (vector-length v)) ([x (in-vector v)] [_ (in-range 2)]) x))

;; f[z₀], f[z₀ z₁], ...; of a point and itself, the slope
(define (divided-differences zs ys slopes)
  (define n (vector-length zs))
  (let loop ([order 1] [column ys] [found (list (vector-ref ys 0))])
    (if (= order n)
        (reverse found)
        (let ([next
               (for/vector #:length (- n order) ([i (in-range (- n order))])
                 (if (and (= order 1) (even? i))
                     (vector-ref slopes (quotient i 2))
                     (g:/ (g:- (vector-ref column (+ i 1)) (vector-ref column i))
                          (g:- (vector-ref zs (+ i order)) (vector-ref zs i)))))])
          (loop (+ order 1) next (cons (vector-ref next 0) found))))))

;; c₀ + (x − z₀)(c₁ + (x − z₁)(c₂ + ...))
(define (newton-value coefficients zs x)
  (if (null? (cdr coefficients))
      (car coefficients)
      (g:+ (car coefficients)
           (g:* (g:- x (car zs)) (newton-value (cdr coefficients) (cdr zs) x)))))
