#lang racket/base
;; Exponential, logarithm, sine, cosine and angle of balls.
;;
;; Each is computed at the ball's middle, in fixed point, and the radius is that of the argument
;; times a bound for the derivative.  A logarithm is a flonum y and the logarithm of x e^(-y),
;; which is so close to 1 that few terms of a series suffice; an angle is a flonum θ and the
;; angle that is left of the point turned by -θ.  Nothing rests on the flonums being right.

(require "ball.rkt" "fixed-point.rkt")

(provide ball-exp ball-log ball-sin ball-cos ball-angle
         small-argument-precision)

;; The middle of b in units of 2^-w, low by less than one.
(define (fixed b w) (arithmetic-shift (ball-middle b) (+ (ball-scale b) w)))

;; The radius of b in units of 2^-w, rounded up.
(define (fixed-radius b w) (shift-up (ball-radius b) (+ (ball-scale b) w)))

;; A ball of radius 1 or more gives no angle, and no exponential.
(define (check-radius b)
  (define r (ball-radius b))
  (unless (or (eqv? r 0) (<= (+ (integer-length r) (ball-scale b)) 0)) (raise unknown)))

;; A power of 2 above the ball's middle.
(define (middle-magnitude b) (+ (integer-length (ball-middle b)) (ball-scale b)))

;; Bits behind the point that give at least p of a value about as small as b.
(define (small-argument-precision b p)
  (define k (ball-magnitude b))
  (if (negative? k) (+ p (min (- k) (+ 512 (* 4 p)))) p))

;; ---------------------------------------------------------------------------
;; Exponential and logarithm

;; Greater arguments than 2^24 make numbers that are not asked for.
(define exp-bits 24)

;; x = k log 2 + r, where the error of k log 2 is less than one of the last bits but `spare`.
(define spare 28)

(define (ball-exp x p)
  (check-radius x)
  (when (> (middle-magnitude x) exp-bits) (raise unknown))
  (define w (+ p 16))
  (define-values (y bound k) (exp-and-exponent (fixed x (+ w spare)) w))
  ;; e^(x + ρ) - e^x <= 2 ρ e^x for ρ <= 1
  (define spread (shift-up (* (+ y bound) (ball-radius x)) (+ 1 (ball-scale x))))
  (make-ball y (+ bound spread) (- k w) p))

;; X : in units of 2^-(w + spare), within one unit
;; -> y bound k, where the exponential is y 2^k, y in units of 2^-w
(define (exp-and-exponent X w)
  (define log2 (log2-fixed (+ w spare)))
  (define k (whole-quotient X log2))
  (define r (arithmetic-shift (- X (* k log2)) (- spare)))
  (define-values (y bound) (exp-fixed r w))
  (values y (+ bound 5) k))

;; log (m 2^e) = k log 2 + log f, where f = m 2^(e - k) is between 1/2 and 2.
(define (ball-log x p)
  (cond [(<= (ball-upper x) 0) (raise no-value)]
        [(<= (ball-lower x) 0) (raise unknown)])
  (define m (ball-middle x))
  (define n (integer-length m))
  (define above? (>= (* 2 m m) (arithmetic-shift 1 (* 2 n))))    ; f = m 2^-n >= √(1/2)
  (define f-scale (if above? (- n) (- 1 n)))
  (define k (- (ball-scale x) f-scale))
  (define near-one (- (+ (integer-length (- m (arithmetic-shift 1 (- f-scale)))) f-scale)))
  (define w (+ p 16 (if (eqv? k 0) (max 0 (min near-one (* 4 p))) 0)))
  (define-values (y bound) (log-of-fraction m f-scale w))
  (define long (+ w (integer-length k)))
  (define multiple (arithmetic-shift (* k (log2-fixed long)) (- w long)))
  ;; log (x + ρ) - log x <= ρ/(x - ρ)
  (define spread
    (+ 1 (quotient (arithmetic-shift (ball-radius x) w) (ball-lower x))))
  (make-ball (+ y multiple) (+ bound spread 4) (- w) p))

;; log (m 2^e), between 1/2 and 2, in units of 2^-w, with a bound of its error
(define (log-of-fraction m e w)
  (define y (rounded-flonum (log (exact->inexact (* m (expt 2 e))))))
  (define-values (g bound k)
    (if (eqv? y 0)
        (values (arithmetic-shift 1 w) 0 0)
        (exp-and-exponent (fixed (ball (- y) 0 (- flonum-bits)) (+ w spare)) w)))
  (define one (arithmetic-shift 1 w))
  (define z (arithmetic-shift (* m g) (+ e k)))       ; x e^(-y), an error of at most 2 more
  (define d (- z one))
  (unless (< (abs d) (arithmetic-shift one -8)) (raise unknown))
  (define-values (series series-error)
    (atanh-fixed (quotient (arithmetic-shift d w) (+ one z)) w))
  (values (+ (arithmetic-shift y (- w flonum-bits)) (* 2 series))
          (+ (* 2 series-error) 6 (* 4 (+ 1 bound)))))

