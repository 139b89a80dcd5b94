#lang racket/base
;; Integrals to infinity of functions that go up and down at equal distances while they
;; decay, without changing their sign: (sin x/x)², (2 + cos x)/(1 + x²).
;;
;; Over whole periods T the rest from X on is c₁ X^−p + c₂ X^−p−1 + …, as if the function
;; did not oscillate.  So the integrals up to X = rT, 2rT, 4rT … have differences that are
;; sums of geometric sequences, and the epsilon algorithm finds their limit.  The period is
;; the distance of minima, measured very far away, where decaying does not move them.

(require "epsilon-algorithm.rkt" "gauss-kronrod.rkt"
         "../finite-number.rkt"
         "../optimization/golden-section.rkt")

(provide periodic-quadrature)

(define most-doublings 10)
(define least-doublings 4)

;; The integral of f from 0 to infinity and a bound of its error, or #f twice;
;; unit : a length over which f may begin to change
(define (periodic-quadrature f unit tolerance)
  (let/ec return
    (define (fail) (return #f #f))
    (define-values (start period) (find-period f unit fail))
    (unless (decaying? f start period) (fail))
    (define (part a b) (or (part-integral f a b tolerance 10000) (fail)))
    (let loop ([k 0] [x start] [sum (part 0.0 start)] [diagonal '()] [limits '()])
      (define longer (extend-diagonal diagonal sum))
      (define found (cons (estimated-limit longer) limits))
      (define off (and (> k least-doublings) (abs (- (car found) (cadr found)))))
      (cond [(and off (<= off (* 3e-2 tolerance (abs sum))))
             (values (car found) (+ (* 30.0 off) (* 1e-14 (abs sum))))]
            [(= k most-doublings) (fail)]
            [else
             (define next (+ x (* period (expt 2 k) periods-at-first)))
             (loop (+ k 1) next (+ sum (part x next)) longer found)]))))

;; ---------------------------------------------------------------------------

(define periods-at-first 8)

;; -> a multiple of the period, near a minimum, and the period
(define (find-period f unit fail)
  (define first-ones (minima-from f 0.0 (/ unit 16.0) 1000 5 fail))
  (define gap (- (car first-ones) (cadr first-ones)))
  (define rough
    (for/fold ([gap gap]) ([far (in-list '(1e2 1e4))])
      (define (minimum-at x) (car (minima-from f x (/ gap 16.0) 100 1 fail)))
      (define one (minimum-at (* far gap)))
      (define other (minimum-at (* 2.0 far gap)))
      (define periods (round (/ (- other one) gap)))
      (when (= periods 0.0) (fail))
      (define better (/ (- other one) periods))
      (unless (< (abs (- better gap)) (* 0.1 gap)) (fail))
      better))
  (values (* periods-at-first rough) rough))

;; Some minima of f after s, the last first.
(define (minima-from f s step most-steps count fail)
  (let loop ([x (+ s step)] [y (f s)] [y* (f (+ s step))] [steps 0] [found '()])
    (define next (+ x step))
    (define y** (f next))
    (cond [(= (length found) count) found]
          [(or (= steps most-steps) (not (and (finite? y) (finite? y*) (finite? y**)))) (fail)]
          [(and (>= y y*) (< y* y**))
           (loop next y* y** 0 (cons (minimum-between f (- x step) next) found))]
          [else (loop next y* y** (+ steps 1) found)])))

(define (minimum-between f a b)
  (car (golden-section f a b (width-at-most 1e-9))))

;; The mean over a period falls as a power above the first, at least, to very far away.
(define (decaying? f start period)
  (define (amplitude x)
    (for/fold ([most 0.0]) ([k (in-range 40)])
      (max most (abs (f (+ x (* period 0.0618034 k)))))))
  (define near (amplitude start))
  (for/and ([far (in-list '(1e2 1e4 1e6))])
    (< (* far (amplitude (* far start))) (* (expt far -0.05) near))))
