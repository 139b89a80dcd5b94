#lang racket/base
;; Balls: numbers known to within a bound that is proved.
;;
;; A ball is the set of all reals within `radius` of `middle`, both integers in units of
;; 2^scale.  An operation on balls makes one that holds every value which the operation has at
;; points of theirs: bounds on derivatives widen it, and where digits are dropped, so that no
;; middle grows beyond the precision asked for, the radius grows by the most they may have been
;; worth.  Hence a ball without 0 is a proof that its number is not 0.
;;
;; Where the operation has no real value at any point of a ball, this is raised as `no-value`;
;; where it has none at some points, or jumps among them, or is too long to compute, as
;; `unknown`: at a higher precision the answer may be another.  The precision p is in bits.

(provide (struct-out ball)
         ;; raised instead of a ball
         no-value unknown
         ;; balls from numbers, numbers from balls
         exact->ball flonum->ball make-ball ball-lower ball-upper ball-magnitude
         ball-positive? ball-negative?
         ;; arithmetic
         ball+ ball- ball-negate ball* ball/ ball-sqrt ball-abs
         shift-up)

(struct ball (middle radius scale) #:authentic)

(define no-value 'no-value)
(define unknown 'unknown)

;; More bits than these no radius has: they would bound nothing better.
(define radius-bits 30)

;; Scales beyond these are of numbers that nobody asked for, such as 2^2^2^2^2^2.
(define most-scale (expt 2 40))

;; The ball around m of radius r, in units of 2^e, with a middle of no more than p bits.
(define (make-ball m r e p)
  (define k (max 0 (- (integer-length m) p) (- (integer-length r) radius-bits)))
  (define scale (+ e k))
  (unless (< (- most-scale) scale most-scale) (raise unknown))
  (if (eqv? k 0)
      (ball m r scale)
      (ball (arithmetic-shift m (- k)) (+ 2 (arithmetic-shift r (- k))) scale)))

(define (exact->ball x p)
  (cond [(exact-integer? x) (make-ball x 0 0 p)]
        [else
         (define m (numerator x))
         (define n (denominator x))
         (define s (max 0 (- (+ p (integer-length n)) (integer-length m))))
         (make-ball (quotient (arithmetic-shift m s) n) 1 (- s) p)]))

;; A flonum may be the result of some operations on others, such as (square (sqrt 2)), and is
;; taken to be uncertain by sixteen units in its last place.
(define (flonum->ball x p)
  (define exact (inexact->exact x))

  (define m (numerator exact))
  (define extra (max 0 (- 53 (integer-length m))))
  (make-ball (arithmetic-shift m extra)
             (shift-up (abs (arithmetic-shift m extra)) -48)
             (- 1 (integer-length (denominator exact)) extra)
             p))

;; n 2^k, rounded up; n is not negative.
(define (shift-up n k) (- (arithmetic-shift (- n) k)))

(define (ball-lower b) (- (ball-middle b) (ball-radius b)))
(define (ball-upper b) (+ (ball-middle b) (ball-radius b)))

;; k, where no point of the ball is beyond 2^k.
(define (ball-magnitude b)
  (+ (integer-length (+ (abs (ball-middle b)) (ball-radius b))) (ball-scale b)))

(define (ball-positive? b) (> (ball-middle b) (ball-radius b)))
(define (ball-negative? b) (< (ball-middle b) (- (ball-radius b))))

;; ---------------------------------------------------------------------------
;; Arithmetic

(define (ball+ a b p)
  (if (>= (ball-scale a) (ball-scale b)) (add a b p) (add b a p)))

;; a has the greater unit.  It is made smaller, but not by so much that more digits of b
;; remain than are wanted.
(define (add a b p)
  (define d (- (ball-scale a) (ball-scale b)))
  (define s (min d (+ p 64)))
  (define (both f lost) (+ (arithmetic-shift (f a) s) (arithmetic-shift (f b) (- s d)) lost))
  (make-ball (both ball-middle 0) (both ball-radius (if (eqv? s d) 0 2)) (- (ball-scale a) s) p))

(define (ball-negate a) (ball (- (ball-middle a)) (ball-radius a) (ball-scale a)))

(define (ball- a b p) (ball+ a (ball-negate b) p))

(define (ball* a b p)
  (define m (ball-middle a))
  (define n (ball-middle b))
  (define r (ball-radius a))
  (define s (ball-radius b))
  (make-ball (* m n) (+ (* (abs m) s) (* r (+ (abs n) s))) (+ (ball-scale a) (ball-scale b)) p))

;; (m + δ)/(n + ε) - m/n = (δ - ε m/n)/(n + ε).
(define (ball/ a b p)
  (define m (ball-middle a))
  (define n (ball-middle b))
  (define room (- (abs n) (ball-radius b)))
  (unless (positive? room) (raise (if (eqv? 0 (+ (abs n) (ball-radius b))) no-value unknown)))
  (cond [(eqv? 0 (+ (abs m) (ball-radius a))) a]
        [else
         (define s (max 0 (- (+ p (integer-length n)) (integer-length m))))
         (define q (quotient (arithmetic-shift m s) n))
         (define spread
           (+ (arithmetic-shift (ball-radius a) s) (* (+ (abs q) 1) (ball-radius b))))
         (make-ball q (+ 2 (quotient spread room)) (- (ball-scale a) (ball-scale b) s) p)]))

;; |√(m + δ) - √m| <= |δ|/√m.
(define (ball-sqrt a p)
  (define m (ball-middle a))
  (cond [(negative? (ball-upper a)) (raise no-value)]
        [(negative? (ball-lower a)) (raise unknown)]
        [(eqv? m 0) a]
        [else
         (define least (max 0 (- (* 2 p) (integer-length m))))
         (define s (if (even? (- (ball-scale a) least)) least (+ least 1)))
         (define root (integer-sqrt (arithmetic-shift m s)))
         (make-ball root
                    (if (eqv? 0 (ball-radius a))
                        1
                        (+ 2 (quotient (arithmetic-shift (ball-radius a) s) root)))
                    (quotient (- (ball-scale a) s) 2)
                    p)]))

(define (ball-abs a)
  (cond [(ball-negative? a) (ball-negate a)]
        [(ball-positive? a) a]
        [else                            ; from 0 to the farther end
         (define far (+ (abs (ball-middle a)) (ball-radius a)))
         (ball far far (- (ball-scale a) 1))]))
