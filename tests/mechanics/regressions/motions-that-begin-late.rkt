#lang racket/base
;; Far from time 0, what rounding makes of the time is many times what it makes of a step: by
;; 2e-7 s in seconds since 1970, by 5e-10 d on Julian dates.  Steps were of one length for the
;; state and of another for the time, and the state followed another motion: wrong by 1e-5 where
;; 1e-10 was asked for, by 0.02 with short equal steps.  The motion does not depend on the time,
;; so what begins late has to agree with what begins at 0; and that with a formula.

(require (except-in mechanics time) "../support/checks.rkt")

(define (oscillator s) (up 1 (ref s 2) (* -100 (ref s 1))))
(define (error-at start method span)
  (define end ((state-advancer (lambda () oscillator)) (up start 1.0 0.0) span 1e-10
                                                       #:method method))
  (abs (- (ref end 1) (cos (* 10 span)))))

(define methods
  (list 'auto 'Taylor 'Dormand-Prince-853 'Dormand-Prince-54 'bulirsch-stoer 'qcrk4 'Radau-IIA-5
        (leapfrog 1e-4) (Yoshida-8 0.01) (Gauss-Legendre-4 0.001) (Gauss-Legendre-6 0.01)))

(for* ([m (in-list methods)]
       [span (in-list '(2.0 -2.0))]
       [from-0 (in-value (error-at 0.0 m span))]
       [start (in-list '(2451545.0 1.7e9 -1.7e9))])
  (test-case (format "~a from ~a on, for ~a, is as good as from 0 on" m start span)
    (check-true (<= (error-at start m span) (+ (* 2 from-0) 1e-10)))))

(test-case "trajectories and monitored motions that begin late"
  (define tr
    (evolve-trajectory oscillator (up 1.7e9 1.0 0.0) (+ 1.7e9 2) #:method 'Dormand-Prince-853))
  (for ([t (in-list '(0.0 0.25 0.5 1.0 1.75 2.0))])
    (check-= (ref (tr (+ 1.7e9 t)) 1) (cos (* 10 t)) 1e-9))
  (define seen '())
  ((evolve (lambda () oscillator)) (up 1.7e9 1.0 0.0)
                                   (lambda (s) (set! seen (cons s seen)))
                                   0.25 (+ 1.7e9 2) 1e-10 #:method (Yoshida-8 0.001))
  (for ([s (in-list seen)])
    (check-= (ref s 1) (cos (* 10 (- (ref s 0) 1.7e9))) 1e-9)))

;; A million steps of 0.1, which is no sum of powers of 2: the time of each was rounded.
(test-case "equal steps do not add up the rounding of their times"
  (define (slow s) (up 1 (ref s 2) (- (ref s 1))))
  (define end
    ((state-advancer (lambda () slow)) (up 0 1.0 0.0) 1e5 1e-10 #:method (Gauss-Legendre-6 0.1)))
  ;; the method turns by as much each step: (1 - z²/10 + i (z/2 - z³/120)) over its conjugate
  (define z 1/10)
  (define turn (* 2 (atan (- (/ z 2) (/ (expt z 3) 120)) (- 1.0 (/ (expt z 2) 10)))))
  (check-= (ref end 1) (cos (* 1000000 turn)) 1e-8))

;; A step may be asked for that is shorter than times are apart; and near a singularity a step
;; that fails may be as long as the next one, but for rounding.
(test-case "late motions that change slowly, or end"
  (define (decay s) (up 1 (* -1e-7 (ref s 1))))
  (define (falling s) (up 1 (ref s 2) (/ -1 (square (ref s 1)))))
  (for ([m (in-list '(Dormand-Prince-853 bulirsch-stoer qcrk4 Radau-IIA-5))])
    (define end ((state-advancer (lambda () decay)) (up 1e12 1.0) 1e7 1e-10 #:method m))
    (check-= (ref end 1) (exp -1.0) 1e-10)
    (for ([start (in-list '(0 1e9))])
      (check-exn exn:fail:mechanics:singular?
                 (lambda ()
                   ((state-advancer (lambda () falling)) (up start 1.0 0.0) 2 1e-10
                                                         #:method m))))))
