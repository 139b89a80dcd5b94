#lang racket/base
;; Energy over a million steps: symplectic methods let it go up and down, not away.

(require racket/flonum
         (prefix-in m: mechanics)
         mechanics/motion/system/make-system mechanics/motion/system/system
         mechanics/numeric/ode/gauss-legendre mechanics/numeric/ode/doubled-runge-kutta
         mechanics/numeric/ode/stepper mechanics/numeric/ode/symplectic
         "../support/checks.rkt")

;; A pendulum, released at 1 rad: period 6.7.
(define (H state) (m:- (m:* 1/2 (m:square (m:ref state 2))) (m:cos (m:ref state 1))))
(define (Hamilton-equations state)
  (m:up 1 (((m:partial 2) H) state) (m:- (((m:partial 1) H) state))))

(define start (m:up 0.0 1.0 0.0))
(define f! ((system-make-slope! (make-system 'test Hamilton-equations start))))

(define (energy y)
  (fl- (fl* 0.5 (fl* (flvector-ref y 2) (flvector-ref y 2))) (flcos (flvector-ref y 1))))

;; The mean and the greatest change of energy in each tenth of so many steps.
(define (energy-changes m h count)
  (define s ((method-start m) f! (flvector 0.0 1.0 0.0)))
  (define y (stepper-state s))
  (define at-start (energy y))
  (define tenth (quotient count 10))
  (for/lists (means greatest) ([_ (in-range 10)])
    (for/fold ([sum 0.0] [most 0.0] #:result (values (/ sum tenth) most)) ([_ (in-range tenth)])
      ((stepper-try! s) h)
      ((stepper-accept! s))
      (define change (fl- (energy y) at-start))
      (values (fl+ sum change) (flmax most (flabs change))))))

;; How much of the mean's change over all tenths is a straight line.
(define (trend means)
  (define n (length means))
  (define middle (/ (- n 1) 2.0))
  (define mean (/ (apply + means) n))
  (define slope
    (/ (for/sum ([m (in-list means)] [k (in-naturals)]) (* (- k middle) (- m mean)))
       (for/sum ([k (in-range n)]) (expt (- k middle) 2))))
  (* n (abs slope)))

;; Error that repetition up to rounding leaves in a million steps.
(define rounding 5e-12)

(define (check-no-drift make count)
  (define m (make 0.1))
  (test-case (format "~a: energy does not drift in ~a steps" (method-name m) count)
    (define-values (means greatest) (energy-changes m 0.1 count))
    (define early (car greatest))
    (check-true (< (apply max greatest) (+ rounding (* 1.01 early))) (format "~a" greatest))
    (check-true (< (trend means) (+ rounding (* 1e-3 early))) (format "~a" means))))

(for ([make (in-list (list leapfrog yoshida-4 yoshida-6 yoshida-8 gauss-legendre-2))])
  (check-no-drift make 1000000))
(for ([make (in-list (list gauss-legendre-4 gauss-legendre-6))])
  (check-no-drift make 300000))

(test-case "that of a method that is not symplectic does"
  (define-values (means greatest) (energy-changes quality-controlled-runge-kutta-4 0.1 100000))
  (check-true (> (trend means) (* 0.5 (apply max greatest))))
  (check-true (> (list-ref greatest 9) (* 5 (car greatest)))))
