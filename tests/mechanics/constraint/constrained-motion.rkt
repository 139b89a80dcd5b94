#lang racket/base
;; Constrained motions in numbers: drift, energy, redundancy, leaving a support.

(require mechanics
         "../support/checks.rkt" "../support/bigfloats.rkt" "../support/skip.rkt")

(define ((L-mass m g) (up t (up x y) (up vx vy)))
  (- (* 1/2 m (+ (square vx) (square vy))) (* m g y)))
(define ((rod-of-length l) t q) (- (sqrt (square q)) l))
(define (pendulum m l g)
  (constrained-state-derivative (L-mass m g) (holonomic (rod-of-length l))))
(define start (up 0 (up (sin 1) (- (cos 1))) (up 0 0)))
(define period 2.140228719018093)                    ; from 1 rad, l = 1, g = 9.8

;; The greatest |f| along a trajectory, at its steps and between.
(define (greatest f tr #:samples [n 2000])
  (for/fold ([most 0]) ([k (in-range (+ n 1))])
    (max most (abs (f (tr (* (/ k n) (trajectory-end tr))))))))

(define (length-error s) ((rod-of-length 1) 0 (coordinate s)))
(define (rate-of-length s) (dot-product (coordinate s) (velocity s)))

(test-case "100 swings: the rod keeps its length, and the energy stays"
  (define tolerance 1e-10)
  (define energy (Lagrangian->energy (L-mass 1 9.8)))
  (define (run method)
    (evolve-trajectory (pendulum 1 1 9.8) start (* 100 period)
                       #:tolerance tolerance #:method method))
  (for ([method '(Taylor Dormand-Prince-853 bulirsch-stoer)])
    (define tr (run method))
    (check-true (< (greatest length-error tr) (* 1e-4 tolerance)))
    (check-true (< (greatest rate-of-length tr) (* 1e-4 tolerance)))
    (check-true (< (greatest (lambda (s) (- (energy s) (energy start))) tr) (* 500 tolerance)))
    (check-true (< (abs (- (ref (coordinate (trajectory-final-state tr)) 0) (sin 1)))
                   (* 50 tolerance)))))

(test-case "without projection it drifts"
  (define slope (pendulum 1 1 9.8))
  (define tr (evolve-trajectory (lambda (s) (slope s)) start (* 100 period) #:tolerance 1e-10
                                #:method 'Dormand-Prince-853))
  (check-true (> (greatest length-error tr) 1e-9)))

(test-case "the motion is that of the angle"
  (define tr (evolve-trajectory (pendulum 2 1 9.8) start 5 #:tolerance 1e-12))
  (define angle
    (evolve-trajectory (lambda (s) (up 1 (velocity s) (* -9.8 (sin (coordinate s)))))
                       (up 0 1 0) 5 #:tolerance 1e-12))
  (for ([k 51])
    (define θ (coordinate (angle (/ k 10))))
    (check-= (ref (coordinate (tr (/ k 10))) 0) (sin θ) 1e-11)
    (check-= (ref (coordinate (tr (/ k 10))) 1) (- (cos θ)) 1e-11)))

(test-case "every way to integrate projects, and takes parameters"
  (define last (evolve-trajectory (pendulum 1 1 9.8) start 3 #:tolerance 1e-12))
  (define (agrees s) (check-true (< (abs (- (ref (coordinate s) 0)
                                            (ref (coordinate (trajectory-final-state last)) 0)))
                                    1e-8)
                                 (format "~a" s))
    (check-true (< (abs (length-error s)) 1e-14)))
  (agrees ((evolve pendulum 1 1 9.8) start
           (lambda (s) (check-true (< (abs (length-error s)) 1e-14)))
                                     0.1 3 1e-11))
  (agrees ((state-advancer pendulum 1 1 9.8) start 3 1e-11))
  (for ([method (list 'Dormand-Prince-54 'qcrk4 'Radau-IIA-5 (Gauss-Legendre-6 0.01))])
    (agrees ((state-advancer pendulum 1 1 9.8) start 3 1e-9 #:method method)))
  ;; back from far away, too
  (define rough ((state-advancer pendulum 1 1 9.8) start 3 1e-9 #:method (Gauss-Legendre-2 0.2)))
  (check-true (< (abs (length-error rough)) 1e-14))
  (agrees ((advance-beyond pendulum 1 1 9.8) start 0.01 1e-11 3
                                             (lambda (s taken next)
                                               ((state-advancer pendulum 1 1 9.8)
                                                s
                                                (- 3 (time s)))))))

(test-case "a state that does not keep the constraints is refused, and one beside it found"
  (define (refused state)
    (with-handlers ([exn:fail:contract? exn-message])
      (evolve-trajectory (pendulum 1 1 9.8) state 1)
      "not refused"))
  (check-regexp-match
   #rx"^evolve-trajectory: the state does not keep the constraints\n  values of the constraints: 4[.]0\n  their rates of change: 1[.]6\n"
   (refused (up 0 (up 3 4) (up 0 2))))
  (check-regexp-match #rx"their rates of change: 1[.]0\n" (refused (up 0 (up 1 0) (up 1 0))))
  (check-regexp-match
   #rx"[(][(]consistent-state L constraints[)] state[)] is one beside it that does"
   (refused (up 0 (up 1 0) (up 1 0))))
  (define found
    ((consistent-state (L-mass 1 9.8) (holonomic (rod-of-length 1))) (up 0 (up 3 4) (up 0 2))))
  (check-true (< (abs (length-error found)) 1e-15))
  (check-true (< (abs (rate-of-length found)) 1e-15))
  (check-= (ref (coordinate found) 0) 0.6 1e-15)
  ;; also after the first motion of an advancer
  (define advance (state-advancer pendulum 1 1 9.8))
  (advance start 1)
  (check-exn #rx"^state-advancer: the state does not keep"
             (lambda () (advance (up 0 (up 3 4) (up 0 0)) 1))))

(test-case "symbols that are left, and constraints that nothing keeps"
  (check-exn #rx"^evolve-trajectory: the symbol m is left in the state derivative"
             (lambda () (evolve-trajectory (pendulum 'm 'l 9.8) start 1)))
  (check-exn #rx"^consistent-state: expected a state of real numbers; it holds the symbol t"
             (lambda ()
               ((consistent-state (L-mass 1 9.8) (holonomic (rod-of-length 1)))
                (up 't (up 0 1) (up 0 0)))))
  (check-exn exn:fail:mechanics:not-convergent?
             (lambda ()
               ((consistent-state (L-mass 1 9.8) (holonomic (lambda (t q) (+ 1 (square q)))))
                (up 0 (up 1 0) (up 0 0))))))

(test-case "where no state keeps a constraint, the last one tried is told, and how far it is off"
  (define (L (up t x v)) (* 1/2 (square v)))
  (define nowhere (holonomic (lambda (t x) (+ (square x) 1))))
  (for ([x '(0.7 2.0 -3.5)])
    (define failure
      (with-handlers ([exn:fail:mechanics:not-convergent? values])
        ((consistent-state L nowhere) (up 0 x 0))))
    (check-pred exn:fail:mechanics:not-convergent? failure)
    (check-regexp-match #rx"^consistent-state: no state was found that keeps the constraints\n"
                        (exn-message failure))
    (check-true (> (exn:fail:mechanics:not-convergent-error-estimate failure) 1e-12))))

(skip-unless bigfloats? no-bigfloats
  (test-case "in thirty digits the rod keeps its length as well as the motion is known"
    (define advance (state-advancer pendulum 1 1 98/10))
    (define last (advance (up 0 (up 3/5 -4/5) (up 0 0)) 1 1e-22 #:precision 100))
    (check-true (< (abs (bigfloat->exact (- (square (coordinate last)) 1))) 1e-20))
    (check-exn #rx"^state-advancer: the state does not keep"
               (lambda () (advance (up 0 (up 3 4) (up 0 0)) 1 #:precision 100)))
    (check-exn #rx"^state-advancer: .*the symbol x"
               (lambda () (advance (up 0 (up 'x 4) (up 0 0)) 1 #:precision 100)))))

(test-case "redundant constraints do not hinder a motion"
  (define (twice t q) (* 3 ((rod-of-length 1) t q)))
  (define redundant
    (constrained-state-derivative (L-mass 1 9.8)
                                  (list (holonomic (rod-of-length 1)) (holonomic twice))))
  (define tr (evolve-trajectory redundant start 10 #:tolerance 1e-11))
  (define single (evolve-trajectory (pendulum 1 1 9.8) start 10 #:tolerance 1e-11))
  (check-equal? (trajectory-final-state tr) (trajectory-final-state single))
  (check-exn #rx"constraint 1 demands the same as 3.0 times constraint 0"
             (lambda () (redundant start))))

(test-case "a state where constraints lose their hold is no beginning"
  (define cross (holonomic (lambda (t q) (* (ref q 0) (ref q 1)))))
  (check-exn
   #rx"constraints depend on each other that are independent elsewhere.*constraint 0 demands nothing here"
   (lambda ()
     (evolve-trajectory (constrained-state-derivative (L-mass 1 9.8) cross)
                        (up 0 (up 0 0) (up 0 0))
                        1))))

(test-case "four constraints on six coordinates: a double pendulum of two rods in a plane"
  (define (L (up t q v)) (- (* 1/2 (square v)) (* 9.8 (+ (ref q 1) (ref q 4)))))
  (define (rods t (up x1 y1 z1 x2 y2 z2))
    (up (- (+ (square x1) (square y1) (square z1)) 1)
        (- (+ (square (- x2 x1)) (square (- y2 y1)) (square (- z2 z1))) 1)
        z1
        z2))
  (define der (constrained-state-derivative L (holonomic rods)))
  (define tr
    (evolve-trajectory der (up 0 (up 1 0 0 1 -1 0) (up 0 0 0 0 0 0)) 5 #:tolerance 1e-10))
  (define energy (Lagrangian->energy L))
  (check-true (< (greatest (lambda (s) (- (energy s) (energy (tr 0)))) tr #:samples 100) 1e-7))
  (for ([j 4])
    (check-true (< (greatest (lambda (s) (ref (rods 0 (coordinate s)) j)) tr #:samples 100) 1e-13)))
  (define compiled (compile-function der (up 0 (up 1 0 0 1 -1 0) (up 0 0 0 0 0 0))))
  (check-false (compiled-function-reason compiled)))

(test-case "a nonholonomic constraint: a knife edge slides down and comes back"
  ;; Bloch, Krishnaprasad, Marsden and Murray 1996: with θ = ω t from rest the blade moves as
  ;; x = (g sin α/2ω²) sin² ωt, y = (g sin α/2ω²)(ωt − sin ωt cos ωt)
  (define (L (up t (up x y θ) (up vx vy ω)))
    (+ (* 1/2 (+ (square vx) (square vy))) (* 1/2 (square ω)) (* 3 x)))
  (define blade (nonholonomic (lambda (t q v) (- (* (ref v 0) (sin (ref q 2)))
                                                 (* (ref v 1) (cos (ref q 2)))))))
  (define tr
    (evolve-trajectory (constrained-state-derivative L blade) (up 0 (up 0 0 0) (up 0 0 1.5)) 20
                       #:tolerance 1e-11))
  (define k (/ 3 2 (square 1.5)))
  (for ([t '(1 5 20)])
    (define wt (* 1.5 t))
    (define q (coordinate (tr t)))
    (check-= (ref q 0) (* k (square (sin wt))) 1e-8)
    (check-= (ref q 1) (* k (- wt (* (sin wt) (cos wt)))) 1e-8)))

(test-case "a ball is left where cos θ = 2/3, found by the force of the constraint"
  (define ((L-top m g R) (up t (up r θ) (up vr vθ)))
    (+ (* 1/2 m (+ (square vr) (square (* r vθ)))) (* m g (- R (* r (cos θ))))))
  (define L (L-top 1 9.8 1))
  (define ball (holonomic (lambda (t q) (- (ref q 0) 1))))
  (define force (constraint-forces L ball))
  (define off
    (event (lambda (s) (ref (force s) 0)) #:name 'off #:direction 'falling #:terminal? #t))
  (define tr
    (evolve-trajectory (constrained-state-derivative L ball) (up 0 (up 1 1e-6) (up 0 0)) 100
                       #:tolerance 1e-12 #:events off))
  (check-= (cos (ref (coordinate (trajectory-final-state tr)) 1)) 2/3 1e-10))
