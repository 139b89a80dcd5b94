#lang racket/base
;; Bessel functions J and Y of real order ν ≥ 0 at x > 0.
;;
;; Two continued fractions and a Wronskian (J. B. Barnett, D. H. Feng, J. W. Steed and
;; L. J. B. Goldfarb, Computer Physics Communications 8, 1974, 377): the first is the real
;;
;;     f = J'/J = ν/x − 1/(2(ν + 1)/x − 1/(2(ν + 2)/x − …)),
;;
;; whose denominators change sign as often as J has; the recurrences go from order ν down to
;; μ = ν − m, where the second, complex one converges if x ≥ 2:
;;
;;     p + iq = −1/(2x) + i + (i/x) (1/4 − μ²)/(2(x + i) + (9/4 − μ²)/(2(x + 2i) + …)),
;;
;; which is (J' + iY')/(J + iY).  With J Y' − Y J' = 2/πx these give J and Y there.  Below x = 2
;; Y is Temme's series (N. M. Temme, Journal of Computational Physics 21, 1976, 343) and J its
;; own.  Y goes up again by its recurrence, J by the ratio to what it began with.
;;
;; Far out, x > 26, Hankel's asymptotic series has all the digits for μ (A&S 9.2.5), where the
;; fraction would lose some as it is long.  Then J, too, goes upwards as long as ν < x; beyond
;; that the fraction is short.

(require racket/flonum racket/math
         "Bessel-series.rkt" "reciprocal-gamma.rkt")

(provide Bessel-J+Y)

;; -> J and Y of order nu at x; Y may be too great, −∞
(define (Bessel-J+Y nu x)
  (define m (fl->exact-integer (flfloor (fl+ nu 0.5))))
  (define mu (fl- nu (->fl m)))
  (cond [(fl< x 2.0) (by-series nu x m mu)]
        [(fl< x 26.0) (by-fractions nu x m mu)]
        [else (from-far-out nu x m mu)]))

(define (by-series nu x m mu)
  (define-values (Y next) (Temme-series mu x))
  (values (power-series nu x -1.0) (upwards Y next m mu x)))

(define (by-fractions nu x m mu)
  (define-values (ratio sign) (first-fraction nu x))
  (define-values (start here slope) (downwards ratio sign m nu x))
  (define-values (J Y next)
    (by-second-fraction mu x (fl/ slope here) (if (fl< here 0.0) -1.0 1.0)))
  (values (fl* start (fl/ J here)) (upwards Y next m mu x)))

;; Downwards J is known but for its unit, which its values at μ and μ + 1 tell.
(define (from-far-out nu x m mu)
  (define-values (J Y) (far-out mu x))
  (define-values (J-next Y-next) (far-out (fl+ mu 1.0) x))
  (define (J-from-above)
    (define-values (ratio sign) (first-fraction nu x))
    (define-values (start here slope) (downwards ratio sign m nu x))
    (define next (fl- (fl* (fl/ mu x) here) slope))
    (define scale (flmax (flabs here) (flabs next)))
    (define-values (a b) (values (fl/ here scale) (fl/ next scale)))
    (fl* (fl/ start scale) (fl/ (fl+ (fl* a J) (fl* b J-next)) (fl+ (fl* a a) (fl* b b)))))
  (values (if (fl< nu x) (upwards J J-next m mu x) (J-from-above))
          (upwards Y Y-next m mu x)))

;; f at order ν by Lentz's method, and the sign of J
(define (first-fraction nu x)
  (define step (fl/ 2.0 x))
  (define (not-zero y) (if (fl< (flabs y) 1e-300) 1e-300 y))
  (let loop ([h (not-zero (fl/ nu x))] [b (fl* nu step)] [c (not-zero (fl/ nu x))] [d 0.0]
             [sign 1.0])
    (define b* (fl+ b step))
    (define d* (fl/ 1.0 (not-zero (fl- b* d))))
    (define c* (not-zero (fl- b* (fl/ 1.0 c))))
    (define change (fl* c* d*))
    (define sign* (if (fl< d* 0.0) (fl- 0.0 sign) sign))
    (if (fl< (flabs (fl- change 1.0)) 1e-16)
        (values (fl* h change) sign*)
        (loop (fl* h change) b* c* d* sign*))))

