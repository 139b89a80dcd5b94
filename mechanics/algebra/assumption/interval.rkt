#lang racket/base
;; Intervals of real numbers, with their ends, which are exact or infinite: sums, products,
;; powers, and the values of sin, exp and the like.
;;
;; An interval may be too wide, never too narrow.  Flonums are within 4·10⁻¹⁵ of the values
;; of elementary functions, by which they are moved outwards.

(require racket/math
         (only-in "../expression/numeric-functions.rkt" erf)
         "../../operation/operation-column.rkt")

(provide (struct-out interval) everything point-interval interval-ends intersection
         interval-sum interval-product interval-quotient interval-power interval-magnitude
         interval-of-operation)

(struct interval (low high) #:authentic)

(define everything (interval -inf.0 +inf.0))
(define not-negative (interval 0 +inf.0))
(define unit (interval -1 1))
(define quarter-turn 11/7)              ; a little more than π/2

(define (point-interval x) (interval x x))

;; -> low and high
(define (interval-ends r) (values (interval-low r) (interval-high r)))

;; The intersection of two intervals that overlap.
(define (intersection r s)
  (interval (greatest (interval-low r) (interval-low s))
            (least (interval-high r) (interval-high s))))

;; ---------------------------------------------------------------------------
;; Arithmetic

(define (interval-sum r s)
  (interval (+ (interval-low r) (interval-low s)) (+ (interval-high r) (interval-high s))))

(define (interval-product r s)
  (define corners
    (for*/list ([x (in-list (list (interval-low r) (interval-high r)))]
                [y (in-list (list (interval-low s) (interval-high s)))])
      (if (or (eqv? x 0) (eqv? y 0)) 0 (* x y))))
  (interval (apply least corners) (apply greatest corners)))

;; `min` and `max` make everything a flonum where one is infinite.
(define (least x . more) (for/fold ([m x]) ([y (in-list more)]) (if (< y m) y m)))
(define (greatest x . more) (for/fold ([m x]) ([y (in-list more)]) (if (> y m) y m)))

(define (interval-quotient r s)
  (define-values (low high) (interval-ends s))
  (if (or (> low 0) (< high 0))
      (interval-product r (interval (reciprocal high) (reciprocal low)))
      everything))

(define (reciprocal x) (if (infinite? x) 0 (/ 1 x)))

(define (interval-power r n)
  (cond [(and (exact-positive-integer? n) (<= n most-power))
         (define m (if (even? n) (interval-magnitude r) r))
         (interval (expt (interval-low m) n) (expt (interval-high m) n))]
        [(and (exact-integer? n) (<= (- most-power) n -1))
         (interval-quotient (point-interval 1) (interval-power r (- n)))]
        [(and (real? n) (not (integer? n))) not-negative]
        [else everything]))

(define most-power 64)

(define (interval-magnitude r)
  (define-values (low high) (interval-ends r))
  (cond [(>= low 0) r]
        [(<= high 0) (interval (- high) (- low))]
        [else (interval 0 (greatest (- low) high))]))

;; ---------------------------------------------------------------------------
;; Functions

;; The values of an operation of one argument, from r.  Where it has none, whatever it likes.
(define (interval-of-operation name r)
  (define f (hash-ref functions name #f))
  (if f (f r) everything))

;; f grows with x; beyond the domain, from `start` on, nothing is said.
(define ((growing f start range) r)
  (cond [(<= (interval-high r) start) range]
        [else
         (define low (interval-low r))
         (intersection range (interval (if (<= low start) (interval-low range) (outwards f low -1))
                                       (outwards f (interval-high r) 1)))]))

;; f(x), rounded down or up
(define (outwards f x direction)
  (define exactly (and (exact? x) (f x)))
  (cond [(and exactly (exact? exactly)) exactly]
        [else
         (define y (f (flonum-beyond x direction)))
         (cond [(not (and (real? y) (= y y))) (* direction +inf.0)]
               [(infinite? y) (if (eqv? (infinite-sign y) direction) y (* direction (- largest)))]
               [else (inexact->exact (further y direction))])]))

;; A flonum that is x, or lies beyond it in the direction.  Numbers greater than all flonums have
;; infinity beyond them on one side alone.
(define (flonum-beyond x direction)
  (define near (real->double-flonum x))
  (cond [(not (infinite? near)) (if (= (inexact->exact near) x) near (further near direction))]
        [(or (infinite? x) (eqv? (infinite-sign near) direction)) near]
        [else (* (infinite-sign near) 1e308)]))

(define largest (inexact->exact 1e308))

(define (infinite-sign y) (if (> y 0) 1 -1))

(define (further y direction) (+ y (* direction (+ (* 4e-15 (abs y)) 1e-300))))

(define-column functions
  [exp (growing exp -inf.0 not-negative)]
  [sqrt (growing sqrt 0 not-negative)]
  [log (growing log 0 everything)]
  [sinh (growing sinh -inf.0 everything)]
  [tanh (growing tanh -inf.0 unit)]
  [atan (growing atan -inf.0 (interval (- quarter-turn) quarter-turn))]
  [erf (growing erf -inf.0 unit)]
  [asin (lambda (r) (interval (- quarter-turn) quarter-turn))]
  [acos (lambda (r) (interval 0 (* 2 quarter-turn)))]
  [cosh (lambda (r)
          (define m (interval-magnitude r))
          (intersection (interval 1 +inf.0)
                        (interval (outwards cosh (interval-low m) -1)
                                  (outwards cosh (interval-high m) 1))))]
  [sin (lambda (r) (waving sin (/ pi 2) r))]
  [cos (lambda (r) (waving cos 0.0 r))]
  [abs interval-magnitude]
  [(tan asinh acosh atanh sgn) (none "signs are all that is asked of it")]
  [atan2 (none "it has two arguments")])

;; f has maxima at top + 2πk, minima in the middle between them, and is monotonic from each
;; to the next.
(define (waving f top r)
  (define-values (low high) (interval-ends r))
  (define (reaches? place)
    (define k (ceiling (- (/ (- low place) (* 2 pi)) slack)))
    (<= (+ place (* 2 pi k)) (+ high slack)))
  (define (near x direction)
    (define y (f x))
    (if (exact? y) y (+ (inexact->exact y) (* direction rounding))))
  (define (extreme choose direction) (choose (near low direction) (near high direction)))
  (if (and (< -1000 low) (< high 1000))
      (intersection unit
                    (interval (if (reaches? (+ top pi)) -1 (extreme least -1))
                              (if (reaches? top) 1 (extreme greatest 1))))
      unit))

(define slack 1e-9)
(define rounding (expt 10 -12))         ; of a number up to 1000, and of its sine
