#lang racket/base
;; Intervals between integers at the scale 2^-p, with the elementary functions by
;; their Taylor series.
;;
;; A function of an exact point m·2^-p is computed with `guard` more bits by a series
;; whose argument is at most 1/2; every operation rounds by one unit at most and there
;; are fewer than 2^20 of them, so that the error is well below one unit of the scale
;; p, by which the result is widened.

(require "interval.rkt")

(provide fixed-intervals)

(define guard 40)

;; snap? : is an interval about 0 of less than 2^(-3p/4) taken for 0?  That proves nothing, but
;; with thousands of bits there is no doubt.
(define (fixed-intervals p #:snap? [snap? #f])
  (define tiny (if snap? (arithmetic-shift 1 (quotient p 4)) 0))
  (define one (arithmetic-shift 1 p))
  (define (down x) (arithmetic-shift x (- p)))
  (define (up x) (- (arithmetic-shift (- x) (- p))))
  (define (checked low high)
    (when (> (max (integer-length low) (integer-length high)) (+ p 3000)) (fail-unknown))
    (if (and (<= low 0 high) (< (- high low) tiny)) (interval 0 0) (interval low high)))
  (define (from q) (checked (floor (* q one)) (ceiling (* q one))))
  (define (multiply i j)
    (define-values (a b c d)
      (values (interval-low i) (interval-high i) (interval-low j) (interval-high j)))
    (define-values (x y z w) (values (* a c) (* a d) (* b c) (* b d)))
    (checked (down (min x y z w)) (up (max x y z w))))
  (define (inverse j)
    (unless (or (positive-interval? j) (negative-interval? j)) (fail-unknown))
    (interval (quotient-down (* one one) (interval-high j))
              (- (quotient-down (- (* one one)) (interval-low j)))))
  (define (square i)
    (define-values (a b) (values (interval-low i) (interval-high i)))
    (checked (if (<= a 0 b) 0 (down (min (* a a) (* b b)))) (up (max (* a a) (* b b)))))
  (define (integer-power i n)
    (cond [(eqv? n 1) i]
          [(even? n) (square (integer-power i (quotient n 2)))]
          [else (multiply i (integer-power i (- n 1)))]))
  (define ((increasing f) i)
    (checked (- (f (interval-low i) p) 1) (+ (f (interval-high i) p) 1)))
  (define ((wave f) i)
    (define-values (a b) (values (interval-low i) (interval-high i)))
    (define radius (+ 2 (- b a)))
    (define y (f (quotient-down (+ a b) 2) p))
    (checked (max (- one) (- y radius)) (min one (+ y radius))))
  (arithmetic from
              (lambda (m) (/ m one))
              (lambda (i j) (checked (+ (interval-low i) (interval-low j))
                                     (+ (interval-high i) (interval-high j))))
              (lambda (i j) (checked (- (interval-low i) (interval-high j))
                                     (- (interval-high i) (interval-low j))))
              multiply
              (lambda (i j) (multiply i (inverse j)))
              integer-power
              (increasing (lambda (m p) (integer-sqrt (* (max 0 m) one))))
              (increasing exp-point) (increasing log-point)
              (wave sin-point) (wave cos-point) (increasing atan-point)
              (lambda () (let ([m (rescaled (pi-at (+ p guard)) guard)])
                           (interval (- m 1) (+ m 1))))
              (lambda (i j) (interval (min (interval-low i) (interval-low j))
                                      (max (interval-high i) (interval-high j))))))

(define (quotient-down a b) (floor (/ a b)))
(define (rescaled m bits) (arithmetic-shift m (- bits)))

;; ---------------------------------------------------------------------------
;; Series.  m and the result are at the scale q.

(define (product a b q) (arithmetic-shift (* a b) (- q)))

;; Σ tₖ until the terms vanish; next : term, k -> term
(define (sum-series first next)
  (let loop ([sum 0] [term first] [k 0])
    (if (eqv? term 0) sum (loop (+ sum term) (next term k) (+ k 1)))))

(define truncated quotient)             ; towards 0, so that terms end

;; Σ (±1)ᵏ z^(2k+1)/(2k+1): artanh z or arctan z
(define (odd-series z sign q)
  (define z² (product z z q))
  (let loop ([sum 0] [power z] [k 0])
    (if (<= -1 power 1)
        sum
        (loop (+ sum (truncated (if (and (negative? sign) (odd? k)) (- power) power)
                                (+ k k 1)))
              (truncated (* power z²) (arithmetic-shift 1 q))
              (+ k 1)))))

(define-syntax-rule (define-constant (name q) body)
  (define name
    (let ([known (make-hasheqv)])
      (lambda (q) (or (hash-ref known q #f)
                      (let ([m body]) (hash-set! known q m) m))))))

(define (reciprocal n q) (quotient (arithmetic-shift 1 q) n))

;; Machin's formula, and one of Gauss's kind for log 2.
(define-constant (pi-at q)
  (let ([q+ (+ q 20)])
    (rescaled (* 4 (- (* 4 (odd-series (reciprocal 5 q+) -1 q+))
                      (odd-series (reciprocal 239 q+) -1 q+)))
              20)))
(define-constant (log2-at q)
  (let ([q+ (+ q 20)])
    (rescaled (+ (* 18 (odd-series (reciprocal 26 q+) 1 q+))
                 (* -2 (odd-series (reciprocal 4801 q+) 1 q+))
                 (* 8 (odd-series (reciprocal 8749 q+) 1 q+)))
              20)))

;; ---------------------------------------------------------------------------
;; Functions of points: m at the scale p -> the value at the scale p, to one unit.

;; e^x = 2ᵏ e^r, r = x - k log 2.
(define (exp-point m p)
  (define size (rescaled m p))
  (when (> (abs size) 2000) (fail-unknown))
  (define k (round (/ m (log2-at p))))
  (define q (+ p guard (max 0 k)))
  (define r (- (arithmetic-shift m (- q p)) (* k (log2-at q))))
  (define y
    (sum-series (arithmetic-shift 1 q)
                (lambda (term n) (truncated (* term r) (* (+ n 1) (arithmetic-shift 1 q))))))
  (arithmetic-shift y (+ k (- p q))))

;; log (2ᵏ f) = k log 2 + 2 artanh ((f-1)/(f+1)), 1/2 < f <= 1.
(define (log-point m p)
  (unless (> m 0) (fail-unknown))       ; less than the scale shows
  (define q (+ p guard))
  (define k (- (integer-length m) p))
  (define f (arithmetic-shift m (- q p k)))
  (define one (arithmetic-shift 1 q))
  (define z (truncated (* (- f one) one) (+ f one)))
  (rescaled (+ (* k (log2-at q)) (* 2 (odd-series z 1 q))) guard))

;; x - n π/2 at the scale q, and n.
(define (reduced-angle m p)
  (define q (+ p guard (max 0 (- (integer-length m) p))))
  (define quarter (pi-at q))                    ; π at q is π/2 at q+1
  (define x (arithmetic-shift m (+ 1 (- q p))))
  (define n (round (/ x quarter)))
  (values (rescaled (- x (* n quarter)) 1) n q))

(define (trigonometric m p shift)
  (define-values (r n q) (reduced-angle m p))
  (define-values (y negative)
    (case (modulo (+ n shift) 4)
      [(0) (values (sine r q) #f)]
      [(1) (values (cosine r q) #f)]
      [(2) (values (sine r q) #t)]
      [else (values (cosine r q) #t)]))
  (rescaled (if negative (- y) y) (- q p)))

(define (sin-point m p) (trigonometric m p 0))
(define (cos-point m p) (trigonometric m p 1))

(define (waves first r q offset)
  (define -r² (- (product r r q)))
  (sum-series first
              (lambda (term k)
                (truncated (* term -r²)
                           (* (+ k k 1 offset) (+ k k 2 offset) (arithmetic-shift 1 q))))))

(define (sine r q) (waves r r q 1))
(define (cosine r q) (waves (arithmetic-shift 1 q) r q 0))

;; atan x = π/2 - atan 1/x above 1; then the angle is halved three times,
;; x -> x/(1 + √(1 + x²)).
(define (atan-point m p)
  (define q (+ p guard))
  (define one (arithmetic-shift 1 q))
  (define (halved x)
    (quotient (* x one) (+ one (integer-sqrt (* one (+ one (product x x q)))))))
  (define (below-1 x) (* 8 (odd-series (halved (halved (halved x))) -1 q)))
  (define x (arithmetic-shift (abs m) guard))
  (define y
    (if (> x one)
        (- (rescaled (pi-at q) 1) (below-1 (quotient (* one one) x)))
        (below-1 x)))
  (* (if (negative? m) -1 1) (rescaled y guard)))
