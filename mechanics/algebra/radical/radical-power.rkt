#lang racket/base
;; Powers and roots of sums of roots: (1 + √2)³ = 7 + 5√2, and back.
;;
;; If a prime stands in s under square roots only, s = a + w with w² free of it, and if
;; a² - w² = n² for a sum n of roots, then
;;
;;     √s = u + w/(2u),   u² = (a + n)/2,
;;
;; where u is found in the same way: √(11 + 6√2) = 3 + √2.  Of odd degree d, a root y of s = a + √b
;; with rational a and b has the conjugate ρ/y, where ρ^d = a² - b, and y + ρ/y is rational if y
;; is of that form too; its denominator divides that of s, so that its decimal tells it, and the
;; d-th power of y proves it.

(require "radical-sum.rkt"
         (only-in "../expression/exact-numbers.rkt" whole-root))

(provide radicals-expt)

;; r : rational  -> s^r, or #f where it is not found to be a sum of roots, or is no real number
(define (radicals-expt s r)
  (define root (root-of-degree s (denominator r)))
  (define power (and root (whole-power root (abs (numerator r)))))
  (if (and power (negative? r)) (radicals-invert power) power))

;; By squares; #f if it grows too large.
(define (whole-power s n)
  (cond [(eqv? n 0) (rational->radicals 1)]
        [else
         (define half (whole-power s (quotient n 2)))
         (define square (and half (radicals-multiply half half)))
         (define power (if (and square (odd? n)) (radicals-multiply s square) square))
         (and power (radicals-small? power) power)]))

(define (root-of-degree s d)
  (cond [(eqv? d 1) s]
        [(not (positive? (radicals->flonum s))) #f]
        [(= 1 (hash-count s))
         (for/first ([(radical c) (in-hash s)]) (root-of-term c radical (/ 1 d)))]
        [(even? d)
         (define root (root-of-sum s 2 (lambda (s) (square-root s most-steps))))
         (and root (root-of-degree root (quotient d 2)))]
        [else (root-of-sum s d (lambda (s) (odd-root s d)))]))

;; The root of s, or of its rest when one of its terms is taken out.
(define (root-of-sum s d root-of)
  (or (root-of s)
      (for*/or ([(radical c) (in-hash s)] #:when (positive? c))
        (define term (hash radical c))
        (define factor (root-of-degree term d))
        (define rest (and factor (root-of (radicals-multiply s (radicals-invert term)))))
        (and rest (radicals-multiply factor rest)))))

;; ---------------------------------------------------------------------------
;; Square roots

(define most-steps 4)

;; s : of two terms or more;  steps : how often a root within the root may be looked for
(define (square-root s steps)
  (and (positive? steps)
       (for/or ([p (in-list (radicals-primes s))])
         (define slices (radical-slices s p))
         (define-values (a w) (values (hash-ref slices 0 #f) (hash-ref slices 1/2 #f)))
         (and a w (= 2 (hash-count slices)) (square-root-of-slices a w (- steps 1))))))

(define (square-root-of-slices a w steps)
  (define (root s)
    (cond [(not (positive? (radicals->flonum s))) #f]
          [(= 1 (hash-count s)) (root-of-degree s 2)]
          [else (and (radicals-small? s) (square-root s steps))]))
  (define n (root (radicals-subtract (radicals-multiply a a) (radicals-multiply w w))))
  (define u (and n (root (radicals-scale 1/2 (radicals-add a n)))))
  (define 1/u (and u (radicals-invert u)))
  (and 1/u (radicals-add u (radicals-scale 1/2 (radicals-multiply w 1/u)))))

;; ---------------------------------------------------------------------------
;; Roots of odd degree

;; -> the root of s = a + √b, a and b rational, or #f
(define (odd-root s d)
  (define a (hash-ref s '() 0))
  (define w (hash-remove s '()))
  (define b (and (= 1 (hash-count w)) (radicals->rational (radicals-multiply w w))))
  (define rho (and b (rational-root (- (* a a) b) d)))
  (define trace (and rho (rational-trace s d rho)))
  (define plus? (andmap positive? (hash-values w)))
  (define y (and trace (root-of-trace trace rho plus?)))
  (and y (equal? s (whole-power y d)) y))

;; y + rho/y as a fraction whose denominator is that of s
(define (rational-trace s d rho)
  (define y (expt (radicals->flonum s) (/ 1.0 d)))
  (define denominators (apply lcm (map denominator (hash-values s))))
  (define t (* denominators (+ y (/ rho y))))
  (and (< (abs t) 1e15) (/ (inexact->exact (round t)) denominators)))

;; t/2 ± √(t²/4 - rho)
(define (root-of-trace t rho plus?)
  (define square (- (* 1/4 t t) rho))
  (define root (and (positive? square) (root-of-term square '() 1/2)))
  (and root (radicals-add (rational->radicals (/ t 2)) (radicals-scale (if plus? 1 -1) root))))

;; -> the root of odd degree d, if it is rational, or #f
(define (rational-root x d)
  (define above (whole-root (abs (numerator x)) d))
  (define below (whole-root (denominator x) d))
  (and above below (* (if (negative? x) -1 1) (/ above below))))
