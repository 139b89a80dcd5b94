#lang racket/base
;; Integrals up to an end where the function may be infinite, in the logarithm of the distance.
;;
;; With x = a + e^(−u), ∫ f(x) dx up to a is ∫ g(u) du to infinity, g = e^(−u) f.  A
;; power near a is an exponential there, and a function that only seems to be infinite, as
;; 1/√(x + 10⁻¹²) does from afar, is as smooth.  It is integrated as far as numbers go.
;; Where g falls there as e^(−ru), g/r is left; how much that may be wrong is told by r
;; measured twice, and by the digits that the distance has lost.

(require racket/flonum
         "gauss-kronrod.rkt" "tail.rkt"
         "../finite-number.rkt")

(provide integral-in-logarithm same-power-to-the-end?)

(define most-panels 80)
(define least-rate 0.02)               ; of the fall of g at the far end

;; The integral from one point to an end and a bound of its error; #f twice if too much is
;; left where numbers end.
(define (integral-in-logarithm f from end tolerance)
  (define side (if (< from end) -1.0 1.0))
  (define g (in-logarithm f end side -1.0))
  (define start (- (fllog (flabs (- from end)))))
  (define last (last-seen g start (deepest end)))
  (define size (rough-size g start))
  (define-values (left off)
    (if (and size (> last (+ start 4.0))) (what-is-left g last end) (values #f #f)))
  (define (little? x) (<= x (* 0.1 tolerance size)))
  (cond
    [(and left (little? off))
     (define-values (value bound)
       (quadrature/error (lambda (u) (or (g u) +inf.0)) start last
                         #:tolerance (* 0.1 tolerance) #:limit most-panels #:search? always))
     (values (- (* side (+ value left))) (+ bound off))]
    [else (values #f #f)]))

(define (always) #t)

;; Some eight units of the last place of the end, or the smallest numbers
(define (deepest end)
  (if (fl= end 0.0) 690.0 (fl- 34.0 (fllog (flabs end)))))

;; The last u at which g is not 0.  A value may be 0 because it is too small for a flonum, or as
;; 1/(x log x) because x log x is too great for one.
(define (last-seen g low high)
  (define (seen? u)
    (define y (g u))
    (and y (not (= y 0.0))))
  (if (seen? high)
      high
      (for/fold ([low low] [high high] #:result low) ([_ (in-range 30)])
        (define middle (* 0.5 (+ low high)))
        (if (seen? middle) (values middle high) (values low middle)))))

;; ∫ |g|, from some values; #f where g goes up and down all the time, as sin(1/x) makes it:
;; oscillating.rkt is for that.
(define (rough-size g start)
  (define step 0.31)
  (define ys (for/list ([k (in-range 60)]) (or (g (+ start (* step k))) 0.0)))
  (define changes
    (for/sum ([y (in-list ys)] [next (in-list (cdr ys))])
      (if (or (< y 0.0 next) (< next 0.0 y)) 1 0)))
  (and (<= changes 15)
       (for/sum ([y (in-list ys)]) (* step (abs y)))))

;; ∫ g from u on, if g falls on as it does there, and a bound of its error; or #f twice.
(define (what-is-left g u end)
  (define-values (r before) (values (rate g (- u 2.0) u) (rate g (- u 4.0) (- u 2.0))))
  (cond
    [(and r before (> r least-rate))
     (define left (/ (g u) r))
     (define lost (* 1e-16 (abs end) (exp u)))
     (define off (+ (abs (/ (- r before) r)) (* lost (abs (- 1.0 r))) 1e-10))
     (values left (* 2.0 (abs left) off))]
    [else (values #f #f)]))

;; r, if g falls as e^(−ru) between u and v; or #f
(define (rate g u v)
  (define-values (y z) (values (g u) (g v)))
  (define r (and y z (not (= y 0.0)) (< 0.0 (/ z y) +inf.0) (/ (log (/ y z)) (- v u))))
  (and r (finite? r) r))

;; Is f near an end that is not 0 the power that it is at a distance, or nearly, as far as can
;; be seen?  1/√(x − 1 + 10⁻¹²) is not.
(define (same-power-to-the-end? f end distance)
  (define side (if (< distance 0.0) -1.0 1.0))
  (define g (in-logarithm f end side -1.0))
  (define u (- (log (abs distance))))
  (define near (rate g u (+ u 2.0)))
  (define far
    (for*/first ([from-last (in-list '(0.0 2.0 4.0))]
                 [v (in-value (- (deepest end) from-last))]
                 #:when (> v (+ u 6.0))
                 [r (in-value (rate g (- v 2.0) v))]
                 #:when r)
      r))
  (or (not near) (not far) (< (abs (- near far)) 0.15)))
