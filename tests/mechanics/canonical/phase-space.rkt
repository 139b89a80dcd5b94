#lang racket/base
;; Extended phase space, integral invariants, and how far resonances reach.

(require mechanics
         mechanics/book
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/session.rkt")

(define line (up 't 'q 'p))
(define extended (up 's (up 't 'q) (down 'p_t 'p)))

(define ((driven-pendulum alpha beta gamma omega) (up t theta p))
  (+ (/ (square p) (* 2 alpha)) (* -1 beta (cos theta))
     (* 2 gamma (cos theta) (cos (* omega t)))))

;; ---------------------------------------------------------------------------
;; Extended phase space

(test-case "the time as a coordinate: the same motion, with an energy that is conserved"
  (define H (driven-pendulum 'alpha 'beta 'gamma 'omega))
  (define He (extended-Hamiltonian H))
  (define slope ((Hamiltonian->state-derivative He) extended))
  (define inner ((Hamiltonian->state-derivative H) line))
  (check-identity (ref slope 1 0) 1)
  (check-identity (ref slope 1 1) (ref inner 1))
  (check-identity (ref slope 2 1) (ref inner 2))
  (check-identity (ref slope 2 0) (- (((partial 0) H) line)))
  (check-pred proved? (verify-conserved He He extended))
  (check-identity (reduced-state extended) line)
  (check-identity (extended-state line 'p_t) (up 't (up 't 'q) (down 'p_t 'p)))
  (check-identity (He (extended-state line H)) 0))

(test-case "a periodic Hamiltonian has an angle for its time"
  (define H (driven-pendulum 'alpha 'beta 'gamma 'omega))
  (define state (up 's (up 'phi 'theta) (down 'P 'p)))
  (check-identity ((periodic-extension H 'omega) state)
                  (+ (* 'omega 'P) (/ (square 'p) (* 2 'alpha)) (* -1 'beta (cos 'theta))
                     (* 2 'gamma (cos 'theta) (cos 'phi)))))

;; ---------------------------------------------------------------------------
;; Integral invariants

(define (loop x) (up 0 (+ 0.5 (* 0.2 (cos x))) (+ 1.0 (* 0.3 (sin x)))))

(test-case "∮ p dq of an ellipse is its area, with the sign of its sense"
  (check-close (loop-integral loop 0 (* 2 pi)) (* -1 pi 0.2 0.3) 1e-9)
  (check-identity ((loop-integrand (lambda (x) (up 0 (cos x) (sin x)))) 'x)
                  (* -1 (square (sin 'x)))))

(test-case "canonical transformations and motions keep it"
  (define area (loop-integral loop 0 (* 2 pi)))
  (check-close (loop-integral (compose (polar-canonical 2.0) loop) 0 (* 2 pi)) area 1e-8)
  (define (H s) (- (/ (square (momentum s)) 2) (* 9.8 (cos (coordinate s)))))
  (define (later s) ((state-advancer Hamiltonian->state-derivative H) s 0.5 1e-12))
  (check-close (loop-integral (compose later loop) 0 (* 2 pi) #:tolerance 1e-8) area 1e-6)
  (define (not-canonical s) (up (time s) (* 2 (coordinate s)) (momentum s)))
  (check-close (loop-integral (compose not-canonical loop) 0 (* 2 pi)) (* 2 area) 1e-8))

;; Poincaré and Cartan: points of the loop may be moved on by different times.
(test-case "with the energy the loop may be slanted in time"
  (define H (H-harmonic 1.0 1.0))
  (define (moved x)
    (define s (loop x))
    (define dt (+ 1.0 (* 0.3 (sin x))))
    (up dt
        (+ (* (coordinate s) (cos dt)) (* (momentum s) (sin dt)))
        (- (* (momentum s) (cos dt)) (* (coordinate s) (sin dt)))))
  (check-close (loop-integral moved 0 (* 2 pi) #:Hamiltonian H)
               (loop-integral loop 0 (* 2 pi)) 1e-9))

;; ---------------------------------------------------------------------------
;; Resonances

(define (H0 (up t q (down P p))) (+ (/ (square p) (* 2 'alpha)) (* 'omega P)))
(define (V (up t (up phi theta) p))
  (+ (* -1 'beta (cos theta))
     (* 'gamma (+ (cos (+ theta phi)) (cos (- theta phi))))))

;; 7.4: the pendulum's own resonance at p = 0 is 2 √(αβ) high, the drive's at ±αω 2 √(αγ).
(test-case "the resonances of the driven pendulum"
  (define (at p) (up 0 (up 'a 'b) (down 'P p)))
  (check-identity (resonance-center H0 '(0 1) (at 'p) 1) 0)
  (check-identity (resonance-center H0 '(1 -1) (at 'p) 1) (* 'alpha 'omega))
  (check-identity (resonance-center H0 '(1 1) (at 'p) 1) (* -1 'alpha 'omega))
  (define (number k) (ref (resonance-width H0 V k (at 0)) 1))
  (check-close (expression (simplify (substitute (number '(0 1)) 'alpha 1.0 'beta 9.0)))
               6.0 1e-12)
  (check-close (expression (simplify (substitute (number '(1 -1)) 'alpha 1.0 'gamma 4.0)))
               4.0 1e-12))

;; Independent: orbits of the section that start within the width stay about the resonance.
(test-case "the width, seen in the motion"
  (define H (driven-pendulum 1.0 0.05 0.05 5.0))
  (define (drift p)
    (define end ((state-advancer Hamiltonian->state-derivative H) (up 0 pi p) 60.0 1e-10))
    (- (coordinate end) pi (* 5.0 60.0)))
  ;; the drive turns at ω: within 2 √γ = 0.447 of p = 5 the pendulum turns with it
  (check-true (< (abs (drift 5.1)) 4))
  (check-true (< (abs (drift 4.8)) 4))
  (check-true (> (abs (drift 5.8)) 20)))

(says
 [((extended-Hamiltonian (H-harmonic 1 1)) line)
  "extended-Hamiltonian: expected a state of the extended phase space, (up s (up t q) (down p_t p))"
  "\n  given: (up t q p), an up tuple of 3"]
 [(loop-integral 3 0 1)
  "loop-integral: expected a loop, a function of one parameter with states as values; given the "
  "number 3"]
 [(resonance-width H0 V '(1 2) (up 0 (up 'a 'b) (down 'P 0)))
  "resonance-width: the perturbation has no wave (1 2); it has ((0 1) (1 -1) (1 1))"]
 [(resonance-width H0 V '(1) (up 0 (up 'a 'b) (down 'P 0)))
  "resonance-width: expected the integers of a wave, a list of 2; given (1), a list"])

;; ---------------------------------------------------------------------------
;; Powers of a Lie derivative, kept from one state to the next

(test-case "what was found under assumptions is not taken where they do not hold"
  (define (F s) (* (sqrt (square 'aa)) (coordinate s)))
  (define (H s) (* 1/2 (square (momentum s))))
  (define LF ((Lie-derivative H) F))
  (define assumed (assuming ('(> aa 0)) (LF line)))
  (check-identity assumed (* 'aa 'p))
  (check-equal? (substitute (LF line) 'aa -2 'p 3) 6)
  (check-equal? (substitute (assuming ('(< aa 0)) (LF line)) 'aa -2 'p 3) 6))

(define (free-motion state) (* 1/2 (square (momentum state))))

(says
 [((Lie-transform free-motion 'dt) line)
  "Lie-transform: it takes a function of the state, and what it gives the state: "
  "((operator F) state); given (up t q p), an up tuple of 3"]
 [((Lie-transform free-motion 'dt) coordinate line)
  "Lie-transform: it takes a function of the state, and what it gives the state: "
  "((operator F) state); given 2 arguments"]
 [((Lie-derivative free-motion) coordinate line)
  "Lie-derivative: it takes a function of the state, and what it gives the state: "
  "((operator F) state); given 2 arguments"])

(test-case "tuples of functions move together"
  (check-identity (series:sum (((Lie-transform free-motion 'dt) (up coordinate momentum)) line) 1)
                  (up (+ 'q (* 'dt 'p)) 'p)))
