#lang racket/base
;; Stability of equilibria: the formula for two coordinates against frequencies computed
;; from numbers, and systems that change in time.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt" "../support/random.rkt")

(define (bilinear S a b)
  (for*/sum ([i 2] [j 2]) (* (ref a i) (vector-ref (vector-ref S i) j) (ref b j))))

;; M, K : vectors of rows; g : the magnetic term's
(define ((L-of M K g) (up t q v))
  (+ (* 1/2 (bilinear M v v)) (* -1/2 (bilinear K q q))
     (* 1/2 g (- (* (ref q 0) (ref v 1)) (* (ref q 1) (ref v 0))))))

(define (symmetric a b c) (vector (vector a b) (vector b c)))
(define (kind M K g) (stability-kind (equilibrium-stability (L-of M K g) (up 0 0))))

;; ---------------------------------------------------------------------------
;; Where velocities act

(test-case "off the diagonal, inertia and stiffness count together"
  ;; b = M₀₀K₁₁ + M₁₁K₀₀ − 2 M₀₁K₀₁ + g² is 5/2 or 3/2, |M| |K| = 9/16
  (define M (symmetric 1 1/2 1))
  (check-eq? (kind M (symmetric -1 -1/2 -1) 2) 'linearly-stable)
  (check-eq? (kind M (symmetric -1 1/2 -1) 2) 'undecided)
  (check-eq? (kind M (symmetric -1 1/2 -1) 9/5) 'unstable)
  (check-eq? (kind M (symmetric -1 -1/2 -1) 9/5) 'linearly-stable)
  (check-eq? (kind M (symmetric -1 0 -1) 2) 'linearly-stable)
  (check-eq? (kind M (symmetric -1 0 -1) 1/10) 'unstable))

;; From the eigenvalues of the equations of motion as numbers: oscillations of two
;; frequencies, or growth; #f near to where one becomes the other.
(define (kind-by-numbers M K g)
  (define omegas (small-oscillation-frequencies (L-of (rounded M) (rounded K) (* 1.0 g)) (up 0 0)))
  (define-values (growth a b)
    (values (apply max (map (lambda (w) (abs (imag-part w))) omegas))
            (abs (real-part (car omegas))) (abs (real-part (cadr omegas)))))
  (cond [(> growth 1e-3) 'unstable]
        [(and (= growth 0) (> (min a b (abs (- a b))) 1e-3)) 'oscillating]
        [else #f]))

(define (rounded rows)
  (for/vector ([row rows]) (for/vector ([x row]) (exact->inexact x))))

(define (random-system)
  (define-values (m c) (values (abs (random-rational)) (random-rational)))
  (values (symmetric (+ m (square c)) c 1)                      ; |M| = m
          (symmetric (* -1/2 (random-rational)) (* 1/3 (random-rational)) (random-rational))
          (* 3/2 (random-rational))))

(test-case "systems of two coordinates, at random, are as stable as their frequencies say"
  (define seen (make-hasheq))
  (with-seed 61
    (for ([_ 150])
      (define-values (M K g) (random-system))
      (define expected (kind-by-numbers M K g))
      (define found (kind M K g))
      (when expected
        (hash-update! seen found add1 0)
        (with-check-info (['M M] ['K K] ['g g])
          (check-not-false (memq found (if (eq? expected 'unstable)
                                           '(unstable)
                                           '(stable linearly-stable)))))))
    (for ([k '(stable linearly-stable unstable)])
      (check-true (> (hash-ref seen k 0) 9) (format "~a" seen)))))

(test-case "the conditions of symbols hold where the system of numbers is stable"
  (define K (symmetric 'a 'b -1))
  (define M (symmetric 2 'c 1))
  (define s (equilibrium-stability (L-of M K 'g) (up 0 0)))
  (check-eq? (stability-kind s) 'linearly-stable)
  (define (value e a b c g) (substitute e 'a a 'b b 'c c 'g g))
  (with-seed 62
    (for ([_ 40])
      (define-values (a b c g)
        (values (- (random-rational)) (random-rational) (* 1/10 (random-rational))
                (* 2 (random-rational))))
      (define hold?
        (for/and ([condition (stability-conditions s)])
          (positive? (value (cadr condition) a b c g))))
      (define expected (kind-by-numbers (symmetric 2 c 1) (symmetric a b -1) g))
      (when expected
        (with-check-info (['symbols (list a b c g)])
          (check-eq? hold? (eq? expected 'oscillating)))))))

;; ---------------------------------------------------------------------------
;; Systems that change in time

(define changes
  (string-append "equilibrium-stability: the Lagrangian changes in time at these coordinates; "
                 "small oscillations are those of a system that does not"))

(define (growing-mass (up t q v)) (- (* 1/2 (+ 1 (square t)) (square v)) (* 1/2 (square q))))
(define (changing-inertia-between (up t (up x y) (up vx vy)))
  (+ (* 1/2 (+ (square vx) (square vy))) (* (/ 1 (+ 2 (square t))) vx vy)
     (* -1/2 (+ (square x) (square y)))))
(define (changing-magnetism (up t (up x y) (up vx vy)))
  (+ (* 1/2 (+ (square vx) (square vy))) (* t (- (* x vy) (* y vx)))
     (* -1/2 (+ (square x) (square y)))))

(says
 [(equilibrium-stability growing-mass 0) changes]
 [(equilibrium-stability changing-inertia-between (up 0 0)) changes]
 [(equilibrium-stability changing-magnetism (up 0 0)) changes])
