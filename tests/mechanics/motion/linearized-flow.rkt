#lang racket/base
;; Derivatives of motions by where they start and by parameters.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt")

(define ((oscillator omega) (up t x v)) (up 1 v (* -1 (square omega) x)))

;; x = x0 cos wt + (v0/w) sin wt
(define (x-at omega x0 v0 t) (+ (* x0 (cos (* omega t))) (* (/ v0 omega) (sin (* omega t)))))

(define (check-close a b tolerance)
  (define (scalars x)
    (if (structure? x) (apply append (map scalars (structure->list x))) (list x)))
  (check-equal? (length (scalars a)) (length (scalars b)))
  (for ([x (scalars a)] [y (scalars b)]) (check-= x y tolerance)))

(test-case "an oscillator, exactly: by the state, the parameter and the time"
  (define s (up 0.0 1.0 0.5))
  (define J ((linearized-flow oscillator 2.0) s 1.5 1e-13))
  (check-close J (down (up 1 0 0) (up 0 (cos 3) (* -2 (sin 3))) (up 0 (/ (sin 3) 2) (cos 3))) 1e-12)
  (check-close ((D (lambda (s) ((state-advancer oscillator 2.0) s 1.5 1e-13))) s) J 1e-12)
  (define by-omega
    ((D (lambda (omega) (ref ((state-advancer oscillator omega) s 1.5 1e-13) 1))) 2.0))
  (check-= by-omega ((D (lambda (omega) (x-at omega 1.0 0.5 1.5))) 2.0) 1e-11)
  (check-= (ref ((linearized-flow oscillator 2.0) s 1.5 1e-13 #:by-parameters? #t) 1 1)
           by-omega 1e-11)
  (check-= (ref ((D (lambda (t) ((state-advancer oscillator 2.0) s t 1e-13))) 1.5) 1)
           ((D (lambda (t) (x-at 2.0 1.0 0.5 t))) 1.5) 1e-12))

(test-case "second derivatives, mixed and by one parameter"
  (define (x omega x0) (ref ((state-advancer oscillator omega) (up 0.0 x0 0.5) 1.5 1e-13) 1))
  (check-= (((expt D 2) (lambda (omega) (x omega 1.0))) 2.0)
           (((expt D 2) (lambda (omega) (x-at omega 1.0 0.5 1.5))) 2.0) 1e-10)
  (check-= ((D (lambda (x0) ((D (lambda (omega) (x omega x0))) 2.0))) 1.0)
           ((D (lambda (x0) ((D (lambda (omega) (x-at omega x0 0.5 1.5))) 2.0))) 1.0) 1e-11))

(test-case "gradients, in reverse, by state and parameters"
  (define s (up 0.0 1.0 0.5))
  (define (x s) (ref ((state-advancer oscillator 2.0) s 1.5 1e-13) 1))
  (check-close ((gradient x) s) ((D x) s) 1e-11)
  (define (by-all s omega) (ref ((state-advancer oscillator omega) s 1.5 1e-13) 1))
  (check-close ((gradient by-all) s 2.0) ((D by-all) s 2.0) 1e-11)
  ;; beside a parameter that does not vary: x = cos ωt of the frequency ω = √(k/m)
  (define ((spring k m) s) (up 1 (ref s 2) (/ (* -1 k (ref s 1)) m)))
  (define (by-k k) (ref ((state-advancer spring k 2.0) (up 0.0 1.0 0.0) 1.5 1e-13) 1))
  (check-close ((gradient by-k) 8.0) (* -1.5 (sin 3.0) 1/8) 1e-11))

;; Kepler's motion with a parameter, by differences in 200 bits.
(define ((Kepler mu) (up t (up x y) (up vx vy)))
  (define r3 (expt (+ (square x) (square y)) 3/2))
  (up 1 (up vx vy) (up (/ (* -1 mu x) r3) (/ (* -1 mu y) r3))))

(test-case "Kepler's motion, compared with differences in 200 bits"
  (define (end x mu)
    ((state-advancer Kepler mu) (up 0 (up x 0) (up 0 1)) 3 1e-40 #:precision 200))
  (define h (expt 10 -12))
  (define (difference after before)
    (map (lambda (k) (/ (- (ref after 1 k) (ref before 1 k)) (* 2 h))) '(0 1)))
  (define by-x (difference (end (+ 4/5 h) 1) (end (- 4/5 h) 1)))
  (define by-mu (difference (end 4/5 (+ 1 h)) (end 4/5 (- 1 h))))
  (define J
    ((linearized-flow Kepler 1.0) (up 0.0 (up 0.8 0.0) (up 0.0 1.0)) 3.0 1e-14
                                  #:by-parameters? #t))
  (for ([k '(0 1)])
    (check-true (< (abs (- (ref J 0 1 0 1 k) (list-ref by-x k))) 1e-11))
    (check-true (< (abs (- (ref J 1 1 k) (list-ref by-mu k))) 1e-11))))

(test-case "in numbers of higher precision"
  (define d ((D (lambda (omega) ((state-advancer oscillator omega) (up 0 1 0) 1 1e-40
                                                                   #:precision 160)))
             2))
  (check-true (< (abs (+ (ref d 1) (sin (bigfloat 2 160)))) 1e-38)))

(test-case "volume in phase space is kept, and a section of a motion that is chaotic too"
  (define ((pendulum) (up t theta v)) (up 1 v (- (sin theta))))
  (define J ((linearized-flow pendulum) (up 0.0 2.0 0.3) 20.0 1e-13))
  (check-= (- (* (ref J 1 1) (ref J 2 2)) (* (ref J 1 2) (ref J 2 1))) 1 1e-10))

(test-case "by any method, with a rate that is not traced, with masses in a tuple"
  (define ((pushed ms) (up t x v))
    (up 1 v (if (> v -100) (/ (* -1 (ref ms 0) x) (ref ms 1)) 0)))
  (for ([method '(auto Dormand-Prince-853)])
    (define J
      ((linearized-flow pushed (up 4.0 1.0)) (up 0.0 1.0 0.0) 1.0 1e-12
                                             #:by-parameters? #t #:method method))
    (check-= (ref J 0 1 1) (cos 2) 1e-10)
    ;; x = cos √(k/m) t
    (check-= (ref J 1 0 1) (* -1/4 (sin 2)) 1e-10)
    (check-= (ref J 1 1 1) (sin 2) 1e-10)))

(test-case "mistakes"
  (check-message (string-append "(linearized-flow oscillator 2.0): takes a state, a duration and "
                                "perhaps a tolerance\n  given: the number 1")
                 ((linearized-flow oscillator 2.0) 1) exn:fail:contract:arity?))

;; A unit force towards 0 from both sides: from x at rest it takes √(2x) to 0, so that later
;; x(t) = (t - √(2x))²/2 - √(2x) (t - √(2x)).
(test-case "beyond a jump of the forces displacements jump, as the manual says"
  (define (to-0 s) (up 1 (ref s 2) (if (< (ref s 1) 0) 1 -1)))
  (define flow (linearized-flow (lambda () to-0)))
  (define start (up 0.0 1.0 0.0))
  (define there
    (trajectory-final-state
     (evolve-trajectory to-0 start 3 #:events (event coordinate #:terminal? #t))))
  (define arriving (* (flow start (ref there 0)) (up 0 1 0)))
  (define beyond (+ arriving (* (up 0 0 2) (/ (ref arriving 1) (ref there 2)))))
  (define end (* (flow there (- 3 (ref there 0))) beyond))
  (define (x-at x) (let ([s (- 3 (sqrt (* 2 x)))]) (- (* 1/2 s s) (* s (sqrt (* 2 x))))))
  (check-= (x-at 1.0) (ref ((state-advancer (lambda () to-0)) start 3) 1) 1e-8)
  (check-= (ref end 1) ((D x-at) 1.0) 1e-8)
  (check-= (ref end 2) (- (sqrt 2.0)) 1e-8))
