#lang racket/base
;; Slips of those who come to chapters 5 to 7 with the manual alone, and what is said: in the words
;; of what was called, never of what that calls.

(require mechanics
         (only-in mechanics/verdict/verdict
                  verdict-claim claim-subject canonical-claim-C canonical-claim-state)
         "../support/checks.rkt" "../support/messages.rkt" "../support/session.rkt")

(define line (up 't 'q 'p))
(define polar (up 't (up 'r 'phi) (down 'p_r 'p_phi)))
(define plane (up 't (up 'x 'y) (down 'p_x 'p_y)))
(define two (up 's (up 'phi 'theta) (down 'P 'p)))
(define ((H-harmonic m k) (up t x p)) (+ (/ (square p) (* 2 m)) (* 1/2 k (square x))))
(define C (F->CH p->r))
(define H (literal-function 'H (Hamiltonian 2)))

(test-case "residuals print as the calls that make them, and a verdict knows what it is about"
  (for ([residual (list (compositional-canonical? C H) (canonical-H? C H))]
        [text '("(compositional-canonical? (F->CH p->r) H)" "(canonical-H? (F->CH p->r) H)")])
    (check-equal? (format "~a" residual) text))
  (define S (lambda (t q) (* q t)))
  (check-equal? (procedure-arity (Hamilton-Jacobi-residual (H-harmonic 1 1) S)) 2)
  (define claim (claim-subject (verdict-claim (verify-canonical C polar))))
  (check-eq? (canonical-claim-C claim) C)
  (check-equal? (canonical-claim-state claim) polar))

;; ---------------------------------------------------------------------------
;; Arguments exchanged, parameters forgotten

(define (no-state who)
  (string-append
   who ": a transformation takes a state (up t q p) to another one; H gives "
   "(H (up t (up r phi) (down p_r p_phi))), a number-like expression\n"
   "  that is no state, but what a Hamiltonian gives; the transformation comes first"))

(says
 [((canonical? H C H) polar) (no-state "canonical?")]
 [((compositional-canonical? H C) polar) (no-state "compositional-canonical?")]
 [((canonical-H? H C) polar) (no-state "canonical-H?")]
 [((qp-canonical? H C) polar) (no-state "qp-canonical?")]
 [(verify-canonical polar C)
  "verify-canonical: expected a transformation, a function of the state (up t q p); given "
  "(up t (up r phi) (down p_r p_phi)), an up tuple of 3\n"
  "  the transformation comes first, the state after it"]
 [(Hamilton-Jacobi-residual (lambda (t q) (square q)) (H-harmonic 'm 'k))
  "Hamilton-Jacobi-residual: the Hamiltonian comes first, then the principal function: "
  "(Hamilton-Jacobi-residual H S); given <function>, H-harmonic"]
 [(polar-canonical (up 't 'theta 'I))
  "polar-canonical: alpha is a number or a symbol; given (up t theta I), an up tuple of 3\n"
  "  was a parameter left out? the state comes after it"]
 [(polar-canonical-inverse sin)
  "polar-canonical-inverse: alpha is a number or a symbol; given the procedure `sin`"]
 [(two-particle-center-of-mass 1 plane)
  "two-particle-center-of-mass: a mass is a number or a symbol; given "
  "(up t (up x y) (down p_x p_y)), an up tuple of 3\n"
  "  was a parameter left out? the state comes after it"]
 [(two-particle-center-of-mass-canonical '(1 2) 1)
  "two-particle-center-of-mass-canonical: a mass is a number or a symbol; given (1 2), a list"]
 [(verify-canonical (polar-canonical 'theta) (up 't 'theta 'I))
  "verify-canonical: the symbol theta is a parameter of (polar-canonical theta), and stands in "
  "the state, too\n  state: (up t theta I)\n  give one of them another name"]
 [(J-func plane)
  "J-func: expected the derivative of a function of the state, (down a b c)\n  given: "
  "(up t (up x y) (down p_x p_y)), an up tuple of 3\n  of H at a state: (J-func ((D H) state))"]
 [(verify-symplectic (matrix-by-rows '(1 2 3) '(4 5 6)))
  "verify-symplectic: a symplectic matrix is square, with an even number of rows; given "
  "(matrix-by-rows (list 1 2 3) (list 4 5 6)), a 2 by 3 matrix"])

;; ---------------------------------------------------------------------------
;; A transformation that depends on the time, with H∘C alone for the new Hamiltonian

(test-case "the verdict says what is missing"
  (define (pendulum s) (- (/ (square (momentum s)) 2) (cos (coordinate s))))
  (define moving (F->CH (lambda (s) (+ (coordinate s) (* 'v (time s))))))
  (define v (verify-canonical moving pendulum (compose pendulum moving) line))
  (check-pred refuted? v)
  (check-not-false
   (member (string-append "the transformation depends on the time: the new Hamiltonian is "
                          "H∘C + K with the K of (C->K C state)")
           (verdict-remarks v)))
  (define K (C->K moving line))
  (check-pred proved? (verify-canonical moving pendulum (+ (compose pendulum moving) K) line))
  ;; the momentum alone may depend on it
  (define (kicked s) (up (time s) (coordinate s) (+ (momentum s) (time s))))
  (check-true (ormap (lambda (text) (regexp-match? #rx"depends on the time" text))
                     (verdict-remarks (verify-canonical kicked pendulum (compose pendulum kicked)
                                                        line))))
  ;; of one that does not depend on it, or is not canonical, that would be no help
  (for ([C (list (polar-canonical 'a) (lambda (s) (up (time s) (* (time s) (coordinate s))
                                                      (momentum s))))])
    (define other (verify-canonical C pendulum pendulum line))
    (check-pred refuted? other)
    (check-false (ormap (lambda (text) (regexp-match? #rx"depends on the time" text))
                        (verdict-remarks other)))))

(says
 [((Hamilton-Jacobi-residual (H-harmonic 1 1) (lambda (t q) q)) line)
  "Hamilton-Jacobi-residual: arity mismatch;\n the expected number of arguments does not match "
  "the given number\n  expected: 2\n  given: 1\n  arguments...:\n   (up t q p)"]
 [(resonance-width (H-harmonic 1 1) cos '(1) line)
  "resonance-width: the Hamiltonian without the perturbation is to depend on the momenta alone, "
  "but H-harmonic depends on the angle q\n  its value: (* 1/2 (+ (expt p 2) (expt q 2)))\n"
  "  action and angle make it so: for an oscillator, polar-canonical"]
 [(resonance-center (H-harmonic 1 1) '(1) line 0)
  "resonance-center: the Hamiltonian without the perturbation is to depend on the momenta alone, "
  "but H-harmonic depends on the angle q\n  its value: (* 1/2 (+ (expt p 2) (expt q 2)))\n"
  "  action and angle make it so: for an oscillator, polar-canonical"]
 [(verify-canonical (lambda (s) (up (time s) (up (coordinate s) 0) (down (momentum s) 0))) line)
  "verify-canonical: <function> takes 1 coordinate to 2; a canonical transformation keeps their "
  "number"])

;; ---------------------------------------------------------------------------
;; Generating functions

(says
 [(generating-function C polar #:type 2)
  "generating-function: no formula was found for the new coordinates from the old coordinates and "
  "the new momenta\n  there is one for #:type 3"]
 [(generating-function C polar #:type 4)
  "generating-function: no formula was found for the new coordinates from the old momenta and "
  "the new momenta\n  there is one for #:type 3"]
 [(generating-function (polar-canonical 'theta) (up 't 'theta 'I))
  "generating-function: the symbol theta is a parameter of (polar-canonical theta), and stands in "
  "the state, too\n  state: (up t theta I)\n  give one of them another name"])

(test-case "what cannot be integrated is shown in the letters of the state"
  (check-message
   (string-append "generating-function: no antiderivative was found\n"
                  "  of: (* (sqrt (* 1/2 I alpha)) (sqrt (- 4 (/ (* 2 alpha (expt old_q 2)) I))))\n"
                  "  by: old_q")
   (generating-function (polar-canonical 'alpha) (up 't 'theta 'I) #:type 2)
   exn:fail:mechanics?))

(test-case "p. 376: polar coordinates as the old ones, of type 2 and 3"
  (define back (F->CH r->p))
  (check-identity ((generating-function back plane #:type 2)
                   't (up 'r 'phi) (down 'p_x 'p_y))
                  (* 'r (+ (* 'p_x (cos 'phi)) (* 'p_y (sin 'phi)))))
  (check-identity ((generating-function back plane #:type 3)
                   't (down 'p_r 'p_phi) (up 'x 'y))
                  (- (+ (* 'p_r (sqrt (+ (square 'x) (square 'y)))) (* 'p_phi (atan 'y 'x))))))

;; ---------------------------------------------------------------------------
;; Orbits

(define not-numbers
  (string-append "action-of-orbit: the parameters of H-harmonic are to be numbers; "
                 "there is (* -1 k)\n  (H state) is to be a number"))

(says
 [(action-of-orbit (H-harmonic 'm 'k) (up 0 1 0)) not-numbers]
 [(action-of-orbit (H-harmonic 1 1) (up 0 1 0) #:tolerance 0)
  "action-of-orbit: expected a positive tolerance\n  given: the number 0"]
 [(frequency-of-orbit (H-harmonic 1 1) (up 0 1 0) #:turn 'x)
  "frequency-of-orbit: expected a turn of the coordinate that is a real number\n"
  "  given: the symbol x\n  give its symbols values first"]
 [(action-of-orbit (H-harmonic 1 1) (up 0 1 0) #:longest-time -1)
  "action-of-orbit: expected a positive time after which to give up\n  given: the number -1"]
 [(state->action-angle (H-harmonic 1 1) #:center 'a)
  "state->action-angle: expected a center that is a real number\n  given: the symbol a\n"
  "  give its symbols values first"]
 [(action-angle->state (H-harmonic 1 1) #:turn -1)
  "action-angle->state: expected a positive turn of the coordinate\n  given: the number -1"]
 [(loop-integral (up 0 1 2) 0 1)
  "loop-integral: expected a loop, a function of one parameter with states as values; given "
  "(up 0 1 2), an up tuple of 3"])

(test-case "a motion that runs away"
  (check-regexp-match
   #rx"^action-of-orbit: the motion through .up 0 1 0. does not close: the motion cannot be followed"
   (message-of (action-of-orbit (H-harmonic 1 -1) (up 0 1 0)) exn:fail:mechanics:not-convergent?)))

;; ---------------------------------------------------------------------------
;; Perturbations and resonances

(define (H0 (up t q (down P p))) (+ (/ (square p) (* 2 'alpha)) (* 'omega P)))
(define (wave (up t (up phi theta) p)) (cos (+ theta phi)))
(define found (perturbation-series H0 wave two))

(says
 [((perturbation-transformation found) line)
  "perturbation-transformation: expected a state like (up s (up phi theta) (down P p)); "
  "given (up t q p)"]
 [((car (perturbation-generators found)) line)
  "perturbation-series: expected a state like (up s (up phi theta) (down P p)); given (up t q p)"]
 [(perturbation-series H0 (literal-function 'V (Hamiltonian 2)) two)
  "perturbation-series: a perturbation is a sum of sines and cosines of integer multiples of the "
  "angles, with coefficients in the momenta; in V there is (V (up s (up phi theta) (down P p)))"]
 [(perturbation-series H0 wave two #:order 'n)
  "perturbation-series: expected the order, at least 1\n  given: the symbol n"]
 [(perturbation-series H0 wave two #:order 3/2)
  "perturbation-series: expected the order, at least 1\n  given: the number 3/2"]
 [(resonance-center H0 '(1 1) two 2)
  "resonance-center: expected the index of a momentum, below 2\n  given: the number 2"]
 [(resonance-center H0 '(1 1 1) two 1)
  "resonance-center: expected the integers of a wave, a list of 2; given (1 1 1), a list"]
 [(resonance-center 'H0 '(1 1) two 1)
  "resonance-center: a Hamiltonian is a function of the state (up t q p); given the symbol H0"
  "\n  with its quote it is only a name; the function itself is H0"]
 [(resonance-center (lambda (s) (+ (expt (ref s 2 1) 3) (ref s 2 0))) '(1 1) two 1)
  "resonance-center: the frequency of the wave (1 1) is not of degree 1 in the momentum 1\n"
  "  its zeros are found by (find-root f low high)"]
 [(resonance-center H0 '(1 1) two 0)
  "resonance-center: the frequency of the wave (1 1) does not depend on the momentum 0"]
 [(resonance-width H0 3 '(1 1) two)
  "resonance-width: a Hamiltonian is a function of the state (up t q p); given the number 3"]
 [(periodic-extension (H-harmonic 1 1) 0)
  "periodic-extension: the frequency is a number other than 0, or a symbol; given the number 0"])

(test-case "a whole number written as a decimal counts waves"
  (define (V s) (cos (* 2.0 (ref s 1 0))))
  (check-equal? (map cadr (perturbation-divisors (perturbation-series H0 V two))) '((2 0))))

;; ---------------------------------------------------------------------------
;; Normal forms

(define (round-well (up t (up x y) p))
  (+ (* 1/2 (+ (square p) (square x) (square y))) (* (square x) y)))
(define N (Birkhoff-normal-form round-well plane #:degree 3))

(says
 [((normal-form-transformation N) line)
  "normal-form-transformation: expected a state like (up t (up x y) (down p_x p_y)); "
  "given (up t q p)"]
 [((car (normal-form-generators N)) line)
  "Birkhoff-normal-form: expected a state like (up t (up x y) (down p_x p_y)); given (up t q p)"]
 [(normal-form-frequencies 3)
  "normal-form-frequencies: expected what Birkhoff-normal-form gives\n  given: the number 3"]
 [(Birkhoff-normal-form (lambda (s) (/ 1 (coordinate s))) line)
  "Birkhoff-normal-form: <function> has no Taylor series at the origin: it divides by zero there"]
 [(Birkhoff-normal-form (lambda (s) (* (time s) (square (coordinate s)))) line)
  "Birkhoff-normal-form: <function> depends on the time t, and has no normal form; "
  "its value: (* (expt q 2) t)"])

(test-case "what takes a normal form or a separation says so of other things"
  (for ([take (list normal-form-Hamiltonian normal-form-generators normal-form-resonances)]
        [name '(normal-form-Hamiltonian normal-form-generators normal-form-resonances)])
    (check-message (format "~a: expected what Birkhoff-normal-form gives\n  given: the symbol N"
                           name)
                   (take 'N)))
  (for ([take (list separation-momenta separation-constants separation-integrals
                    separation-function verify-separation
                    (lambda (s) (separation-actions s line))
                    (lambda (s) (separation-frequencies s line)))]
        [name '(separation-momenta separation-constants separation-integrals
                separation-function verify-separation separation-actions
                separation-frequencies)])
    (check-message
     (format "~a: expected what separate-Hamilton-Jacobi gives\n  given: the number 3" name)
     (take 3))))

(says
 [(Poisson-bracket H0 two)
  "Poisson-bracket: it takes functions of the state, and what it gives the state: "
  "((Poisson-bracket f g) state); given (up s (up phi theta) (down P p)), an up tuple of 3"]
 [(Lie-transform 'H0 'epsilon)
  "Lie-transform: a Hamiltonian is a function of the state (up t q p); given the symbol H0"
  "\n  with its quote it is only a name; the function itself is H0"]
 [(Lie-transformation two 'epsilon 2)
  "Lie-transformation: a Hamiltonian is a function of the state (up t q p); "
  "given (up s (up phi theta) (down P p)), an up tuple of 3"])

(test-case "motions may go into motions though the brackets are not kept, which is told"
  (define state (up 't 'x 'p))
  (define (H s) (+ (square (momentum s)) (square (coordinate s))))
  (define (remarks C H-prime) (verdict-remarks (verify-canonical C H H-prime state)))
  (define ((stretched a b) s) (up (time s) (* a (coordinate s)) (* b (momentum s))))
  (define (told? r) (regexp-match? #rx"of these Hamiltonians alone.*does not keep the Poisson" r))
  (for ([C (list (stretched 0 0) (stretched 2 3))]
        [H-prime (list H (lambda (s) (/ (H ((stretched 2 3) s)) 6)))])
    (check-true (proved? (verify-canonical C H H-prime state)))
    (check-true (ormap told? (remarks C H-prime))))
  (check-equal? (remarks (stretched 2 1/2) (compose H (stretched 2 1/2))) '()))
