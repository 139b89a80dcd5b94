#lang racket/base
;; A function with derivative 0 wherever it is defined may yet jump: such paths were proved to be
;; motions, such quantities to be conserved, such terms to change nothing.

(require mechanics
         (only-in mechanics/book L-free-particle L-harmonic)
         (only-in "../support/systems.rkt" L-on-a-line)
         "../support/checks.rkt")

(define L-free (L-free-particle 'm))
(define (L-with V) (L-on-a-line 'm V))
(define line (up 't 'x 'v))
(define (step local) (sgn (coordinate local)))

(define headline
  "undecided: the residual is zero wherever it is smooth, but not decided at some points")

;; The verdict is undecided, for these reasons alone.
(define-check (check-open verdict reasons)
  (define expected
    (for/fold ([text headline]) ([r (in-list reasons)]) (string-append text "\n  " r)))
  (with-check-info (['verdict verdict] ['expected expected])
    (unless (and (undecided? verdict) (equal? (format "~a" verdict) expected))
      (fail-check))))

(define (check-path q . reasons) (check-open (verify-solution L-free q) reasons))

(test-case "paths with kinks, jumps, or without a value are no motions of a free particle"
  (check-path sgn "jump: (sgn t) at t = 0")
  (check-path abs "kink: (abs t) at t = 0")
  (check-path (lambda (t) (atan (tan t)))
              "no value: (tan t) at t = (+ (* :pi n) (* 1/2 :pi)) for integers n")
  (check-path (lambda (t) (acosh (cosh t))) "kink: (acosh (cosh t)) at t = 0")
  (check-path (lambda (t) +nan.0) "no value: +nan.0 everywhere"))

(test-case "relatives of these"
  (check-path (lambda (t) (abs (- t 2))) "kink: (abs (- t 2)) at t = 2")
  (check-path (lambda (t) (sgn (- (square t) 1)))
              "jump: (sgn (- (expt t 2) 1)) at t = 1, t = -1")
  (check-path (lambda (t) (* t +nan.0)) "no value: (* +nan.0 t) everywhere")
  (check-path (lambda (t) (up (* 'a t) (abs (- (* 'a t) 'b))))
              "kink: (abs (- (* a t) b)) at t = (/ b a)")
  (check-path (lambda (t) (if (= t 2) 5 0)) "jump: (= t 2) at t = 2")
  (check-path (lambda (t) (if (zero? t) 5 0)) "jump: (= t 0) at t = 0")
  (check-path (lambda (t) (/ (square (- t 2)) (- t 2))) "no value: (/ 1 (- t 2)) at t = 2")
  (check-path (lambda (t) (/ t t)) "no value: (/ 1 t) at t = 0")
  (check-path (lambda (t) (exp (log t))) "no value: (log t) at t = 0")
  (check-path (lambda (t) (atan (sin t) (cos t)))
              "jump: (atan (sin t) (cos t)) where (sin t) = 0, (cos t) < 0")
  (check-path (D abs) "kink: (abs t) at t = 0" "no value: (/ 1 (abs t)) at t = 0"))

(define (check-kinks verdict . expected)
  (check-pred undecided? verdict)
  (check-equal? (format "~s" (verdict-kinks verdict)) (format "~s" expected)))

(test-case "a power whose derivative has no value at an end keeps the kink there"
  (define (L local)
    (- (* 1/2 (square (velocity local)))
       (expt (* (square (sin (coordinate local))) (+ 1 (square (velocity local)))) 1/2)))
  (define v (verify-conserved L (Lagrangian->energy L) line))
  (check-pred undecided? v)
  (check-equal? (map car (verdict-kinks v)) '(kink kink)))

(test-case "where a sign was assumed the kink is named all the same"
  (check-kinks (verify-solution L-free (lambda (t) (sqrt (square t))))
               '(kink (sqrt (expt t 2)) (= t 0)))
  (check-kinks (verify-solution L-free (lambda (t) (acos (cos t))))
               '(kink (acos (cos t)) (= t (* :pi n))))
  (check-kinks (verify-solution L-free (lambda (t) (asin (sin t))))
               '(kink (asin (sin t)) (= t (+ (* :pi n) (* 1/2 :pi)))))
  (check-kinks (verify-solution L-free (lambda (t) (expt (expt t 3) 1/3)))
               '(no-value (expt (expt t 3) 1/3) (= t 0))))

(test-case "|sin t| solves the oscillator between its kinks"
  (check-open (verify-solution (L-harmonic 'm 'm) (lambda (t) (abs (sin t))))
              '("kink: (abs (sin t)) at t = (* :pi n) for integers n"))
  (check-open (verify-solution (L-harmonic 'm (* 'm (square 'w)))
                               (lambda (t) (abs (sin (* 'w t)))))
              '("kink: (abs (sin (* t w))) at t = (/ (* :pi n) w) for integers n")))

(test-case "a jump is no conserved quantity"
  (define L (L-with (lambda (x) (* 'k x))))
  (check-open (verify-conserved L step line) '("jump: (sgn x) at x = 0"))
  (check-open (verify-conserved L (lambda (local) (sgn (- (velocity local) 'c))) line)
              '("jump: (sgn (- v c)) at v = c"))
  (check-open (verify-conserved L (lambda (local) +nan.0) line)
              '("no value: +nan.0 everywhere"))
  (define (angles local)
    (+ (atan (coordinate local)) (atan (/ 1 (coordinate local)))))
  (check-kinks (verify-conserved L angles line) '(jump (atan (/ 1 x)) (= x 0))))

(test-case "a step in the potential is no total time derivative, and not ignorable"
  (check-open (verify-total-time-derivative step line) '("jump: (sgn x) at x = 0"))
  (check-exn #rx"Euler-Lagrange expression: 0\n  jump: [(]sgn x[)] at x = 0$"
             (lambda () (gauge-function step line)))
  (check-open (verify-ignorable (L-with sgn) 'x line) '("jump: (sgn x) at x = 0"))
  (check-equal? (ignorable-coordinates (L-with sgn) line) '())
  (define (compared V W)
    (assuming ('(> m 0)) (verify-equivalent-Lagrangians (L-with V) (L-with W) line)))
  (check-open (compared square (lambda (x) (+ (square x) (sgn x)))) '("jump: (sgn x) at x = 0"))
  (check-open (compared sgn (lambda (x) (* 2 (sgn x)))) '("jump: (sgn x) at x = 0"))
  (check-open (verify-equilibrium (L-with sgn) 'a) '("jump: (sgn a) at a = 0"))
  (check-open (verify-solution (L-with sgn) (lambda (t) (- t 1)))
              '("jump: (sgn (- t 1)) at t = 1")))

(test-case "Frobenius's test differentiates the coefficients"
  (define cut
    (nonholonomic (lambda (t q v) (+ (ref v 2) (* (sgn (ref q 0)) (ref v 1))))))
  (check-open (Frobenius-test cut (up 'x 'y 'z)) '("jump: (sgn x) at x = 0"))
  (check-exn #rx"is not known to be integrable.*\n  jump: [(]sgn x[)] at x = 0$"
             (lambda () (constraint-integral cut (up 'x 'y 'z)))))
