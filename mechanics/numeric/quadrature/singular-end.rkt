#lang racket/base
;; Integrals up to a point where the function is infinite.
;;
;; An integrand like (x − a)^p or log(x − a) near an end a is too much for halving
;; panels: they become so narrow there that rounding hides x − a.  But its integrals
;; Sₖ from the middle to a distance 2⁻ᵏ from a tend to the whole as sums of geometric
;; sequences do, and the epsilon algorithm finds where from a few of them.  It would find
;; a limit for sums that have none, too, and know nothing of the function closer to a.
;; Therefore the terms must fall, and the rest must agree roughly with its value by the rule
;; of gauss-kronrod.rkt.

(require racket/list
         "epsilon-algorithm.rkt" "gauss-kronrod.rkt" "logarithmic-end.rkt")

(provide integral-towards)

(define most-panels 200)           ; for each term
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
(define (integral-towards f from end tolerance)
  (define none (lambda () (values #f #f)))
  (define all (- end from))
  (define (point k) (- end (* all (expt 0.5 k))))
  (let loop ([k 0] [p (progress 0.0 0.0 '() '() 0)])
    (define x (point k))
    (define y (point (+ k 1)))
    (cond
      [(and (>= k least-terms)
            (found? p (lambda () (rough-integral f x end)) tolerance)
            (still-falling? f end (- x end) p tolerance)
            (or (= end 0.0) (same-power-to-the-end? f end (- x end))))
       (values (limit p) (* tolerance (progress-size p)))]
      [(or (= k most-terms) (not (resolved? y end))) (none)]
      [else
       (define part (part-integral f x y tolerance most-panels))
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
  (and (<= (first parts) (max negligible (* greatest-ratio (second parts))))
       (or (<= (first parts) negligible) (as-power? parts))
       (<= (apply max later) (max negligible (* greatest-half (apply max earlier))))))

;; Do they not fall more and more slowly, as those of 1/(x log³ x) do?  k/(k + 1) comes nearer
;; to 1 as k grows, a power's ratio does not.
(define (as-power? parts)
  (define (lack parts) (- 1.0 (/ (first parts) (second parts))))
  (define now (lack parts))
  (or (>= now 0.15)
      (>= now (* 0.8 (lack (list-tail parts (quotient (length parts) 2)))))))

(define (halves parts) (split-at parts (quotient (length parts) 2)))

;; Where there is room for it, at an end that is 0, as infinity becomes: do parts much
;; closer to it stay below those there are?
(define (still-falling? f end distance p tolerance)
  (define-values (later earlier) (halves (progress-parts p)))
  (define most (max (* tolerance (progress-size p)) (* greatest-half (apply max later))))
  (or (not (= end 0.0))
      (for/and ([k (in-range 40 80)])
        (define x (* distance (expt 0.5 k)))
        (define y (f x))
        (not (and (real? y) (< most (abs (* x y)) +inf.0))))))

;; The rule misses most of a singular integral, but not its sign.
(define (plausible? rest rough tolerated)
  (or (and (<= (abs rest) tolerated) (<= (abs rough) tolerated))
      (<= 0.5 (/ rest rough) 50.0)))

;; Any error is tolerated: the rule is used once.
(define (rough-integral f x y) (quadrature f x y #:tolerance 10.0))
