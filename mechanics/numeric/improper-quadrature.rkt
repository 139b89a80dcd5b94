#lang racket/base
;; Definite integrals to infinity, and of functions that are infinite at some points.
;;
;; An infinite range, but for a beginning of about the length of its distance from
;; zero, becomes [0, 1] by x = b + u (1 − t)/t, dx = −u dt/t².
;;
;; An integrand like (x − a)^p or log(x − a) near an end a is too much for halving
;; panels: they become so narrow there that rounding hides x − a.  But its integrals
;; Sₖ from the middle to a distance 2⁻ᵏ from a tend to the whole as sums of geometric
;; sequences do, and the epsilon algorithm finds where from a few of them.  It would find a limit for sums that
;; have none, too, and know nothing of what happens closer to a.  Therefore the last
;; terms must fall, and what is left must agree roughly with what the rule of
;; quadrature.rkt makes of it.
;;
;; Where the function is infinite between the ends, halving finds the point to within
;; rounding; there the interval is divided.

(require "epsilon-algorithm.rkt" "failure.rkt" "oscillating-quadrature.rkt" "quadrature.rkt"
         "sample.rkt")

(provide improper-quadrature)     ; (improper-quadrature f low high) -> flonum, error bound

;; The tolerance is relative to ∫ |f|, over each half of an infinite range.
(define (improper-quadrature f low high
                             #:tolerance [tolerance 1e-10]
                             #:name [who 'quadrature])
  (check-limit who low)
  (check-limit who high)
  (check-tolerance who tolerance)
  (define a (real->double-flonum low))
  (define b (real->double-flonum high))
  (define (between a b) (over-interval f a b tolerance who values))
  ;; direction : 1.0 or -1.0, by which the integral is not affected
  (define (to-infinity from direction)
    (define unit (max 1.0 (abs from)))
    (define near (+ from (* direction unit)))
    (define (x t) (+ near (* direction unit (/ (- 1.0 t) t))))
    (define (h t) (/ (* unit (sample who f (x t))) (* t t)))
    (define (along s) (sample who f (+ near (* direction s))))
    (define (far)
      (let/ec return
        (call-or-fail (lambda () (over-interval h 0.0 1.0 tolerance who x 0)) return)
        (call-or-fail (lambda () (oscillating-quadrature along unit tolerance)) return)
        (over-interval h 0.0 1.0 tolerance who x)))
    (both (lambda () (between (min from near) (max from near))) far))
  (cond [(= a b) (values 0.0 0.0)]
        [(> a b)
         (define-values (value bound)
           (improper-quadrature f b a #:tolerance tolerance #:name who))
         (values (- value) bound)]
        [(and (= a -inf.0) (= b +inf.0))
         (both (lambda () (to-infinity 0.0 -1.0)) (lambda () (to-infinity 0.0 1.0)))]
        [(= b +inf.0) (to-infinity a 1.0)]
        [(= a -inf.0) (to-infinity b -1.0)]
        [else (between a b)]))

;; Two integrals and their bounds added.
(define (both one other)
  (define-values (value bound) (one))
  (define-values (value* bound*) (other))
  (values (+ value value*) (+ bound bound*)))

(define (check-limit who x)
  (unless (and (real? x) (= x x))
    (raise-argument-error who "a real number, perhaps infinite, as limit of integration" x)))

(define most-panels-at-edge 200)
(define most-divisions 6)          ; of an interval, of its parts, of theirs ...

;; place : what the user knows a point as
(define (over-interval f a b tolerance who place [divisions most-divisions])
  (define (plain edge divide)
    (quadrature/error f a b #:tolerance tolerance #:place place #:edge edge #:name who
                      #:stuck (lambda (value bound x) (when x (divide x)))))
  (define (divided-at c return)
    (when (and (< a c b) (> divisions 0))
      (define (part a b) (over-interval f a b tolerance who place (- divisions 1)))
      (call-or-fail (lambda () (both (lambda () (part a c)) (lambda () (part c b)))) return)))
  (define (from-ends return)
    (define middle (+ a (* 0.5 (- b a))))
    (define-values (left left-bound) (towards f middle a tolerance))
    (define-values (right right-bound)
      (if left (towards f middle b tolerance) (values #f #f)))
    (when right (return (- right left) (+ left-bound right-bound)))
    (divided-at middle return)
    (quadrature/error f a b #:tolerance tolerance #:limit most-panels-at-edge
                      #:place place #:name who))
  (let/ec return
    (define (divide x) (divided-at (worst-near f x) return))
    (define (divide-at-singularity failure)
      (define c (exn:fail:mechanics:singular-where failure))
      (when (and (eq? place values) (real? c)) (divided-at c return))
      (raise failure))
    (with-handlers* ([exn:fail:mechanics:singular? divide-at-singularity])
      (let/ec at-edge
        (call-with-values (lambda () (plain (lambda () (at-edge)) divide)) return))
      (from-ends return))))

;; The values of (f), received by `return`, which may not be called.
(define (call-or-fail f return)
  (define-values (value bound)
    (with-handlers ([exn:fail:mechanics? (lambda (e) (values #f #f))])
      (f)))
  (when value (return value bound)))

;; Of the numbers within rounding of x, the one where |f| is greatest.
(define (worst-near f x)
  (define unit (* 1e-16 (abs x)))
  (define (size y)
    (define z (abs (f y)))
    (if (< z +inf.0) z +inf.0))
  (for/fold ([best x] [most (size x)] #:result best) ([k (in-range -100 101)])
    (define y (+ x (* k unit)))
    (define here (size y))
    (if (> here most) (values y here) (values best most))))

;; ---------------------------------------------------------------------------
;; Towards an end

(define least-terms 20)
(define most-terms 200)
(define greatest-ratio 0.98)       ; of a part to the one before
(define greatest-half 0.85)        ; of the later half of the parts to the earlier one

;; sum : the integral up to here; size : that of |f|, nearly; parts : their magnitudes,
;; the last first; diagonal : of the epsilon algorithm; agreed : how many limits in a row
;; have
(struct progress (sum size parts diagonal agreed) #:authentic)

;; The integral from one point to an end and a bound of its error; #f twice if it is
;; not found.
(define (towards f from end tolerance)
  (define none (lambda () (values #f #f)))
  (define all (- end from))
  (define (point k) (- end (* all (expt 0.5 k))))
  (let loop ([k 0] [p (progress 0.0 0.0 '() '() 0)])
    (define x (point k))
    (define y (point (+ k 1)))
    (cond
      [(and (>= k least-terms)
            (found? p (lambda () (rough-integral f x end)) tolerance)
            (still-falling? f end (- x end) p tolerance))
       (values (limit p) (* tolerance (progress-size p)))]
      [(or (= k most-terms) (not (resolved? y end))) (none)]
      [else
       (define part (integral f x y (max 1e-13 (* 1e-2 tolerance))))
       (if part (loop (+ k 1) (advance p part (* 0.1 tolerance))) (none))])))

(define (resolved? x end) (> (abs (- end x)) (* 1e-10 (abs end))))

(define (advance p part tolerance)
  (define sum (+ (progress-sum p) part))
  (define size (+ (progress-size p) (abs part)))
  (define diagonal (extend-diagonal (progress-diagonal p) sum))
  (define agrees?
    (and (pair? (progress-diagonal p))
         (<= (abs (- (estimated-limit diagonal) (limit p))) (* tolerance size))))
  (progress sum size (cons (abs part) (progress-parts p)) diagonal
            (if agrees? (+ 1 (progress-agreed p)) 0)))

(define (limit p) (estimated-limit (progress-diagonal p)))

(define (found? p rough tolerance)
  (define tolerated (* tolerance (progress-size p)))
  (and (>= (progress-agreed p) 2)
       (falling? (progress-parts p) (* 0.1 tolerated))
       (plausible? (- (limit p) (progress-sum p)) (rough) tolerated)))

;; Parts that go up and down, as those of sin(log x)/x do, fall in places.
(define (falling? parts negligible)
  (define-values (later earlier) (halves parts))
  (and (<= (car parts) (max negligible (* greatest-ratio (cadr parts))))
       (<= (greatest later) (max negligible (* greatest-half (greatest earlier))))))

(define (halves xs)
  (define half (quotient (length xs) 2))
  (values (for/list ([x (in-list xs)] [_ (in-range half)]) x) (list-tail xs half)))

(define (greatest xs) (for/fold ([m 0.0]) ([x (in-list xs)]) (max m x)))

;; Where there is room for it, at an end that is 0, as infinity becomes: do parts much
;; closer to it stay below those there are?
(define (still-falling? f end distance p tolerance)
  (define-values (later earlier) (halves (progress-parts p)))
  (define most (max (* tolerance (progress-size p)) (* greatest-half (greatest later))))
  (or (not (= end 0.0))
      (for/and ([k (in-range 40 80)])
        (define x (* distance (expt 0.5 k)))
        (define y (f x))
        (not (and (real? y) (< most (abs (* x y)) +inf.0))))))

;; The rule misses most of a singular integral, but not its sign.
(define (plausible? rest rough tolerated)
  (or (and (<= (abs rest) tolerated) (<= (abs rough) tolerated))
      (<= 0.5 (/ rest rough) 50.0)))

;; ---------------------------------------------------------------------------

;; To a tolerance, or #f.
(define (integral f x y tolerance)
  (with-handlers ([exn:fail:mechanics:not-convergent? (lambda (e) #f)])
    (quadrature f x y #:tolerance tolerance #:limit most-panels-at-edge)))

;; Any error is tolerated: the rule is used once.
(define (rough-integral f x y) (quadrature f x y #:tolerance 10.0))
