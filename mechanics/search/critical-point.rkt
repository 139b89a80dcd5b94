#lang racket/base
;; The surroundings of a point where a search for a minimum ended.
;;
;; The gradient may vanish at a saddle, at an inflection, on a plateau.  So second derivatives
;; are looked at, exact ones where the function can be differentiated twice; and in directions
;; where these are nothing, values.  A direction in which the function falls gives a lower point
;; to go on from.
;;
;; A curvature is nothing if it vanishes within the distance that the point is uncertain by:
;; at x = 10⁻³ the second derivative of x⁴ is positive, and Newton's step from there, −x/3,
;; reaches to where it is not.

(require racket/flonum
         "objective.rkt"
         "../error/refusal.rkt"
         "../numeric/flvector.rkt" "../numeric/optimization/curvature.rkt")

(provide (struct-out outlook) look plateau?)

;; kind : that of a minimum (minimum.rkt), or 'unsettled, when Newton's step leads on from there
;; gradient : flvector or #f; curvatures : as numeric/optimization/curvature.rkt has them, or #f
;; lower : a point to go on from, or #f
(struct outlook (kind gradient curvatures lower) #:authentic)

;; Is it flat in every direction?
(define (plateau? o)
  (define c (outlook-curvatures o))
  (and (eq? (outlook-kind o) 'flat) c (all-vanishing? c)))

;; y : the value at x; values-only? : may the function not be differentiated?
(define (look t x y [values-only? #f])
  (define g (and (not values-only?) (finite-or-false (objective-gradient t x))))
  (define second (and g (finite-or-false (objective-second-derivatives t x))))
  (if second (look-exactly t x y g second) (look-at-values t x y)))

(define (finite-or-false v) (and v (flvector-finite? v) v))

(define (look-exactly t x y g second)
  (define c (curvatures second (flvector-length x)))
  (judged t x y g c
          (kinked? t x y g second)
          (lambda () (fading? t x (downward-step c g) c))
          (lambda () (long? (downward-step c g) x))))

;; fading?, unsettled? : thunks, asked in this order where there is no kink and no way down
(define (judged t x y g c kink? fading? unsettled?)
  (define (judged-as kind [lower #f]) (outlook kind g c lower))
  (cond
    [kink? (judged-as 'kink)]
    [(falling? c) (judged-as 'saddle ((lower-along t x y (direction c)) first-reach))]
    [(fading?) (judged-by-values t x y c judged-as)]
    [(unsettled?) (judged-as 'unsettled)]
    [else (judged-as 'minimum)]))

(define (falling? c) (and (< (least-curvature c) 0.0) (not (vanishing? c 0))))

(define (long? p x) (> (greatest p) (* 1e-3 (size x))))

;; Does the function rise where gradient and curvatures say that it falls?
(define (kinked? t x y g second)
  (define h (* 1e-6 (size x)))
  (define steepness (norm g))
  (define down (and (> steepness 0.0) (flvector-map (lambda (s) (/ (- s) steepness)) g)))
  (and down
       (let ([foretold (+ (* -1.0 steepness h) (* 0.5 h h (curvature-along second down)))]
             [change (- (value-beside t (along x h down)) y)])
         (and (< foretold (* -1e3 (noise y))) (> change (* -0.5 foretold))))))

;; Is the least curvature nothing within the reach of Newton's step p, or of rounding?
(define (fading? t x p c)
  (define v (direction c))
  (define least (least-curvature c))
  (define (less? s)
    (define there (and (<= 1e-300 (abs s) (* 1e-2 (size x)))
                       (objective-curvature-along t (along x s v) v)))
    (and there (< there (* 0.2 least))))
  (define step (* 3.0 (dot p v)))
  (define rounding (* 1.5e-8 (greatest x)))
  (or (vanishing? c 0) (ormap less? (list step rounding (- rounding)))))

;; The outlook at a point where some curvature vanishes.  judged : kind lower -> outlook
(define (judged-by-values t x y c judged)
  (define lower
    (for*/or ([k (in-range (flvector-length x))]
              #:when (or (= k 0) (vanishing? c k))
              [reach (in-list reaches)])
      ((lower-along t x y (direction c k)) reach)))
  (judged (if (level? t x y (direction c)) 'flat 'degenerate) lower))

;; Are all values on both sides equal?
(define (level? t x y v)
  (for*/and ([reach '(1e-3 1e-2 1e-1)] [sign '(1.0 -1.0)])
    (define there (value-beside t (along x (* sign reach (size x)) v)))
    (<= (abs (- there y)) (noise y))))

;; ---------------------------------------------------------------------------
;; From values alone

;; At a kink second differences grow as their step shrinks.
(define (look-at-values t x y)
  (define (second h) (finite-or-false (difference-curvatures (value-at t) x h)))
  (define wide (second 1e-3))
  (define narrow (and wide (second 5e-4)))
  (cond
    [(not narrow) (outlook 'kink #f #f #f)]
    [else
     (define c (curvatures narrow (flvector-length x) 1e-6))
     (define steepest (direction c (- (flvector-length x) 1)))
     (judged t x y #f c
             (> (curvature-along narrow steepest) (* 1.6 (abs (curvature-along wide steepest))))
             (lambda () (vanishing? c 0))
             (lambda () #f))]))

;; ---------------------------------------------------------------------------
;; Beside the point

(define first-reach 1e-3)
(define reaches '(1e-3 1e-2 1e-1 1.0 10.0))
(define most-doublings 20)

(define (size x) (+ 1.0 (greatest x)))

;; The rounding error of a value
(define (noise y) (* 1e-15 (abs y)))

;; The user did not ask for the value there: an error may be due to the point.
(define (value-beside t x)
  (define y (with-handlers ([refusal? (lambda (e) +nan.0)]) (objective-value t x)))
  (if (< y +inf.0) y +inf.0))

(define ((value-at t) x) (value-beside t x))

;; reach -> a point in the direction v, or the other one, that is lower than y, as far as the
;; function goes on falling; #f if the first one is not lower.  reach : beside 1 + |x|
(define ((lower-along t x y v) reach)
  (define first (* reach (size x)))
  (define (at s) (value-beside t (along x s v)))
  (define s (if (<= (at first) (at (- first))) first (- first)))
  (and (< (at s) (- y (noise y)))
       (let loop ([s s] [y (at s)] [left most-doublings])
         (define next (at (* 2.0 s)))
         (if (and (> left 0) (< next y))
             (loop (* 2.0 s) next (- left 1))
             (along x s v)))))
