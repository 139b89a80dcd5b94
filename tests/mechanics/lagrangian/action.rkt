#lang racket/base
;; Actions (SICM 1.4): V1 and what they say of what is no number.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/value/structure
         mechanics/calculus/derivative
         mechanics/search/minimize
         mechanics/lagrangian/action
         mechanics/lagrangian/local-tuple
         (only-in mechanics/book L-free-particle L-harmonic)
         "../support/checks.rkt" "../support/messages.rkt")

(define (test-path t) (up (g:+ (g:* 4 t) 7) (g:+ (g:* 3 t) 5) (g:+ (g:* 2 t) 1)))

;; A variation that vanishes at both ends.
(define ((make-eta nu t1 t2) t) (g:* (g:- t t1) (g:- t t2) (nu t)))
(define (nu t) (up (g:sin t) (g:cos t) (g:square t)))
(define (varied epsilon)
  (Lagrangian-action (L-free-particle 3) (g:+ test-path (g:* epsilon (make-eta nu 0 10))) 0 10))

;; ---------------------------------------------------------------------------
;; V1

(test-case "V1: the action of a free particle on a straight path is 435"
  (check-= (Lagrangian-action (L-free-particle 3) test-path 0 10) 435 1e-12))

(test-case "V1: varied by 0.001 η it is 435 + 18077/14000"
  (check-= (varied 0.001) (+ 435 18077/14000) 1e-9))

(test-case "V1: the least action is at no variation"
  (define minimum (minimize varied -2 1))
  (check-= (car minimum) 0 1e-5)
  (check-= (cadr minimum) 435 1e-9)
  (check-true (<= 4 (caddr minimum) 6)))

(test-case "exercise 1.4: the action of a free particle is m (Δx)²/(2 Δt)"
  (for ([m '(1 5/2)] [xa '(0 3)] [xb '(4 -1)] [t1 '(0 1)] [t2 '(2 5)])
    (define (path t) (g:+ xa (g:* (/ (- xb xa) (- t2 t1)) (g:- t t1))))
    (check-= (Lagrangian-action (L-free-particle m) path t1 t2)
             (/ (* m (expt (- xb xa) 2)) (* 2 (- t2 t1))) 1e-12)))

(test-case "the action of the oscillator over a quarter period"
  ;; ½ (m v² - k x²) on x = cos t, m = k = 1: -½ cos 2t, whose integral is 0
  (check-= (Lagrangian-action (L-harmonic 1 1) g:cos 0 (acos 0.0)) 0 1e-12)
  (check-= (Lagrangian-action (L-harmonic 1 1) g:cos 0 (/ (acos 0.0) 2)) -1/4 1e-12))

(test-case "a tolerance may be given"
  (check-= (Lagrangian-action (L-free-particle 3) test-path 0 10 1e-4) 435 1e-3))

(test-case "V1: the derivative of the varied action is 0 at no variation, and its second is not"
  (check-= ((D varied) 0) 0 1e-9)
  (check-= ((D (D varied)) 0) (* 2 1000000 18077/14000) 1e-3)
  (check-= ((D varied) 1/1000) (* 2 1000 18077/14000) 1e-6))

(test-case "Lagrangians that depend on accelerations have actions too"
  ;; on q = t³ from 0 to 1: ∫ q q̈ = ∫ 6 t⁴ = 6/5, by parts −∫ q̇² plus the ends, −9/5 + 3
  (define (L local) (g:* (coordinate local) (acceleration local)))
  (check-= (Lagrangian-action L g:cube 0 1 #:order 2) 6/5 1e-12)
  (check-exn #rx"^acceleration: expected a local tuple .* with accelerations"
             (lambda () (Lagrangian-action L g:cube 0 1)))
  (check-exn #rx"^Lagrangian-action: .*an order, a positive integer"
             (lambda () (Lagrangian-action L g:cube 0 1 #:order 0))))

;; ---------------------------------------------------------------------------
;; Results and limits other than numbers

(test-case "symbols left in the action, or in the limits, are in the formula"
  (check-equal? (g:- (Lagrangian-action (L-free-particle 'm) test-path 0 10) (g:* 145 'm)) 0)
  (check-exn
   #rx"^Lagrangian-action: no formula was found for the integral of .*\n  give its symbols values first: [(]substitute expression 'm 3 [.][.][.][)]$"
   (lambda () (Lagrangian-action (lambda (s) (g:exp (g:* 'm (g:square (time s)))))
                                 test-path 0 't2))))

(test-case "what is no function is refused"
  (check-exn #rx"^Lagrangian-action: a Lagrangian is a function of the local tuple"
             (lambda () (Lagrangian-action 3 test-path 0 1)))
  (check-exn #rx"a path is a function of time"
             (lambda () (Lagrangian-action (L-free-particle 3) 'q 0 1))))

(test-case "a path and a Lagrangian in the wrong order"
  (check-message
   "Lagrangian-action: the Lagrangian comes first, then the path; these look swapped"
   (Lagrangian-action g:cos (L-harmonic 1 1) 0 1))
  ;; A failure in either order is told as it comes.
  (define (fails t) (raise-arguments-error 'fails "at all times"))
  (check-message "fails: at all times" (Lagrangian-action (L-harmonic 1 1) fails 0 1)))
