#lang racket/base
;; All zeros of a polynomial, by the method of Ehrlich (1967) and Aberth (1973).
;;
;; With approximations zᵢ of all zeros and N = p/p' at zᵢ, the next is
;;
;;     zᵢ − N/(1 − N Σ 1/(zᵢ − zⱼ)):
;;
;; Newton's step for p over the other linear factors, so that no two come to one zero.  Where zeros
;; are near one another a polynomial in flonums is roundings alone.  So coefficients are exact
;; numbers, the approximations whole numbers X over a power of two, and p and p' there are whole
;; numbers without any rounding: a zero has all its digits, however many there are and however
;; near.  A circle around z of radius n |N| holds a zero, for N⁻¹ is the sum of all 1/(z − ζ).
;;
;; The first approximations lie on circles whose radii the sizes of the coefficients tell: the
;; slopes of the upper hull of the points (k, log |cₖ|) (Bini 1996).

(require racket/list
         racket/math)

(provide complex-zeros (struct-out bounded))

;; A zero, a flonum or complex; `radius`, which its error is less than; `change`: by how much the
;; zero moves, about, if each coefficient changes by its size.  An error is relative to nothing.
(struct bounded (zero radius change) #:authentic)

;; coefficients : exact numbers, from order 0 on, the first and the last not 0
;; -> a list of bounded, by real part, then by imaginary part; each as often as it is a zero; #f if
;;    some are beyond flonums
(define (complex-zeros coefficients)
  (define p (whole coefficients))
  (define circles (circles-of-zeros p))
  (and (andmap (lambda (c) (< 0.0 (circle-radius c) +inf.0)) circles)
       (zeros-near p (list->vector (first-approximations circles)) coefficients)))

(define (zeros-near p zs coefficients)
  (improve-all! (newton-in-flonums p) 1e-12 50 zs)
  (improve-all! (lambda (z) (newton p z)) (expt 2.0 (- 1 bits)) 500 zs)
  (define found (for/list ([z (in-vector zs)]) (with-bounds p z)))
  (sort (if (andmap real? coefficients) (symmetric found) found) before?))

;; Steps for each number until it moves by no more than `enough` of its size.  Every eighth step is
;; turned, for two numbers that are mirror images of one another between two zeros would stay so.
(define (improve-all! newton enough most zs)
  (for/fold ([moving (range (vector-length zs))]) ([k (in-range most)] #:break (null? moving))
    (define turn (if (= 7 (remainder k 8)) 0.8+0.6i 1.0))
    (filter (lambda (i) (improve! newton turn enough zs i)) moving))
  (void))

;; The same polynomial but for a factor, from the highest order on
(define (whole coefficients)
  (define (denominators c) (list (denominator (real-part c)) (denominator (imag-part c))))
  (define factor (apply lcm (append-map denominators coefficients)))
  (reverse (map (lambda (c) (* factor c)) coefficients)))

(define (before? a b)
  (define-values (x y) (values (bounded-zero a) (bounded-zero b)))
  (or (< (real-part x) (real-part y))
      (and (= (real-part x) (real-part y)) (< (imag-part x) (imag-part y)))))

;; ---------------------------------------------------------------------------
;; Approximations

;; About 0, with so many zeros nearby, and so many within
(struct circle (radius count within) #:authentic)

;; One for each edge of the hull
(define (circles-of-zeros p)
  (define corners
    (for/fold ([corners '()]) ([c (in-list (reverse p))] [k (in-naturals)] #:unless (eqv? c 0))
      (cons (cons k (log-size c)) (without-inner corners k (log-size c)))))
  (for/list ([(b a) (in-parallel corners (cdr corners))])
    (circle (exp (- (slope a b))) (- (car b) (car a)) (car a))))

;; Turned so that no two are conjugate
(define (first-approximations circles)
  (define n (apply + (map circle-count circles)))
  (for*/list ([c (in-list circles)] [count (in-value (circle-count c))] [j (in-range count)])
    (inexact->exact
     (make-polar (circle-radius c)
                 (+ 0.7 (* 2 pi (+ (/ j count) (/ (circle-within c) n count))))))))

(define (log-size c) (log (exact-size c)))
(define (slope a b) (/ (- (cdr b) (cdr a)) (- (car b) (car a))))

;; Corners are taken away that lie below the line from the one before to (k, y).
(define (without-inner corners k y)
  (if (and (pair? corners) (pair? (cdr corners))
           (<= (slope (cadr corners) (car corners)) (slope (car corners) (cons k y))))
      (without-inner (cdr corners) k y)
      corners))

;; Makes Aberth's step for number i.  newton : z -> N
;; -> did it move?
(define (improve! newton turn enough zs i)
  (define z (vector-ref zs i))
  (define here (exact->inexact z))
  (define N (newton z))
  (define repulsion
    (for/fold ([sum 0.0]) ([other (in-vector zs)] [j (in-naturals)] #:unless (= i j))
      (define d (- here (exact->inexact other)))
      (if (= d 0.0) sum (+ sum (reciprocal d)))))
  (define quotient (- 1.0 (* N repulsion)))
  (define step (* turn (if (= quotient 0.0) N (/ N quotient))))
  (define finite? (< (magnitude step) +inf.0))
  (when finite? (vector-set! zs i (shortened (- z (inexact->exact step)))))
  (not (and finite? (<= (magnitude step) (* enough (magnitude here))))))

;; Of numbers, too, whose squares are too small for a flonum
(define (reciprocal d)
  (define size (magnitude d))
  (/ (conjugate (/ d size)) size))

(define (newton-in-flonums p)
  (define coefficients (map exact->inexact p))
  (lambda (z)
    (define x (exact->inexact z))
    (define-values (P D)
      (for/fold ([P 0.0] [D 0.0]) ([c (in-list coefficients)])
        (values (+ (* P x) c) (+ (* D x) P))))
    (if (= D 0.0) +nan.0 (/ P D))))

;; Where p' is 0, somewhere near
(define (newton p z)
  (define-values (s X) (in-bits z))
  (define-values (P D) (horner p s X))
  (if (eqv? D 0)
      (* 1e-3+1e-3i (exact->inexact z))
      (/ (quotient-of P D) (expt 2.0 s))))

;; P/D as flonums, of the first 500 bits of each: products of such do not overflow
(define (quotient-of P D)
  (define (beyond z)
    (max 0 (- (integer-length (real-part z)) 500) (- (integer-length (imag-part z)) 500)))
  (define (short z back)
    (exact->inexact (make-rectangular (arithmetic-shift (real-part z) (- back))
                                      (arithmetic-shift (imag-part z) (- back)))))
  (define-values (above below) (values (beyond P) (beyond D)))
  (* (/ (short P above) (short D below)) (expt 2.0 (- above below))))

;; More than a flonum has, and few enough for products with fixnums, which are fast.
(define bits 58)

(define (shortened z)
  (define-values (s X) (in-bits z))
  (/ X (expt 2 s)))

;; z is X/2ˢ, but for roundings beyond these bits.  -> s, X
(define (in-bits z)
  (define size (max (abs (real-part z)) (abs (imag-part z))))
  (define s
    (max 0 (- (+ bits (integer-length (denominator size))) (integer-length (numerator size)))))
  (values s (rounded (* z (expt 2 s)))))

(define (rounded z)
  (make-rectangular (inexact->exact (round (real-part z))) (inexact->exact (round (imag-part z)))))

;; With P(X) = 2ⁿˢ p(X/2ˢ) -> P and its derivative at X
(define (horner p s X)
  (for/fold ([P 0] [D 0]) ([c (in-list p)] [k (in-naturals)])
    (values (+ (* P X) (shifted c (* k s))) (+ (* D X) P))))

(define (shifted c k)
  (if (real? c)
      (arithmetic-shift c k)
      (make-rectangular (arithmetic-shift (real-part c) k) (arithmetic-shift (imag-part c) k))))

;; ---------------------------------------------------------------------------
;; Bounds

(define (with-bounds p z)
  (define-values (s X) (in-bits z))
  (define-values (P D) (horner p s X))
  (define-values (size _slope)
    (horner (map exact-size p) s (exact-ceiling (magnitude X))))
  (define (over-slope x) (if (eqv? D 0) +inf.0 (/ (magnitude (quotient-of x D)) (expt 2.0 s))))
  (define zero (exact->inexact z))
  (bounded zero
           (+ (if (eqv? P 0) 0.0 (* (- (length p) 1) (over-slope P)))
              (* (expt 2.0 -52) (magnitude zero)))
           (over-slope size)))

(define (exact-size c) (+ (abs (real-part c)) (abs (imag-part c))))

;; Zeros of a real polynomial: real ones, if the real axis is within the error, and pairs
(define (symmetric found)
  (define (with-zero b z) (struct-copy bounded b [zero z]))
  (define-values (real others)
    (partition (lambda (b) (<= (abs (imag-part (bounded-zero b))) (bounded-radius b))) found))
  (define upper (filter (lambda (b) (positive? (imag-part (bounded-zero b)))) others))
  (append (for/list ([b (in-list real)]) (with-zero b (real-part (bounded-zero b))))
          (if (= (* 2 (length upper)) (length others))
              (for*/list ([b (in-list upper)] [side (in-list '(1 -1))])
                (define z (bounded-zero b))
                (with-zero b (make-rectangular (real-part z) (* side (imag-part z)))))
              others)))
