#lang racket/base
;; Motion in numbers of higher precision, and what it says of long runs in flonums.

(require mechanics
         "../support/checks.rkt"
         "../support/bigfloats.rkt" "../support/close.rkt" "../support/skip.rkt"
         "../support/systems.rkt")

;; ---------------------------------------------------------------------------
;; Systems

(define ((harmonic ω) (up t x v)) (up 1 v (* -1 (square ω) x)))

;; ---------------------------------------------------------------------------

(skip-unless bigfloats? no-bigfloats
  (define advance-harmonic (state-advancer harmonic 1))

  (test-case "the harmonic oscillator to fifty digits"
    (define T (bigfloat 10 200))
    (check-close (advance-harmonic (up 0 1 0) 10 #:precision 200)
                 (list 10 (cos T) (- (sin T)))
                 1e-50)
    (check-equal? (bigfloat-precision (time (advance-harmonic (up 0 1 0) 1 #:precision 200))) 200))

  (test-case "the error falls with the precision"
    (for/fold ([last 1]) ([bits '(64 100 200 400)])
      (define T (bigfloat 3 (* 2 bits)))
      (define x (coordinate (advance-harmonic (up 0 1 0) 3 #:precision bits)))
      (define error (abs (- (exact x) (exact (cos T)))))
      (check-true (< error (* 10 (expt 10 (- (quotient bits 4))))) (format "~a bits" bits))
      (check-true (< error last) (format "~a bits" bits))
      error))

  (test-case "four links: their mass matrix is eliminated in all digits"
    (define E (Lagrangian->energy (L-chain 4 10)))
    (define (all x) (apply up (for/list ([i 4]) x)))
    (define start (up 0 (all 1) (all (bigfloat 0 120))))
    (define end
      ((state-advancer (lambda () (Lagrangian->state-derivative (L-chain 4 10))))
       start 1/4 1e-25 #:precision 120))
    (define before (E (up 0 (all (bigfloat 1 120)) (all 0))))
    (check-true (< (abs (- (E end) before)) 1e-23)))

  (test-case "a decision is followed, and a captured number is not rounded"
    (define k (bigfloat 1/3 200))
    (define ((by-halves) (up t x v)) (up 1 v (if (< x 10) (* 2 k) 0)))
    (define ((plain) (up t x v)) (up 1 v (* 2 k)))
    (for ([f (list by-halves plain)])
      (check-close ((state-advancer f) (up 0 0 0) 2 #:precision 150) '(2 4/3 4/3) 1e-35)))

  (test-case "the monitor sees exact times, forwards and backwards"
    (define seen '())
    (define (note s) (set! seen (cons (bigfloat->exact (time s)) seen)))
    (define last ((evolve harmonic 1) (up 0 1 0) note 3/10 1 #:precision 100))
    (check-equal? (map (lambda (t) (exact->inexact t)) (reverse seen)) '(0.0 0.3 0.6 0.9 1.0))
    (check-equal? (time last) (bigfloat 1 100))
    (set! seen '())
    ((evolve harmonic 1) (up 0 1 0) note 1/2 -1 #:precision 100)
    (check-equal? (reverse seen) '(0 -1/2 -1)))

  (test-case "a trajectory is as precise between steps as at their ends"
    (define tr (evolve-trajectory (harmonic 2) (up 0 1 0) 10 #:precision 200))
    (check-equal? (map exact (list (trajectory-start tr) (trajectory-end tr))) '(0 10))
    (for ([t (list 0 1/3 (bigfloat 2 200) 9.75 10)])
      (define T (* 2 (bigfloat t 200)))
      (check-close (tr t) (list t (cos T) (* -2 (sin T))) 1e-48))
    (check-exn #rx"trajectory: the time is outside the trajectory" (lambda () (tr 11)))
    (check-true (< 5 (length (trajectory-states tr)) 100)))

  (test-case "events are found to all digits, in their order, and end the motion"
    (define down (event coordinate #:name 'down #:direction 'falling))
    (define turn (event velocity #:name 'turn))
    (define π (acos (bigfloat -1 200)))
    (define tr
      (evolve-trajectory (harmonic 1) (up 0 1 0) 7 #:precision 150 #:events (list turn down)))
    (define found (trajectory-events tr))
    (check-equal? (map occurrence-event found) (list down turn turn))
    (for ([o found] [t (list (/ π 2) π (* 2 π))])
      (check-true (< (abs (- (exact (occurrence-time o)) (exact t))) 1e-36)))
    (check-true (< (abs (exact (coordinate (occurrence-state (car found))))) 1e-36))
    (define back
      (evolve-trajectory (harmonic 1) (up 0 1 0) -7 #:precision 100
                         #:events (event coordinate #:terminal? #t)))
    (check-true (< (abs (+ (exact (trajectory-end back)) (exact (/ π 2)))) 1e-24))
    (check-exn #rx"outside the trajectory" (lambda () (back -2)))
    (define pole (event (lambda (s) (/ 1 (coordinate s))) #:terminal? #t))
    (check-true (null? (trajectory-events
                        (evolve-trajectory (harmonic 1) (up 0 1 0) 3 #:precision 64
                                           #:events pole))))
    (define (late s) (if (< (time s) 1) 1 'late))
    (check-exn #rx"the function of an event has no real value"
               (lambda () (evolve-trajectory (harmonic 1) (up 0 1 0) 3 #:precision 64
                                             #:events (event late)))))

  (test-case "several events within one step come in the order of the motion, backwards as well"
    (define ((steady) (up t x)) (up 1 1))
    (define ((at . places) s) (for/product ([p places]) (- (coordinate s) p)))
    (define (first sign) (event (compose (at 1/5 7/10) (times sign)) #:name 'first))
    (define (second sign) (event (compose (at 9/20 1/20) (times sign)) #:name 'second))
    (define ((times sign) s) (* sign s))
    (define (follow end . events)
      (evolve-trajectory (steady) (up 0 0) end #:precision 80 #:events events))
    (define (found tr)
      (for/list ([o (trajectory-events tr)])
        (/ (round (* 1e9 (exact (occurrence-time o)))) 1e9)))
    (define expected '(0.05 0.2 0.45 0.7))
    (define forwards (follow 1 (first 1) (second 1)))
    (check-true (<= (length (trajectory-states forwards)) 3) "one step holds them")
    (check-equal? (found forwards) expected)
    (check-equal? (found (follow 1 (second 1) (first 1))) expected)
    (check-equal? (found (follow -1 (first -1) (second -1))) (map - expected))
    (check-equal? (found (follow -1 (second -1) (first -1))) (map - expected))
    ;; of several that would end the motion the first on the way does
    (define ends (event (at -9/20 -1/20) #:terminal? #t))
    (define ended (follow -1 (first -1) ends))
    (check-equal? (found ended) '(-0.05))
    (check-= (exact (trajectory-end ended)) -1/20 1e-20))

  (test-case "what happened before an event lost its value is not lost"
    (define ((steady) (up t x)) (up 1 1))
    (define fading (event (lambda (s) (- (sqrt (- 3/5 (coordinate s))) 1/2)) #:name 'fading))
    (define passing (event (lambda (s) (- (coordinate s) 3/10)) #:name 'passing))
    (define later (event (lambda (s) (- (coordinate s) 9/10)) #:name 'later))
    (define failed
      (with-handlers ([exn:fail:mechanics:singular? exn:fail:mechanics:singular-where])
        (evolve-trajectory (steady) (up 0 0) 1 #:precision 80
                           #:events (list later fading passing))))
    (check-equal? (map occurrence-event (trajectory-events failed)) (list passing fading))
    (check-true (< 3/5 (exact (trajectory-end failed)) 9/10)))

  (test-case "the period of a pendulum that swings to 1 rad"
    (define (pendulum s) (up 1 (velocity s) (* -98/10 (sin (coordinate s)))))
    (define tr
      (evolve-trajectory pendulum (up 0 1 0) 3 #:precision 150
                         #:events (event coordinate)))
    (define times (map occurrence-time (trajectory-events tr)))
    (check-true (< (abs (- (exact (- (cadr times) (car times))) #e1.0701143595090465)) 1e-15))
    (define period (* 2 (- (cadr times) (car times))))
    (define (mean a b n) (if (= n 0) a (mean (/ (+ a b) 2) (sqrt (* a b)) (- n 1))))
    (define exactly                     ; Gauss: 2π √(l/g) / M(1, cos(θ₀/2))
      (/ (* 2 (acos (bigfloat -1 200)) (sqrt (bigfloat 10/98 200)))
         (mean 1 (cos (bigfloat 1/2 200)) 9)))
    (check-true (< (abs (- (exact period) (exact exactly))) 1e-34)))

  (test-case "a parameter may set it for all"
    (parameterize ([ode-precision 100])
      (check-equal? (bigfloat-precision (coordinate (advance-harmonic (up 0 1 0) 1))) 100)
      (check-true (flonum? (coordinate (advance-harmonic (up 0 1 0) 1 #:precision #f))))))

  (test-case "numbers of higher precision enter a run in flonums rounded"
    (check-equal? (advance-harmonic (up 0 (bigfloat 1 100) 0) (bigfloat 1 100))
                  (advance-harmonic (up 0 1 0) 1)))

  (test-case "a singularity tells the time and the last state, and keeps the trajectory"
    (define (falling-in s) (up 1 (velocity s) (/ -1 (square (coordinate s)))))
    (define so-far
      (with-handlers ([exn:fail:mechanics:singular? exn:fail:mechanics:singular-where])
        (evolve-trajectory falling-in (up 0 1 0) 2 #:tolerance 1e-12 #:precision 64)))
    (define collision (/ (acos (bigfloat -1 64)) (* 2 (sqrt (bigfloat 2 64)))))
    (check-true (< (abs (- (trajectory-end so-far) collision)) 1e-8)))

  (test-case "an operation that only flonum code has is evaluated"
    (define ((turning) (up t x)) (up 1 (cos (* 1/3 ((principal-value :pi) x)))))
    (define advance (state-advancer turning))
    (check-= (bigfloat->exact (ref (advance (up 0 4) 1/2 1e-20 #:precision 100) 1))
             (ref (advance (up 0 4) 1/2 1e-14) 1)
             1e-13))

  (test-case "steps are no longer, and no more, than allowed"
    (define tr
      (evolve-trajectory (harmonic 1) (up 0 1 0) 2 #:precision 64 #:longest-step 0.05))
    (check-true (<= 40 (- (length (trajectory-states tr)) 1) 42))
    (check-exn #rx"^evolve-trajectory: the motion takes more steps than allowed\n  time: [.0-9]+\n"
               (lambda ()
                 (evolve-trajectory (harmonic 1) (up 0 1 0) 50 #:precision 64 #:most-steps 4))))

  (test-case "mistakes"
    (define (advance . more)
      (keyword-apply advance-harmonic '(#:precision) '(100) (list* (up 0 1 0) 1 more)))
    (check-exn
     #rx"state-advancer: the tolerance is below the rounding error of 100 bits, about 1e-30"
     (lambda () (advance (expt 2 -98))))
    (check-pred up? (advance (expt 2 -97)))
    (check-exn
     #rx"state-advancer: methods are for flonums; with a precision, extrapolation integrates"
     (lambda () (advance-harmonic (up 0 1 0) 1 #:precision 100 #:method 'qcrk4)))
    (check-exn #rx"expected a state of real numbers; the symbol x is none"
               (lambda () (advance-harmonic (up 0 'x 0) 1 #:precision 100)))
    (check-exn #rx"of another shape than the state"
               (lambda () ((state-advancer (lambda () (lambda (s) (up 1 2)))) (up 0 1 0) 1
                                                                             #:precision 100)))
    (check-exn #rx"^state-advancer: the function's value has changed its shape\n  before: "
               (lambda ()
                 (define (grows s) (if (< (time s) 1/2) (up 1 0) (up 1 0 0)))
                 ((state-advancer (lambda () grows)) (up 0 1) 1 #:precision 100)))
    (check-exn #rx"evolve: the first component of the state is not the time"
               (lambda () ((evolve (lambda () (lambda (s) (up 2 1)))) (up 0 1) void 1 2
                                                                     #:precision 100)))))

(test-case "a precision is a number of bits"
  (check-exn
   #rx"ode-precision: expected a number of bits from 54 on, or #f for flonums\n  given: the number 20"
   (lambda () (ode-precision 20)))
  (check-exn #rx"state-advancer: expected a number of bits"
             (lambda () ((state-advancer harmonic 1) (up 0 1 0) 1 #:precision 1e-20))))
