#lang racket/base
;; Bessel functions J and Y of real order ν ≥ 0 at x > 0.
;;
;; Two continued fractions and a Wronskian (J. B. Barnett, D. H. Feng, J. W. Steed and
;; L. J. B. Goldfarb, Computer Physics Communications 8, 1974, 377): the first is real, J'/J at
;; order ν (Bessel-recurrences.rkt); from there the recurrences go down to μ = ν − m, where the
;; second, complex one converges if x ≥ 2:
;;
;;     p + iq = −1/(2x) + i + (i/x) (1/4 − μ²)/(2(x + i) + (9/4 − μ²)/(2(x + 2i) + …)),
;;
;; which is (J' + iY')/(J + iY).  With J Y' − Y J' = 2/πx these give J and Y there; below x = 2
;; series do.  Y goes up again by its recurrence, J by the ratio to the value it began with.
;;
;; Far out, x > 26, Hankel's asymptotic series has all the digits for μ (A&S 9.2.5), where the
;; fraction would lose some as it is long.  Then J, too, goes upwards as long as ν < x; beyond
;; that the fraction is short.

(require racket/flonum racket/math
         "Bessel-recurrences.rkt" "Bessel-series.rkt")

(provide Bessel-J+Y)

;; -> J and Y of order nu at x; Y may be too great, −∞
(define (Bessel-J+Y nu x)
  (define-values (m mu) (nearest-order nu))
  (cond [(fl< x 2.0) (by-series nu x m mu)]
        [(fl< x 26.0) (by-fractions nu x m mu)]
        [else (from-far-out nu x m mu)]))

(define (by-series nu x m mu)
  (define-values (sum next) (Temme-series mu x -1.0))
  (define scale (fl/ -2.0 pi))
  (values (power-series nu x -1.0)
          (upwards (fl* scale sum) (fl* scale next) m mu x -1.0)))

(define (by-fractions nu x m mu)
  (define-values (start here slope) (from-above nu x m))
  (define-values (J Y next)
    (by-second-fraction mu x (fl/ slope here) (if (fl< here 0.0) -1.0 1.0)))
  (values (fl* start (fl/ J here)) (upwards Y next m mu x -1.0)))

;; -> in one unit, J at ν, and J and J' at μ
(define (from-above nu x m)
  (define-values (ratio side) (first-fraction nu x -1.0))
  (downwards ratio side m nu x -1.0))

;; The unit in which J is known downwards follows from its values at μ and μ + 1.
(define (from-far-out nu x m mu)
  (define-values (J Y) (far-out mu x))
  (define-values (J-next Y-next) (far-out (fl+ mu 1.0) x))
  (define (J-from-above)
    (define-values (start here slope) (from-above nu x m))
    (define next (fl- (fl* (fl/ mu x) here) slope))
    (define scale (flmax (flabs here) (flabs next)))
    (define-values (a b) (values (fl/ here scale) (fl/ next scale)))
    (fl* (fl/ start scale) (fl/ (fl+ (fl* a J) (fl* b J-next)) (fl+ (fl* a a) (fl* b b)))))
  (values (if (fl< nu x) (upwards J J-next m mu x -1.0) (J-from-above))
          (upwards Y Y-next m mu x -1.0)))

;; -> J, Y and Y of the next order, for x ≥ 2 and given J'/J
(define (by-second-fraction mu x f sign)
  (define-values (p q) (second-fraction mu x))
  (define w (fl/ 2.0 (fl* pi x)))
  (define g (fl/ (fl- p f) q))
  (define J (fl* sign (flsqrt (fl/ w (fl+ (fl* (fl- p f) g) q)))))
  (define Y (fl* J g))
  (define slope (fl+ (fl* Y p) (fl* J q)))
  (values J Y (fl- (fl* (fl/ mu x) Y) slope)))

;; p and q
(define (second-fraction mu x)
  (define square (fl* mu mu))
  (define (a k) (fl- (fl* (fl- k 0.5) (fl- k 0.5)) square))
  (define (b k) (make-flrectangular (fl* 2.0 x) (fl* 2.0 k)))
  ;; a₁/(b₁ + a₂/(b₂ + …)), from far inside: it converges the faster the greater x is
  (define terms (+ 20 (fl->exact-integer (flceiling (fl/ 400.0 x)))))
  (define fraction
    (for/fold ([tail 0.0]) ([k (in-range terms 0 -1)])
      (/ (a (->fl k)) (+ (b (->fl k)) tail))))
  (define all
    (+ (make-flrectangular (fl/ -0.5 x) 1.0) (* (make-flrectangular 0.0 (fl/ 1.0 x)) fraction)))
  (values (real-part all) (imag-part all)))

;; √(2/πx) (P cos χ ∓ Q sin χ), χ = x − (ν/2 + 1/4)π; the angles are kept apart, for x may be
;; large and its cosine is exact.
(define (far-out nu x)
  (define-values (P Q) (Hankel-sums nu x))
  (define phase (fl* pi (fl+ (fl* 0.5 (remainder-of-four nu)) 0.25)))
  (define-values (c s) (values (flcos phase) (flsin phase)))
  (define cosine (fl+ (fl* (flcos x) c) (fl* (flsin x) s)))
  (define sine (fl- (fl* (flsin x) c) (fl* (flcos x) s)))
  (define scale (fl/ (flsqrt (fl/ 2.0 pi)) (flsqrt x)))
  (values (fl* scale (fl- (fl* P cosine) (fl* Q sine)))
          (fl* scale (fl+ (fl* P sine) (fl* Q cosine)))))

(define (remainder-of-four nu) (fl- nu (fl* 4.0 (flfloor (fl/ nu 4.0)))))

(define (Hankel-sums nu x)
  (define m (fl* 4.0 (fl* nu nu)))
  (let loop ([k 0] [term 1.0] [P 0.0] [Q 0.0])
    (define sign (if (memv (remainder k 4) '(2 3)) -1.0 1.0))
    (define-values (P* Q*)
      (if (even? k)
          (values (fl+ P (fl* sign term)) Q)
          (values P (fl+ Q (fl* sign term)))))
    (define odd (->fl (+ (* 2 k) 1)))
    (define next (fl* term (fl/ (fl- m (fl* odd odd)) (fl* (->fl (* 8 (+ k 1))) x))))
    (if (or (fl< (flabs next) 1e-17) (> k 60))
        (values P* Q*)
        (loop (+ k 1) next P* Q*))))