;; A flonum of moderate size in units of 2^-flonum-bits.
(define flonum-bits 50)
(define (rounded-flonum y)
  (if (rational? y) (inexact->exact (round (* y (expt 2.0 flonum-bits)))) (raise unknown)))

;; ---------------------------------------------------------------------------
;; Sine and cosine

;; Arguments beyond 2^4096 would be reduced in vain.
(define angle-bits 4096)

(define (ball-sin x p) (wave x 0 (small-argument-precision x p) p))
(define (ball-cos x p) (wave x 1 p p))

;; sin (x + n π/2); x + n π/2 = r + k π/2
(define (wave x n precise p)
  (check-radius x)
  (define bits (max 0 (middle-magnitude x)))
  (when (> bits angle-bits) (raise unknown))
  (define w (+ precise 16))
  (define long (+ w bits 4))
  (define-values (y bound) (sine (fixed x long) n long w))
  (make-ball y (+ bound (fixed-radius x w)) (- w) p))

;; sin (x + n π/2) in units of 2^-w, with a bound of its error; X : x in smaller units of
;; 2^-long, so that the error of k π is less than one unit.
(define (sine X n long w)
  (define pi (pi-fixed long))
  (define k (whole-quotient (+ (* 4 X) pi) (* 2 pi)))
  (define r (arithmetic-shift (- (* 2 X) (* k pi)) (- w long 1)))
  (define-values (y bound) (quarter-turned r (+ k n) w))
  (values y (+ bound 3)))

(define (whole-quotient a b) (quotient (- a (modulo a b)) b))

;; sin (r + k π/2)
(define (quarter-turned r k w)
  (define-values (y bound) (if (even? k) (sin-fixed r w) (cos-fixed r w)))
  (values (if (bitwise-bit-set? k 1) (- y) y) bound))

;; ---------------------------------------------------------------------------
;; The angle of the point (x, y)

;; Within the box of the two balls the angle is smooth if neither the origin nor the negative
;; half of the x-axis is met; its gradient is 1/(distance from the origin).
(define (ball-angle y x p)
  (define e (min (ball-scale x) (ball-scale y)))
  (define (units f b) (arithmetic-shift (f b) (- (ball-scale b) e)))
  (define far (- (max (ball-magnitude x) (ball-magnitude y)) e))
  (when (> far (+ 4096 (* 8 p))) (raise unknown))
  (define r (+ (units ball-radius x) (units ball-radius y)))
  (define X (units ball-middle x))
  (define Y (units ball-middle y))
  (define room (- (max (abs X) (abs Y)) r))
  (unless (and (positive? room) (away-from-cut? y x)) (raise unknown))
  (define small (if (positive? X) (- (integer-length X) (integer-length Y)) 0))
  (define w (+ p 16 (max 0 (min small (* 4 p)))))
  (define-values (angle bound) (angle-of-point Y X w))
  (define spread (if (eqv? r 0) 0 (+ 1 (quotient (arithmetic-shift r w) room))))
  (make-ball angle (+ bound spread) (- w) p))

;; On the cut itself the angle is π; balls of radius 0 may be there.
(define (away-from-cut? y x)
  (or (ball-positive? x) (ball-positive? y) (ball-negative? y) (eqv? 0 (ball-radius y))))

;; The angle in units of 2^-w, with a bound of its error.
(define (angle-of-point Y X w)
  (define n (max (integer-length X) (integer-length Y)))
  (define x (arithmetic-shift X (- w n)))             ; the greater is between 1/2 and 1
  (define y (arithmetic-shift Y (- w n)))
  (define theta (rounded-flonum (flonum-angle Y X n)))
  (define long (+ w 8))
  (define turn (arithmetic-shift theta (- long flonum-bits)))
  (define-values (c c-error) (sine turn 1 long w))
  (define-values (s s-error) (sine turn 0 long w))
  (define across (- (arithmetic-shift (* y c) (- w)) (arithmetic-shift (* x s) (- w))))
  (define along (+ (arithmetic-shift (* x c) (- w)) (arithmetic-shift (* y s) (- w))))
  (define bound (+ c-error s-error 6))                ; of across, and of along
  (unless (and (> along (arithmetic-shift 1 (- w 2)))
               (< (abs across) (arithmetic-shift along -8)))
    (raise unknown))
  (define-values (rest rest-error) (atan-fixed (quotient (arithmetic-shift across w) along) w))
  (values (+ (arithmetic-shift theta (- w flonum-bits)) rest)
          (+ rest-error 2 (* 8 bound))))

(define (flonum-angle Y X n)
  (define (leading k) (exact->inexact (arithmetic-shift k (- 60 n))))
  (atan (leading Y) (leading X)))
