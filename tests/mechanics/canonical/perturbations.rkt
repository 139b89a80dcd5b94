#lang racket/base
;; Perturbation theory as a procedure: what is removed, what stays, what is divided by.

(require mechanics
         (prefix-in found: mechanics/canonical/perturbation/perturbation-results)
         (only-in mechanics/canonical/perturbation/Poisson-series series-scale)
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/session.rkt")

(define line (up 't 'theta 'p))
(define two (up 't (up 'theta 'phi) (down 'p 'P)))

(define (rotor (up t theta p)) (/ (square p) (* 2 'alpha)))
(define (gravity (up t theta p)) (* -1 'beta (cos theta)))

(test-case "the pendulum to the fourth order, each order proved"
  (define P (perturbation-series rotor gravity line #:order 4))
  (check-pred perturbation? P)
  (check-pred proved? (verify-perturbation P))
  (define terms (series:head ((perturbation-Hamiltonian P) line) 5))
  (check-identity (list-ref terms 2)
                  (/ (* 'alpha (square 'beta) (square 'epsilon)) (* 4 (square 'p))))
  (check-identity (list-ref terms 3) 0)
  ;; of the energy of a fast rotor by its action: 5 α³ β⁴ / (64 p⁶) ε⁴
  (check-identity (list-ref terms 4)
                  (/ (* 5 (expt 'alpha 3) (expt 'beta 4) (expt 'epsilon 4)) (* 64 (expt 'p 6)))))

;; Independent numbers: the circulating pendulum's action and frequency by elliptic integrals.
(test-case "the frequency of a fast pendulum"
  (define P (perturbation-series (lambda (s) (/ (square (momentum s)) 2))
                                 (lambda (s) (* -1 (cos (coordinate s))))
                                 line #:order 4 #:parameter 0.3))
  (define (energy p) (series:sum ((perturbation-Hamiltonian P) (up 0 0 p)) 4))
  ;; E by the action J of the circulating pendulum with β = 0.3
  (define E 8.0)
  (define k (sqrt (/ (* 2 0.3) (+ E 0.3))))
  (define J (* (/ 4 pi) (sqrt 0.3) (/ (second-elliptic-integral k) k)))
  (check-close (energy J) E 1e-7)
  (define omega (/ (* pi (sqrt (/ (+ E 0.3) 2))) (first-elliptic-integral k)))
  (check-close ((D energy) J) omega 1e-6))

(test-case "the solution: into the new state, on, and back"
  (define (P n)
    (perturbation-series (lambda (s) (/ (square (momentum s)) 2))
                         (lambda (s) (* -1 (cos (coordinate s))))
                         line #:order n #:parameter 0.05))
  (define (H s) (- (/ (square (momentum s)) 2) (* 0.05 (cos (coordinate s)))))
  (define start (up 0 0.5 1.5))
  (define end ((state-advancer Hamiltonian->state-derivative H) start 10.0 1e-13))
  (define (miss n)
    (define reached (((perturbation-solution (P n)) start) 10.0))
    (abs (- (momentum reached) (momentum end))))
  (define misses (map miss '(1 2 3)))
  (check-true (apply > misses))
  (check-true (< (caddr misses) 1e-4))
  (check-close (((perturbation-solution (P 3)) start) 0) start 1e-5))

(test-case "new states and old ones: inverse of each other, and canonical, up to the order"
  (define P (perturbation-series rotor gravity line #:order 2))
  (define old ((perturbation-transformation P) line))
  (define excess
    (matrix-ref ((symplectic-transform? (perturbation-transformation P)) line) 0 1))
  (define back ((perturbation-inverse P) old))
  (define (at e x) (substitute (simplify x) 'epsilon e))
  (for ([e '(1/100 1/1000)])
    (define (size x) (abs (exact->inexact (expression (simplify
      (substitute (at e x) 'theta 1 'p 2 'alpha 1 'beta 1))))))
    (check-true (< (size excess) (* 10 (expt e 3))))
    (check-true (< (size (- (coordinate back) 'theta)) (* 10 (expt e 3))))
    (check-true (< (size (- (momentum back) 'p)) (* 10 (expt e 3))))))

;; ---------------------------------------------------------------------------
;; Each claim, order by order

(define (statuses P claim)
  (for/list ([v (in-list (perturbation-verdicts P))] #:when (eq? (car v) claim))
    (list (cadr v) (verdict-status (caddr v)))))

(test-case "each claim of the pendulum's perturbation is proved in each order"
  (define P (perturbation-series rotor gravity line #:order 2))
  (for ([claim '(transformed without-angles)])
    (check-equal? (statuses P claim) '((0 proved) (1 proved) (2 proved))))
  (for ([claim '(canonical inverse)])
    (check-equal? (statuses P claim) '((1 proved) (2 proved)))))

;; Another generator removes nothing; its transformation is canonical all the same.
(test-case "a generator of the wrong sign is found out, in the order that it is of"
  (define P (perturbation-series rotor gravity line #:order 2))
  (define wrong
    (found:perturbation (found:perturbation-state P) (found:perturbation-given P) 'epsilon
                        (found:perturbation-terms P)
                        (cons (series-scale -1 (car (found:perturbation-Ws P)))
                              (cdr (found:perturbation-Ws P)))
                        (found:perturbation-removals P) '()))
  (check-equal? (statuses wrong 'transformed) '((0 proved) (1 refuted) (2 refuted)))
  (check-equal? (statuses wrong 'canonical) '((1 proved) (2 proved)))
  (check-pred refuted? (verify-perturbation wrong)))

;; ---------------------------------------------------------------------------
;; Resonances

(define (driven-rotor (up t (up theta phi) (down p P)))
  (+ (/ (square p) (* 2 'alpha)) (* 'omega P)))
(define (drive (up t (up theta phi) (down p P)))
  (+ (* -1 'beta (cos theta))
     (* 'gamma (+ (cos (+ theta phi)) (cos (- theta phi))))))

(test-case "the driven pendulum (7.4): three resonances in the first order, by their integers"
  (define P (perturbation-series driven-rotor drive two))
  (check-equal? (sort (map cadr (perturbation-divisors P))
                      string<? #:key (lambda (k) (format "~a" k)))
                '((1 -1) (1 0) (1 1)))
  (check-equal? (perturbation-resonances P) '())
  (check-pred proved? (verify-perturbation P)))

(test-case "a resonance that is kept: the others are removed to the second order"
  (define P (perturbation-series driven-rotor drive two #:order 2 #:keep '((1 -1))))
  (check-equal? (map cadr (perturbation-resonances P)) '((1 -1)))
  (check-identity (caddr (car (perturbation-resonances P))) (* 'gamma (cos (- 'theta 'phi))))
  (check-false (member '(1 -1) (map cadr (perturbation-divisors P))))
  (check-pred proved? (verify-perturbation P)))

(test-case "a resonance that is kept leaves angles in its order, and is no mistake"
  (define P (perturbation-series driven-rotor drive two #:order 2 #:keep '((1 -1))))
  (check-equal? (statuses P 'transformed) '((0 proved) (1 proved) (2 proved)))
  (check-equal? (statuses P 'without-angles) '((0 proved) (1 refuted) (2 proved)))
  (check-equal? (statuses P 'inverse) '((1 proved) (2 proved))))

;; A wave of one of two angles, of which the coefficient is a momentum
(define (one-angle-each (up t (up theta phi) (down p P)))
  (+ (* 'a (sin theta)) (* 'b p (sin phi))))

(test-case "sines of one of two angles, the one removed, the other kept"
  (define P
    (perturbation-series driven-rotor one-angle-each two #:order 2 #:keep '((0 1)) #:parameter 1))
  (check-pred proved? (verify-perturbation P))
  (check-equal? (map (lambda (r) (list (car r) (cadr r))) (perturbation-resonances P))
                '((1 (0 1))))
  (check-identity (caddr (car (perturbation-resonances P))) (* 'b 'p (sin 'phi)))
  (check-identity (series:ref ((perturbation-Hamiltonian P) two) 2)
                  (/ (* 'alpha (square 'a)) (* 4 (square 'p))))
  (check-true (regexp-match? #rx"^perturbation to order 2\n" (format "~a" P))))

;; Near p the rotor p³/6 is a pendulum with A = p.
(test-case "the width of a resonance where the energy is no square of the momentum"
  (define (cubic s) (/ (expt (momentum s) 3) 6))
  (define (wave s) (* 8 (cos (coordinate s))))
  (check-equal? (resonance-width cubic wave '(1) (up 0 0 2)) 4))

(test-case "what no choice of momenta removes is kept, and named"
  (define (oscillators (up t q (down I J))) (+ (* 2 I) J))
  (define (coupling (up t (up a b) (down I J))) (* I (sqrt J) (cos (- a (* 2 b)))))
  (define P (perturbation-series oscillators coupling two #:order 2))
  (check-equal? (map (lambda (r) (list (car r) (cadr r))) (perturbation-resonances P))
                '((1 (1 -2)))))

;; Frequencies that are decimals are told from resonances up to rounding.
(define ((free first second) (up t q (down I J))) (+ (* first I) (* second J)))
(define (exchange (up t (up a b) p)) (cos (- a b)))

(test-case "a resonance of decimals is kept, not divided by"
  (for ([frequencies '((1.0 1.0) (0.3 0.30000000000000004) (2 2))])
    (define P (perturbation-series (apply free frequencies) exchange two))
    (check-equal? (perturbation-divisors P) '())
    (check-equal? (map cadr (perturbation-resonances P)) '((1 -1)))
    (check-identity (series:ref ((perturbation-Hamiltonian P) two) 1)
                    (* 'epsilon (cos (- 'theta 'phi)))))
  (define near (perturbation-series (free 1.0 1.001) exchange two))
  (check-equal? (map cadr (perturbation-divisors near)) '((1 -1))))

(test-case "what it prints"
  (check-equal? (format "~a" (perturbation-series driven-rotor drive two #:keep '((1 -1) (1 1))))
                (string-append
                 "perturbation to order 1 in epsilon\n"
                 "  order 0: (+ (* P omega) (/ (* 1/2 (expt p 2)) alpha))\n"
                 "  order 1: (+ (* gamma (cos (+ phi theta))) (* gamma (cos (- phi theta))))\n"
                 "  divided by: (/ p alpha), of the wave (1 0)\n"
                 "  resonance: (1 -1), kept in order 1\n"
                 "  resonance: (1 1), kept in order 1")))

;; ---------------------------------------------------------------------------
;; Mistakes

(define P1 (perturbation-series rotor gravity line))

(test-case "a state on a resonance that was divided by"
  (check-message
   (string-append
    "perturbation-transformation: the state is on the resonance (1), which was divided by in "
    "order 1: (/ p alpha) = 0\n  #:keep '((1)) keeps its waves\n  state: (up 0 1 0)")
   ((perturbation-transformation P1) (up 0 1 0))
   exn:fail:mechanics:singular?))

(says
 [(perturbation-series gravity rotor line)
  "perturbation-series: the Hamiltonian without the perturbation is to depend on the momenta "
  "alone, but gravity depends on the angle theta\n  its value: (* -1 beta (cos theta))\n"
  "  action and angle make it so: for an oscillator, polar-canonical"]
 [(perturbation-series rotor (lambda (s) (square (coordinate s))) line)
  "perturbation-series: a perturbation is a sum of sines and cosines of integer multiples of the "
  "angles, with coefficients in the momenta; in <function> there is theta"]
 [(perturbation-series rotor (lambda (s) (cos (* 1/2 (coordinate s)))) line)
  "perturbation-series: a perturbation is a sum of sines and cosines of integer multiples of the "
  "angles, with coefficients in the momenta; in <function> there is (cos (* 1/2 theta))"]
 [(perturbation-series rotor (lambda (s) (* (time s) (cos (coordinate s)))) line)
  "perturbation-series: <function> depends on the time t: periodic-extension makes it an angle\n"
  "  its value: (* t (cos theta))"]
 [(perturbation-series rotor gravity line #:keep '(1))
  "perturbation-series: the waves to be kept are lists of one integer, one for each angle, such "
  "as ((1)); given (1)"]
 [(perturbation-series rotor gravity line #:order 0)
  "perturbation-series: expected the order, at least 1\n  given: the number 0"]
 [(perturbation-series 'H0 gravity line)
  "perturbation-series: a Hamiltonian is a function of the state (up t q p); given the symbol H0"
  "\n  with its quote it is only a name; the function itself is H0"]
 [(resonance-width rotor gravity 1 line)
  "resonance-width: expected the integers of a wave, a list of 1; given the number 1"]
 [(perturbation-inverse 3)
  "perturbation-inverse: expected what perturbation-series gives\n  given: the number 3"]
 [(perturbation-solution (perturbation-series driven-rotor drive two #:keep '((1 -1))))
  "perturbation-solution: the new Hamiltonian has the waves ((1 -1)) left, kept for resonances; "
  "its motion is no rotation\n  integrate that of (perturbation-Hamiltonian P)"])

;; Procedures for a perturbation, given the Hamiltonian it was made of
(test-case "what takes a perturbation says so of other things"
  (for ([take (list perturbation-Hamiltonian perturbation-generators perturbation-divisors
                    perturbation-resonances perturbation-transformation perturbation-inverse
                    perturbation-solution verify-perturbation perturbation-verdicts)]
        [name '(perturbation-Hamiltonian perturbation-generators perturbation-divisors
                perturbation-resonances perturbation-transformation perturbation-inverse
                perturbation-solution verify-perturbation perturbation-verdicts)])
    (check-message
     (format "~a: expected what perturbation-series gives\n  given: the procedure `rotor`" name)
     (take rotor) exn:fail:contract?)))

(define ((rotor-of alpha) state) (rotor state))

(says
 [(perturbation-series rotor gravity line #:parameter 'theta)
  "perturbation-series: the parameter theta stands in the state or in a Hamiltonian, too; "
  "#:parameter gives it another name"]
 [(perturbation-series rotor gravity line #:parameter 'beta)
  "perturbation-series: the parameter beta stands in the state or in a Hamiltonian, too; "
  "#:parameter gives it another name"]
 [(perturbation-series rotor gravity line #:parameter sin)
  "perturbation-series: the parameter is a number or a symbol; given the procedure `sin`"])

(test-case "parameters that were forgotten"
  (check-regexp-match #rx"^perturbation-series: the value of a Hamiltonian is a number.*left out"
                      (message-of (perturbation-series rotor-of gravity line))))