;; From order ν to μ = ν − m, in some unit: J at ν, J and J' at μ.  J at ν is 0 beside a J at μ
;; that is too great for this unit.
(define (downwards ratio sign m nu x)
  (define unit (fl* sign 1e-290))
  (for/fold ([start unit] [J unit] [slope (fl* ratio unit)]
             #:result (values start (if (fl= J 0.0) 1e-306 J) slope))
            ([k (in-range m)])
    (define up (fl/ (fl- nu (->fl k)) x))
    (define J* (fl+ (fl* up J) slope))
    (define slope* (fl- (fl* (fl- up (fl/ 1.0 x)) J*) J))
    (if (fl> (flabs J*) 1e280)
        (values 0.0 (fl* 1e-280 J*) (fl* 1e-280 slope*))
        (values start J* slope*))))

;; Y at order μ + m, from those of μ and μ + 1
(define (upwards Y next m mu x)
  (for/fold ([Y Y] [next next] #:result Y) ([k (in-range 1 (+ m 1))])
    (values next
            (if (fl= next -inf.0)
                next
                (fl- (fl* (fl* (fl+ mu (->fl k)) (fl/ 2.0 x)) next) Y)))))

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

;; For x < 2, Y = −Σ cₖ gₖ and Y of the next order −2/x Σ cₖ hₖ, where cₖ = (−x²/4)ᵏ/k!
(define (Temme-series mu x)
  (define-values (gamma-1 gamma-2 plus minus) (reciprocal-gammas mu))
  (define angle (fl* pi mu))
  (define d (fllog (fl/ 2.0 x)))
  (define e (fl* mu d))
  (define (over sine y) (if (fl< (flabs y) 1e-10) 1.0 (fl/ (sine y) y)))
  (define half (over flsin (fl* 0.5 angle)))
  (define r (fl* (fl* pi angle) (fl* 0.5 (fl* half half))))
  (define f0
    (fl* (fl/ 2.0 (fl* pi (over flsin angle)))
         (fl+ (fl* gamma-1 (cosh e)) (fl* (fl* gamma-2 (over sinh e)) d))))
  (define p0 (fl/ (flexp e) (fl* plus pi)))
  (define q0 (fl/ (flexp (fl- 0.0 e)) (fl* pi minus)))
  (define z (fl* -0.25 (fl* x x)))
  (let loop ([k 1.0] [f f0] [p p0] [q q0] [c 1.0] [sum (fl+ f0 (fl* r q0))] [sum* p0])
    (define f* (fl/ (fl+ (fl* k f) (fl+ p q)) (fl- (fl* k k) (fl* mu mu))))
    (define c* (fl* c (fl/ z k)))
    (define-values (p* q*) (values (fl/ p (fl- k mu)) (fl/ q (fl+ k mu))))
    (define g (fl+ f* (fl* r q*)))
    (define term (fl* c* g))
    (define term* (fl* c* (fl- p* (fl* k g))))
    (if (and (fl< (flabs term) (fl* 1e-17 (flabs sum)))
             (fl< (flabs term*) (fl* 1e-17 (flabs sum*))))
        (values (fl- 0.0 sum) (fl* (fl/ -2.0 x) sum*))
        (loop (fl+ k 1.0) f* p* q* c* (fl+ sum term) (fl+ sum* term*)))))

;; √(2/πx) (P cos χ ∓ Q sin χ), χ = x − (ν/2 + 1/4)π; the angles are kept apart, for x may be
;; large and its cosine is exact.
(define (far-out nu x)
  (define-values (P Q) (Hankel-sums nu x))
  (define phase (fl* pi (fl+ (fl* 0.5 (remainder-of-four nu)) 0.25)))
  (define-values (c s) (values (flcos phase) (flsin phase)))
  (define cosine (fl+ (fl* (flcos x) c) (fl* (flsin x) s)))
  (define sine (fl- (fl* (flsin x) c) (fl* (flcos x) s)))
  (define scale (flsqrt (fl/ 2.0 (fl* pi x))))
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
