#lang racket/base
;; Trajectories and events.

(require mechanics
         (only-in mechanics/book L-harmonic L-pendulum)
         "../support/checks.rkt" "../support/close.rkt")

(define pendulum (Lagrangian->state-derivative (L-pendulum 9.8 1 1)))
(define period 2.140228719018093)                    ; from 1 rad

(define oscillator (Lagrangian->state-derivative (L-harmonic 1 1)))

(test-case "a trajectory is a function of time"
  (define tr (evolve-trajectory oscillator (up 0 1 0) 10 #:tolerance 1e-12))
  (for ([k (in-range 101)])
    (define s (tr (/ k 10)))
    (check-equal? (time s) (exact->inexact (/ k 10)))
    (check-= (coordinate s) (cos (time s)) 1e-11))
  (check-equal? (trajectory-start tr) 0.0)
  (check-equal? (trajectory-end tr) 10.0)
  (check-equal? (trajectory-final-state tr) (tr 10))
  (check-equal? (map time (trajectory-states tr '(1 2 3))) '(1.0 2.0 3.0))
  (define own (map time (trajectory-states tr)))
  (check-equal? (car own) 0.0)
  (check-true (apply < own))
  (check-equal? (format "~a" tr) "(trajectory from 0.0 to 10.0)"))

(test-case "backwards"
  (define tr (evolve-trajectory oscillator (up 0 1 0) -10 #:tolerance 1e-12))
  (check-= (coordinate (tr -7)) (cos 7) 1e-11)
  (check-exn #rx"outside the trajectory" (lambda () (tr 1))))

(test-case "events are found at their time, by direction"
  (define (bottom direction) (event coordinate #:direction direction #:name 'bottom))
  (define (times direction)
    (map occurrence-time
         (trajectory-events
          (evolve-trajectory pendulum (up 0 1 0) 6 #:tolerance 1e-13 #:events (bottom direction)))))
  (define expected
    (for/list ([k 6] #:when (< (* (+ k 1/2) 1/2 period) 6)) (* (+ k 1/2) 1/2 period)))
  (define (every-other ts from) (for/list ([t ts] [k (in-naturals from)] #:when (even? k)) t))
  (check-close (times 'both) expected 1e-11)
  (check-close (times 'falling) (every-other expected 0) 1e-11)
  (check-close (times 'rising) (every-other expected 1) 1e-11))

(test-case "a terminal event ends the trajectory there"
  (define apex (event velocity #:name 'apex #:direction 'rising #:terminal? #t))
  (define tr (evolve-trajectory pendulum (up 0 1 -1e-9) 100 #:tolerance 1e-13 #:events (list apex)))
  (check-= (trajectory-end tr) (/ period 2) 1e-8)
  (check-= (coordinate (trajectory-final-state tr)) -1 1e-9)
  (check-equal? (map (lambda (o) (event? (occurrence-event o))) (trajectory-events tr)) '(#t))
  (check-exn #rx"outside the trajectory" (lambda () (tr 2))))

(test-case "several events come in the order of time"
  (define tr
    (evolve-trajectory oscillator (up 0 1 0) 10 #:tolerance 1e-12
                       #:events (list (event coordinate #:name 'zero)
                                      (event velocity #:name 'turn))))
  (check-true (apply < (map occurrence-time (trajectory-events tr))))
  (for ([o (trajectory-events tr)] [k (in-naturals 1)])
    (check-= (occurrence-time o) (* k :pi/2) 1e-11)))

(test-case "an event that is true at the start is not one"
  (define tr (evolve-trajectory oscillator (up 0 0 1) 3 #:events (event coordinate)))
  (check-equal? (trajectory-events tr) '()))

(test-case "two zeros within one step are both found"
  (define free (lambda (s) (up 1 (velocity s) 0)))
  (define tr (evolve-trajectory free (up 0 0 1) 10
                                #:events (event (lambda (s) (* (- (coordinate s) 4.1)
                                                               (- (coordinate s) 5.9))))))
  (check-equal? (map (lambda (o) (/ (round (* 1e6 (occurrence-time o))) 1e6))
                     (trajectory-events tr))
                '(4.1 5.9)))

(test-case "a motion that ends just beyond a zero comes to it"
  (for ([method '(Taylor Dormand-Prince-853)])
    (define tr
      (evolve-trajectory (lambda (s) (up 1 (* 2 (time s)))) (up 0 0) (+ 1 1e-13) #:method method
                         #:events (event (lambda (s) (- (ref s 1) 1)))))
    (check-equal? (length (trajectory-events tr)) 1)))

(test-case "a ball leaves a sphere where cos θ = 2/3"
  (define ((on-sphere g R) (up t θ v)) (up 1 v (* (/ g R) (sin θ))))
  (define force (event (lambda (s) (- (* 9.8 (cos (coordinate s))) (square (velocity s))))
                       #:direction 'falling #:terminal? #t))
  (define tr
    (evolve-trajectory (on-sphere 9.8 1) (up 0 1e-9 0) 100 #:tolerance 1e-12 #:events force))
  (check-= (cos (coordinate (trajectory-final-state tr))) 2/3 1e-9))

(test-case "where the motion ends, the failure carries the trajectory so far"
  (define (falling-in s) (up 1 (velocity s) (/ -1 (square (coordinate s)))))
  (define tr
    (with-handlers ([exn:fail:mechanics:singular? exn:fail:mechanics:singular-where])
      (evolve-trajectory falling-in (up 0 1 0) 2)))
  (check-true (trajectory? tr))
  (check-= (trajectory-end tr) (/ :pi (* 2 (sqrt 2))) 1e-6)
  (define s (tr 1/2))
  (check-= (- (* 1/2 (square (velocity s))) (/ 1 (coordinate s))) -1 1e-9))

(test-case "mistakes"
  (check-exn #rx"expected events; \\(event f\\) makes one"
             (lambda () (evolve-trajectory oscillator (up 0 1 0) 1 #:events coordinate)))
  (check-exn #rx"the value of an event's function is a real number"
             (lambda ()
               (evolve-trajectory oscillator (up 0 1 0) 1 #:events (event (lambda (s) s)))))
  (check-exn #rx"trajectory-end: .*expected a trajectory, .*given: the number 5"
             (lambda () (trajectory-end 5)))
  (check-exn #rx"trajectory-states: .*given: the number 5" (lambda () (trajectory-states 5 '(1))))
  (check-exn #rx"'rising, 'falling or 'both" (lambda () (event coordinate #:direction 'up)))
  (check-exn #rx"outside the trajectory.*time: 11.*from: 0.0.*to: 10.0"
             (lambda () ((evolve-trajectory oscillator (up 0 1 0) 10) 11))))

;; ---------------------------------------------------------------------------
;; Methods

(define names '(Dormand-Prince-853 Dormand-Prince-54 bulirsch-stoer qcrk4))

(test-case "all methods agree, by keyword, as parameter and as the book sets them"
  (define (final-angle #:method [m (ode-integration-method)])
    (coordinate (trajectory-final-state
                 (evolve-trajectory pendulum (up 0 1 0) 3 #:tolerance 1e-10 #:method m))))
  (define expected (final-angle))
  (for ([m names])
    (check-= (final-angle #:method m) expected 1e-8)
    (check-= (parameterize ([ode-integration-method m]) (final-angle)) expected 1e-8))
  (for ([m (list (Yoshida-6 0.01) (Yoshida-8 0.01) (Gauss-Legendre-6 0.01))])
    (check-= (final-angle #:method m) expected 1e-7))
  (for ([m (list (Yoshida-4 0.01) (Gauss-Legendre-4 0.01))])
    (check-= (final-angle #:method m) expected 1e-5))
  (for ([m (list (leapfrog 0.01) (Gauss-Legendre-2 0.01))])
    (check-= (final-angle #:method m) expected 1e-2))
  (parameterize ([ode-integration-method 'qcrk4])
    (set-ode-integration-method! 'bulirsch-stoer)
    (check-equal? (ode-integration-method) 'bulirsch-stoer)))

(test-case "leapfrog keeps the energy of the pendulum for a hundred periods"
  (define E (Lagrangian->energy (L-pendulum 9.8 1 1)))
  (define tr (evolve-trajectory pendulum (up 0 1 0) 214 #:method (leapfrog 0.01)))
  (for ([t (in-range 0 214 3)])
    (check-= (E (tr t)) (E (tr 0)) 5e-3)))

(test-case "methods print as what makes them"
  (check-equal? (format "~a" (leapfrog 0.5)) "(leapfrog 0.5)"))

(test-case "mistakes about methods"
  (check-exn
   #rx"expected a method of integration or the name of one.*given: the symbol unheard-of.*qcrk4"
   (lambda () (set-ode-integration-method! 'unheard-of)))
  (check-exn #rx"evolve-trajectory: expected a method"
             (lambda () (evolve-trajectory oscillator (up 0 1 0) 1 #:method 4)))
  (check-exn #rx"leapfrog: expected a positive time step" (lambda () (leapfrog 0))))
