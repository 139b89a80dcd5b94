#lang racket/base
;; States followed in time: SICM 1.7 and its numbers.

(require mechanics
         (only-in mechanics/motion/observed-systems call-watching-systems)
         (only-in racket/list remove-duplicates)
         (only-in mechanics/book L-harmonic harmonic-state-derivative pend-state-derivative)
         "../support/bigfloats.rkt" "../support/checks.rkt" "../support/close.rkt"
         "../support/skip.rkt" "../support/systems.rkt")

;; ---------------------------------------------------------------------------
;; Systems

(define driven
  (list 1 1 9.8 0.1 (* 2 (sqrt 9.8))))

;; ---------------------------------------------------------------------------

;; m a = −k x − 2b v, with m = k = 1, by a dissipation function, a force, and both; of so many
;; coordinates that code is made of L, and where at one state nobody would miss the drag
(test-case "a damped oscillation decays, whichever way the drag is stated"
  (define (drag c) (* -1 ((partial 2) (Rayleigh-dissipation c))))
  (define L (L-harmonic 1 1))
  (define start (up 0.0 (up 1.0 0.0 0.0 0.0 0.0 0.0) (up 0.0 0.0 0.0 0.0 0.0 0.0)))
  (for* ([b '(0.1 1e-7)]
         [slope (list (Lagrangian->state-derivative L (Rayleigh-dissipation b))
                      (Lagrangian->state-derivative L #:force (drag b))
                      (Lagrangian->state-derivative L (Rayleigh-dissipation (/ b 2))
                                                    #:force (drag (/ b 2))))])
    (define w (sqrt (- 1 (* b b))))
    (define expected (* (exp (* -30 b)) (+ (cos (* 30 w)) (* (/ b w) (sin (* 30 w))))))
    (define end ((state-advancer (lambda () slope)) start 30.0 1e-13))
    (check-= (ref (coordinate end) 0) expected 1e-10)))

(test-case "the harmonic oscillator in two dimensions (p. 74)"
  (check-close ((state-advancer harmonic-state-derivative 2 1)
                (up 1 (up 1 2) (up 3 4)) 10 1e-12)
               '(11 3.7127916645844544 5.4206208236515673 1.6148030925459916 1.8189103724750986)
               1e-12))

(test-case "the driven pendulum (p. 76)"
  (define advance (apply state-advancer pend-state-derivative driven))
  (check-close (advance (up 0 1 0) 1 1e-13)
               '(1 -1.03011568739188687 -1.40985359335821735) 1e-12)
  (check-close (advance (up 0 1 0) 10 1e-13)
               '(10 1.27379225442614696 -3.45379718978431025) 1e-11))

(test-case "the double pendulum (exercise 1.44)"
  (define advance
    (state-advancer (lambda parameters
                      (Lagrangian->state-derivative (apply L-double-pendulum parameters)))
                    1 3 1 0.9 9.8))
  (define start (up 0 (up :pi/2 :pi) (up 0 0)))
  (check-close (advance start 1 1e-13)
               '(1 .0910630038849611 -1.66626245247204 -5.1832373624753 -4.02581660181084)
               1e-10)
  (check-close (advance start 5 1e-13)
               '(5 6.82360398985888 8.60368993913788 -3.01497306538466 3.79006470284155)
               1e-7))

(test-case "advancing and coming back"
  (define advance (state-advancer harmonic-state-derivative 2 1))
  (check-close (advance (advance (up 0 1 0) 5 1e-12) -5 1e-12) '(0 1 0) 1e-11))

(test-case "the monitor sees the states at the start, after each time step and at the end"
  (define times '())
  (define last
    ((apply evolve pend-state-derivative driven)
     (up 0 1 0) (lambda (s) (set! times (cons (time s) times))) 0.01 1 1e-13))
  (define seen (reverse times))
  (check-equal? (length seen) 101)
  (check-equal? (car seen) 0.0)
  (check-equal? (car times) 1.0)
  (check-equal? (time last) 1.0)
  (for ([t seen] [k (in-naturals)]) (check-= t (* k 0.01) 1e-14)))

(test-case "the end is met exactly where it is no multiple of the time step, and backwards"
  (define times '())
  (define (note s) (set! times (cons (time s) times)))
  ((evolve harmonic-state-derivative 1 1) (up 0 1 0) note 0.3 1)
  (check-equal? (map (lambda (t) (/ (round (* 10 t)) 10)) (reverse times)) '(0.0 0.3 0.6 0.9 1.0))
  (set! times '())
  ((evolve harmonic-state-derivative 1 1) (up 0 1 0) note 0.5 -1)
  (check-equal? (reverse times) '(0.0 -0.5 -1.0)))

(test-case "states between steps are as good as the others"
  (check-close
   ((evolve harmonic-state-derivative 1 1) (up 0 1 0)
    (lambda (s) (check-= (coordinate s) (cos (time s)) 1e-10))
    0.01 10 1e-12)
   (list 10 (cos 10) (- (sin 10))) 1e-10))

(test-case "a decision in the state derivative, by the state or a parameter, is followed"
  (define ((bouncing k) (up t x v)) (up 1 v (if (< x 0) (* -1 k x) -1)))
  (define ((damped mode) (up t x v)) (up 1 v (if (= mode 1) (- v) 0)))
  (check-close ((state-advancer damped 1) (up 0 0 1) 1 1e-12)
               (list 1 (- 1 (exp -1)) (exp -1)) 1e-11)
  (check-close ((state-advancer damped 2) (up 0 0 1) 1 1e-12) '(1 1 1) 1e-11)
  (define s ((state-advancer bouncing 1000) (up 0 0.5 0) 2 1e-10))
  (define energy (+ (* 1/2 (square (velocity s)))
                    (if (< (coordinate s) 0) (* 500 (square (coordinate s))) (coordinate s))))
  (check-= energy 0.5 1e-7))

(test-case "a parameter may be a function"
  (define ((falling g) (up t x v)) (up 1 v (- (g t))))
  (check-close ((state-advancer falling (lambda (t) (* 6 t))) (up 0 0 0) 1 1e-12) '(1 -1 -3) 1e-12))

(test-case "the state derivative itself may be given where there are no parameters"
  (check-close ((state-advancer (harmonic-state-derivative 1 1)) (up 0 1 0) 1 1e-12)
               (list 1 (cos 1) (- (sin 1))) 1e-12)
  (check-close ((state-advancer (lambda () (harmonic-state-derivative 1 1))) (up 0 1 0) 1 1e-12)
               (list 1 (cos 1) (- (sin 1))) 1e-12))

;; Without a decision it is 1.0 everywhere, with one only there.
(test-case "a rate of 1.0 is that of the time, but where rates are decided"
  (define (plain s) (up 1.0 (ref s 1)))
  (define (decided s) (up 1.0 (if (< (ref s 1) 0) 0 (ref s 1))))
  (define (after-1 f) (ref ((evolve (lambda () f)) (up 0 1) void 1/2 1) 1))
  (check-= (after-1 plain) (exp 1) 1e-9)
  (check-exn #rx"^evolve: the first component of the state is not the time"
             (lambda () (after-1 decided))))

(test-case "a state without time advances, but has no evolution"
  (define ((rotation ω) (up x y)) (up (* -1 ω y) (* ω x)))
  (check-close ((state-advancer rotation 2) (up 1 0) 1 1e-12) (list (cos 2) (sin 2)) 1e-12)
  (check-exn #rx"evolve: the first component of the state is not the time"
             (lambda () ((evolve rotation 2) (up 1 0) void 0.1 1))))

(test-case "twenty links: large mass matrices are solved with numbers"
  (define (angles n x) (apply up (for/list ([i n]) x)))
  (define (energy-change n)
    (define E (Lagrangian->energy (L-chain n 9.8)))
    (define start (up 0.0 (angles n 1.0) (angles n 0.0)))
    (define (slope) (Lagrangian->state-derivative (L-chain n 9.8)))
    (define end ((state-advancer slope) start 0.5 1e-10))
    (magnitude (- (E end) (E start))))
  (check-true (< (energy-change 4) 1e-8))
  (check-true (< (energy-change 8) 1e-8)))

(test-case "mistakes"
  (define advance (state-advancer harmonic-state-derivative 2 1))
  (check-exn #rx"expected a state of real numbers; the symbol x is none"
             (lambda () (advance (up 0 'x 0) 1)))
  (check-exn #rx"expected a duration that is a real number" (lambda () (advance (up 0 1 0) 'T)))
  (check-exn #rx"tolerance is below the rounding error" (lambda () (advance (up 0 1 0) 1 1e-20)))
  (check-exn #rx"expected a positive tolerance" (lambda () (advance (up 0 1 0) 1 0)))
  (check-exn #rx"expected a positive time step"
             (lambda () ((evolve harmonic-state-derivative 2 1) (up 0 1 0) void 0 1)))
  (check-exn #rx"expected a monitor"
             (lambda () ((evolve harmonic-state-derivative 2 1) (up 0 1 0) 3 0.1 1)))
  (check-exn #rx"of another shape than the state"
             (lambda () ((state-advancer (lambda () (lambda (s) (up 1 2)))) (up 0 1 0) 1)))
  (check-exn #rx"symbol m is left in the state derivative"
             (lambda ()
               ((state-advancer (lambda () (harmonic-state-derivative 1 'm))) (up 0 1 0) 1)))
  (check-exn #rx"evolve: expected a procedure that makes a state derivative\n  given: the number 3"
             (lambda () (evolve 3))))

(test-case "a singularity tells the time and the last state"
  (define ((falling-in) (up t x v)) (up 1 v (/ -1 (square x))))
  (check-exn #rx"cannot be followed any further.*time: 1\\.11"
             (lambda () ((state-advancer falling-in) (up 0 1 0) 2 1e-10)))
  (define where
    (with-handlers ([exn:fail:mechanics:singular? exn:fail:mechanics:singular-where])
      ((state-advancer falling-in) (up 0 1 0) 2 1e-10)))
  (check-= (time where) (/ :pi (* 2 (sqrt 2))) 1e-8)
  (check-true (< (magnitude (coordinate where)) 1e-4)))

(test-case "whoever watches is told what makes the system, of which parameters, and the state"
  (define ((spring k) s) (up 1 (velocity s) (* -1 k (coordinate s))))
  (define start (up 0 1 0))
  (define told '())
  (call-watching-systems
   (lambda all (set! told (cons all told)))
   (lambda ()
     ((evolve spring 4) start void 0.1 0.2)))
  (check-equal? (remove-duplicates told) (list (list spring '(4) start))))

(test-case "what goes on is told the longest step, with the sign of the duration"
  (define advance (state-advancer (lambda () (lambda (s) (up 1 (ref s 2) (- (ref s 1)))))))
  (define (told state taken longest) (list taken longest))
  (define (check-told duration told)
    (check-equal? (car told) duration)
    (check-true (<= 1/20 (/ (cadr told) duration) 1)))
  (for ([duration '(2 -2)])
    (check-told duration (advance (up 0 1 0) duration 1e-12 told))
    (skip-unless bigfloats? no-bigfloats
      (check-told duration (advance (up 0 1 0) duration 1e-12 told #:precision 64)))))
