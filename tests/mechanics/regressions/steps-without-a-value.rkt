#lang racket/base
;; A potential that has no value at a place, and stays bounded beside it, may jump there: of
;; x/|x| a free motion was proved, and momentum was said to be conserved.

(require (only-in racket/list append*)
         mechanics
         (only-in mechanics/book L-free-particle)
         (only-in "../support/systems.rkt" L-on-a-line)
         "../support/checks.rkt")

(define L-free (L-free-particle 'm))
(define (L-with V) (L-on-a-line 'm V))
(define line (up 't 'x 'v))
(define state (up 't 'q 'p))
(define (uniform t) (* 'c t))
(define (step x) (/ x (abs x)))

(define (gaps verdict)
  (for/list ([k (in-list (verdict-kinks verdict))])
    (check-eq? (car k) 'gap)
    (cddr k)))

;; Open for gaps alone, the first one there.
(define-check (check-gaps verdict equation)
  (with-check-info (['verdict verdict])
    (unless (and (undecided? verdict)
                 (equal? (format "~s" (car (append* (gaps verdict)))) (format "~s" equation)))
      (fail-check))))

(test-case "what is asked of a step"
  (define L (L-with step))
  (check-gaps (verify-conserved L (lambda (local) (* 'm (velocity local))) line) '(= x 0))
  (check-gaps (verify-conserved L (Lagrangian->energy L) line) '(= x 0))
  (check-gaps (verify-solution L uniform) '(= t 0))
  (check-gaps (verify-ignorable L 'x line) '(= x 0))
  (check-gaps (verify-equivalent-Lagrangians L L-free line) '(= x 0))
  (check-equal? (conserved-momenta L line) '())
  (check-gaps (verify-total-time-derivative
               (lambda (local) (* (step (coordinate local)) (velocity local))) line)
              '(= x 0))
  (check-gaps (verify-canonical (lambda (s) (up (time s) (coordinate s)
                                                (+ (momentum s) (step (coordinate s)))))
                                state)
              '(= q 0)))

(test-case "the report says why"
  (check-equal? (format "~a" (verify-ignorable (L-with step) 'x line))
                (string-append "undecided: the residual is zero wherever it is smooth, "
                               "but not decided at some points\n"
                               "  no value: (/ x (abs x)) at x = 0 "
                               "(where all stays bounded on a side)")))

(define (check-steps place . Vs)
  (for ([V (in-list Vs)])
    (with-check-info (['potential (V 'x)])
      (define L (L-with V))
      (check-gaps (verify-conserved L (Lagrangian->energy L) line) place))))

(test-case "other steps, by parts that have no value"
  (check-steps '(= x 0)
               (lambda (x) (/ (abs x) x))
               (lambda (x) (/ x (sqrt (square x))))
               (lambda (x) (* 'V0 x (expt (square x) -1/2)))
               (lambda (x) (atan (/ 1 x)))
               (lambda (x) (+ (atan x) (atan (/ 1 x))))
               (lambda (x) (tanh (/ 1 x)))
               (lambda (x) (/ 1 (+ 1 (exp (/ 1 x)))))
               (lambda (x) (log (+ 2 (step x))))
               (lambda (x) (sin (/ 1 x)))
               (lambda (x) ((literal-function 'W) (/ 1 x))))
  (check-steps '(= x -1/3) (lambda (x) (step (+ x 1/3))) (lambda (x) (atan (/ 1 (+ x 1/3)))))
  (check-steps '(= x a) (lambda (x) (step (- x 'a))))
  (check-steps '(= x (* :pi n)) (lambda (x) (/ (abs x) (tan x)))))

(test-case "a step beside a barrier stays a step"
  (define (V x) (+ (step x) (/ 1 (square (- x 1)))))
  (check-steps '(= x 0) V))

(test-case "a quantity that jumps is not conserved"
  (define (Q local) (+ (velocity local) (log (+ 2 (step (coordinate local))))))
  (check-gaps (verify-conserved L-free Q line) '(= x 0)))

(test-case "no motion passes where a potential is unbounded"
  (for ([V (in-list (list (lambda (x) (/ 'k x)) (lambda (x) (/ 'k (abs x)))
                          (lambda (x) (/ 'k (sqrt (square x)))) (lambda (x) (* 'k (log (abs x))))
                          (lambda (x) (expt (square x) -1/4)) (lambda (x) (log (square (sin x))))
                          (lambda (x) (+ (step x) (/ 'k x)))
                          (lambda (x) (/ (exp (* -1 'k (abs x))) (abs x)))))])
    (define L (L-with V))
    (check-pred proved? (verify-conserved L (Lagrangian->energy L) line))))

(test-case "quotients of analytic functions lead to a value, or are unbounded"
  (for ([V (in-list (list (lambda (x) (/ (sin x) x)) (lambda (x) (/ 1 (tan x)))
                          (lambda (x) (/ ((literal-function 'W) x) x))
                          (lambda (x) (+ (/ (sin x) x) (sqrt (+ 1 (square x)))))))])
    (define L (L-with V))
    (check-pred proved? (verify-conserved L (Lagrangian->energy L) line))))
