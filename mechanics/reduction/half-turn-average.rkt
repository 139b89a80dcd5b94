#lang racket/base
;; The average over half a turn, (1/π) ∫ f dv from 0 to π, of an f that is smooth and even about
;; both ends.
;;
;; The mean of its values at evenly spaced v converges with all powers of the spacing, and none at
;; an end is asked for.  But for an orbit that is nearly a line, as that of a comet, f changes
;; within a small part of the turn, next to an end, which even spacing does not find: there both
;; quarters are integrated by panels that are halved where f changes.
;;
;; f is given by two functions, of the distance from either end, which keeps all its digits there.

(require "../numeric/constants.rkt"
         "../numeric/quadrature/gauss-kronrod.rkt")

(provide average-over-half-turn)

(define fewest 16)
(define many 512)                ; points that few smooth f need; then panels are tried
(define most 8192)
(define closeness 1e-12)
(define noise 1e-9)              ; left by rounding, where f is a small difference

;; from-low, from-high : v -> flonum, for v up to π/2;  fail : value error ->
(define (average-over-half-turn from-low from-high fail)
  (define (average n)
    (define spacing (/ pi n))
    (for/fold ([sum 0.0] #:result (/ sum n)) ([k (in-range (quotient n 2))])
      (define v (* (+ k 0.5) spacing))
      (+ sum (from-low v) (from-high v))))
  (let double ([n fewest] [before +inf.0])
    (define value (average n))
    (define change (abs (- value before)))
    (cond [(<= change (* closeness (abs value))) value]
          [(and (= n many) (average-by-panels from-low from-high))]
          [(< n most) (double (* 2 n) value)]
          [(<= change (* noise (abs value))) value]
          [else (fail value change)])))

;; -> the average, or #f where panels do not help, as against rounding
(define (average-by-panels from-low from-high)
  (define-values (low low-error) (over-quarter from-low))
  (define-values (high high-error) (over-quarter from-high))
  (and (<= (+ low-error high-error) (* noise (abs (+ low high))))
       (/ (+ low high) pi)))

;; -> the integral and a bound of its error, which may be large, or neither where f overflows
(define (over-quarter f)
  (let/ec return
    (define (value v)
      (define y (f v))
      (if (rational? y) y (return +nan.0 +nan.0)))
    (quadrature/error value 0.0 (/ pi 2.0) #:tolerance closeness #:limit most-panels
                      #:stuck (lambda (value bound x) (return value bound)))))

(define most-panels 400)
