#lang racket/base
;; The Taylor method, compared with motions that are known exactly.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt")

(define (by-Taylor derivative start duration tolerance)
  ((state-advancer (lambda () derivative)) start duration tolerance #:method 'Taylor))

(define ((oscillator omega) (up t x v)) (up 1 v (* -1 (square omega) x)))

(test-case "an oscillator, forwards and backwards, at any scale of time"
  (for* ([omega '(1.0 1e-17 1e15)] [direction '(1 -1)])
    (define end (/ (* direction 10) omega))
    (define s (by-Taylor (oscillator omega) (up 0 1 0) end 1e-14))
    (check-= (ref s 0) end 0)
    (check-= (ref s 1) (cos 10) 2e-14)
    (when (= omega 1.0) (check-= (ref s 2) (* -1 direction (sin 10)) 2e-14))))

;; Kepler's ellipse with e = 0.6 from its pericentre, of period 2 pi: E - e sin E = t.
(define (Kepler (up t (up x y) (up vx vy)))
  (define r3 (expt (+ (square x) (square y)) 3/2))
  (up 1 (up vx vy) (up (/ (- x) r3) (/ (- y) r3))))
(define (Kepler-at t e)
  (define E (for/fold ([E t]) ([_ (in-range 50)])
              (- E (/ (- E (* e (sin E)) t) (- 1 (* e (cos E)))))))
  (up (- (cos E) e) (* (sqrt (- 1 (square e))) (sin E))))

(test-case "Kepler's motion"
  (define e 0.6)
  (define s0 (up 0 (up (- 1 e) 0) (up 0 (sqrt (/ (+ 1 e) (- 1 e))))))
  (for ([t '(1.0 3.0 20.0)])
    (define s (by-Taylor Kepler s0 t 1e-14))
    (define exact (Kepler-at t e))
    (check-= (ref s 1 0) (ref exact 0) 1e-13)
    (check-= (ref s 1 1) (ref exact 1) 1e-13)))

(test-case "a pendulum, by elliptic functions: the period of amplitude pi/2 and 3"
  (define (pendulum (up t theta v)) (up 1 v (- (sin theta))))
  (define (period amplitude)            ; by the arithmetic-geometric mean
    (for/fold ([a 1.0] [b (cos (/ amplitude 2))] #:result (/ (* 2 pi) a)) ([_ (in-range 8)])
      (values (/ (+ a b) 2) (sqrt (* a b)))))
  (for ([amplitude (list (/ pi 2) 3.0)])
    (define s (by-Taylor pendulum (up 0 amplitude 0) (period amplitude) 1e-14))
    (check-= (ref s 1) amplitude 1e-13)
    (check-= (ref s 2) 0 1e-13)))

(test-case "the driven pendulum"
  (define ((driven-pendulum) (up t theta v))
    (define omega (* 2 (sqrt 9.8)))
    (up 1 v (* (- (* 0.1 (square omega) (cos (* omega t))) 9.8) (sin theta))))
  (define s ((state-advancer driven-pendulum) (up 0 1 0) 10 1e-13 #:method 'Taylor))
  (check-= (ref s 1) 1.27379225442614696 1e-13)
  (check-= (ref s 2) -3.45379718978431025 1e-13))

(test-case "a rigid body, whose rates are solved for: a linear system in the program"
  (define L (T-rigid-body 1.0 (sqrt 2.0) 2.0))
  (define s (by-Taylor (Lagrangian->state-derivative L) (up 0 (up 1 0 0) (up .1 .1 .1)) 100 1e-13))
  (check-= (ref s 1 0) .6319896958326486 1e-12)
  (check-= (ref s 1 1) 1.361027154088125 1e-12)
  (check-= (ref s 1 2) 17.43790048473838 1e-11))

(test-case "growth from nothing is not trusted: x' = t^40"
  (define s (by-Taylor (lambda (s) (up 1 (expt (ref s 0) 40))) (up 0 0) 1.1 1e-12))
  (check-= (ref s 1) (/ (expt 1.1 41) 41) 1e-11))

(test-case "polynomial motions take one step"
  (define tr (evolve-trajectory (lambda (s) (up 1 (ref s 2) -9.8)) (up 0 0 20) 1000
                                #:method 'Taylor))
  (check-equal? (length (trajectory-states tr)) 2)
  (check-= (ref (tr 500) 1) (- (* 20 500) (* 4.9 500 500)) 1e-8))

(test-case "states within a step are as good as those at its ends, and stay so"
  (define s0 (up 0 1 0))
  (define tr (evolve-trajectory (oscillator 1.0) s0 30 #:tolerance 1e-13 #:method 'Taylor))
  (for ([t (in-range 0 30 0.37)])
    (check-= (ref (tr t) 1) (cos t) 1e-13)
    (check-= (ref (tr t) 2) (- (sin t)) 1e-13))
  (define seen '())
  ((evolve (lambda () (oscillator 1.0))) s0 (lambda (s) (set! seen (cons s seen))) 0.25 30 1e-13
                                         #:method 'Taylor)
  (check-equal? (length seen) 121)
  (for ([s seen]) (check-= (ref s 1) (cos (ref s 0)) 1e-13)))

(test-case "parameters, and a constraint with projection"
  (define ((damped k c) (up t x v)) (up 1 v (- (* -1 k x) (* c v))))
  (define s ((state-advancer damped 4.0 0.0) (up 0 1 0) 5 1e-13 #:method 'Taylor))
  (check-= (ref s 1) (cos 10) 1e-12))

(test-case "what has no recurrence is said, where the method is asked for by its name"
  (define (bouncing (up t x v)) (up 1 v (if (> x 0) -1.0 1.0)))
  (define (rough (up t x v)) (up 1 v (- (abs x))))
  (define (root (up t x)) (up 1 (sqrt x)))
  (define (run f s method)
    (trajectory-final-state (evolve-trajectory f s 0.5 #:method method)))
  (for ([f (list bouncing rough root)]
        [s (list (up 0 1 0) (up 0 1 0) (up 0 0.0))]
        [reason '("it takes a decision by `>`" "the operation `abs` has no Taylor recurrence"
                  "its coefficients are not finite at the start")])
    (check-message
     (string-append "evolve-trajectory: the Taylor method cannot follow this motion\n  reason: "
                    reason "\n  use 'auto, which takes another method then")
     (run f s 'Taylor))
    (check-equal? (run f s 'auto) (run f s 'Dormand-Prince-853))))

(test-case "a singularity of the motion is located: x' = x², a fall onto a centre, x' = -1/x"
  (define (check-singular f s0 t)
    (define e
      (with-handlers ([exn:fail:mechanics:singular? values])
        (evolve-trajectory f s0 2 #:method 'Taylor)))
    (check-regexp-match #rx"the motion is singular there" (exn-message e))
    (define so-far (exn:fail:mechanics:singular-where e))
    (check-= (trajectory-end so-far) t 1e-10))
  (check-singular (lambda (s) (up 1 (square (ref s 1)))) (up 0 1) 1)
  (check-singular (lambda (s) (up 1 (ref s 2) (/ -1 (square (ref s 1))))) (up 0 1 0)
                  (/ pi (sqrt 8)))
  (check-singular (lambda (s) (up 1 (/ -1 (ref s 1)))) (up 0 1.0) 1/2))

(test-case "which method it was, and many operations by Dormand and Prince's"
  (define (method-of f s #:method [m 'auto])
    (trajectory-method (evolve-trajectory f s 0.1 #:method m)))
  (check-eq? (method-of (oscillator 1.0) (up 0 1 0)) 'Taylor)
  (check-eq? (method-of (lambda (s) (up 1 (abs (ref s 1)))) (up 0 1)) 'Dormand-Prince-853)
  (check-eq? (method-of (oscillator 1.0) (up 0 1 0) #:method 'qcrk4) 'qcrk4)
  (check-equal? (format "~a" (method-of (oscillator 1.0) (up 0 1 0) #:method (leapfrog 0.1)))
                "(leapfrog 0.1)")
  (define (long s)
    (up 1 (for/fold ([sum 0]) ([k (in-range 1 150)]) (+ sum (/ (sin (* k (ref s 1))) k)))))
  (check-eq? (method-of long (up 0 1)) 'Dormand-Prince-853)
  (check-eq? (method-of long (up 0 1) #:method 'Taylor) 'Taylor))

(test-case "auto takes the faster of two: long rates are followed by Dormand and Prince"
  (define rigid (Lagrangian->state-derivative (T-rigid-body 1.0 (sqrt 2.0) 2.0)))
  (define tumbling (up 0 (up 1 0 0) (up .1 .1 .1)))
  (define (taken f start tolerance)
    (trajectory-method (evolve-trajectory f start 1 #:tolerance tolerance)))
  (for ([tolerance '(1e-6 1e-10)])
    (check-eq? (taken rigid tumbling tolerance) 'Dormand-Prince-853))
  (check-eq? (taken rigid tumbling 1e-15) 'Taylor)
  (for ([tolerance '(1e-6 1e-10 1e-13)])
    (check-eq? (taken (oscillator 1.0) (up 0 1 0) tolerance) 'Taylor)
    ;; a series that ends, and a motion that rests
    (check-eq? (taken (lambda (s) (up 1 (ref s 2) -9.8)) (up 0 1 0) tolerance) 'Taylor)
    (check-eq? (taken (oscillator 1.0) (up 0 0 0) tolerance) 'Taylor)))

;; Where a motion begins at rest, odd coefficients of the angle are nothing, and so may be the
;; eighth: the step of the other method is not as long as that promises.
(test-case "at rest, too, auto takes the faster of two"
  (define (pull t) (- (* 3.92 (cos (* 6.26 t))) 9.8))
  (define (hanging (up t angle v)) (up 1 v (* (pull t) (sin angle))))
  (define (upright (up t angle v)) (up 1 v (* -1 (pull t) (sin angle))))
  (for* ([f (list hanging upright)] [angle (in-range 0.5 1.5 0.1)])
    (check-eq? (trajectory-method (evolve-trajectory f (up 0 angle 0) 1 #:tolerance 1e-9))
               'Taylor)))

(test-case "an advancer that is used again gives what a new one gives"
  (define again (state-advancer (lambda () (oscillator 1.0))))
  (define (new) (state-advancer (lambda () (oscillator 1.0))))
  (again (up 0 1e-5 3e7) 20 1e-12)
  (for ([s (list (up 0 1 0) (up 5 1e-200 0) (up 0 1e200 3) (up 0 0 0) (up 0 1 0))]
        [tolerance '(1e-12 1e-12 1e-9 1e-12 1e-15)])
    (check-equal? (again s 7 tolerance) ((new) s 7 tolerance))))
