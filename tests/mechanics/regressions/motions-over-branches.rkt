#lang racket/base
;; Taylor series know nothing of branches: that of √x² about 1 is x, and x is what it stays beyond
;; 0; that of atan tan x goes on beyond π/2.  So motions by the usual method went over such places
;; as if nothing were there: q̈ = -q/√q² to t = 20 was wrong by 2, ẋ = atan tan t by 10¹⁶.  And a
;; force that is nothing for so long as the series can tell was never noticed where it is nothing
;; again at the end: ẋ = sin⁴⁰ t from 0 to 2π gave 0.  The expected values follow from formulas.

(require (except-in mechanics time) "../support/checks.rkt")

(define (reached f start span method)
  (ref ((state-advancer (lambda () f)) start span 1e-10 #:method method) 1))

;; Of a method that cannot follow a motion there is a message, and no number.
(define (check-reached f start span expected [tolerance 1e-7])
  (check-= (reached f start span 'auto) expected tolerance)
  (define by-Taylor
    (with-handlers ([exn:fail? (lambda (e) expected)]) (reached f start span 'Taylor)))
  (check-= by-Taylor expected tolerance))

(define pi 3.141592653589793)
(define (turns x period) (floor (/ x period)))

(test-case "the modulus as a root: parabolas, in turn"
  (define rates
    (Lagrangian->state-derivative
     (lambda (s) (- (* 1/2 (square (velocity s))) (sqrt (square (coordinate s)))))))
  (define quarter (sqrt 2.0))
  (define (expected t)
    (define k (turns (+ t quarter) (* 2 quarter)))       ; how often it has passed 0
    (define u (- t (* 2 k quarter)))
    (* (if (even? (inexact->exact k)) 1 -1) (- 1 (* 1/2 u u))))
  (for ([t '(1.0 2.0 3.0 5.0 8.0 20.0)])
    (check-reached rates (up 0 1.0 0.0) t (expected t))
    (check-reached rates (up 0 1.0 0.0) (- t) (expected t))))

(test-case "arcs: ∫ of t less whole turns"
  (define (by-atan s) (up 1 (atan (tan (ref s 0)))))
  (define (by-angle s) (up 1 (atan (sin (ref s 0)) (cos (ref s 0)))))
  (define (by-asin s) (up 1 (asin (sin (ref s 0)))))
  (define (saw t period)
    (define u (- t (* period (turns (+ t (* 1/2 period)) period))))
    (* 1/2 u u))
  ;; up and down
  (define (triangle t)
    (define u (- t (* 2 pi (turns (+ t (* 1/2 pi)) (* 2 pi)))))
    (if (< u (* 1/2 pi)) (* 1/2 u u) (- (* 1/4 pi pi) (* 1/2 (- u pi) (- u pi)))))
  (for ([t '(1.0 4.0 10.0 30.0)])
    (check-reached by-atan (up 0 0.0) t (saw t pi))
    (check-reached by-angle (up 0 0.0) t (saw t (* 2 pi)))
    (check-reached by-asin (up 0 0.0) t (triangle t))))

(test-case "a kink in an exponent, and one passed twice within a step"
  (check-reached (lambda (s) (up 1 (exp (- (sqrt (expt (- (ref s 0) 2) 2)))))) (up 0 0.0) 4.0
                 (* 2 (- 1 (exp -2.0))))
  ;; ∫ |t² - 1| from -2 to 2
  (check-reached (lambda (s) (up 1 (sqrt (square (- (square (ref s 0)) 1))))) (up -2 0.0) 4.0 4.0))

(test-case "a force that is nothing at both ends"
  ;; 2π (40 choose 20)/2⁴⁰
  (check-reached (lambda (s) (up 1 (expt (sin (ref s 0)) 40))) (up 0 0.0) (* 2 pi)
                 (* 2 pi 137846528820 (expt 2.0 -40))))

(test-case "roots that have no kink on the way are followed as before"
  (define (kepler s)
    (define q (ref s 1))
    (up 1 (ref s 2) (* -1 (/ 1 (expt (square q) 3/2)) q)))
  (define start (up 0 (up 0.1 0.0) (up 0.0 (sqrt 19.0))))
  (for ([method '(auto Taylor)])
    (define end ((state-advancer (lambda () kepler)) start (* 10 pi) 1e-13 #:method method))
    (check-= (ref end 1 0) 0.1 1e-10)
    (check-= (ref end 1 1) 0.0 1e-9)))
