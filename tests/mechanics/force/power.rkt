#lang racket/base
;; Forces outside the Lagrangian: the same equations however they are given, and the
;; energy they add and take.

(require mechanics
         (only-in mechanics/book L-harmonic)
         "../support/checks.rkt" "../support/session.rkt")

(define ((drag b) local) (* -2 b (velocity local)))
(define ((driving f) local) (f (time local)))
(define x (literal-function 'x))
(define f (literal-function 'f))
(define L (L-harmonic 'm 'k))

(test-case "a dissipation function and its force are the same to all that take forces"
  (define F (Rayleigh-dissipation 'b))
  (check-identity ((Lagrange-equations L F) x) ((Lagrange-equations L #:force (drag 'b)) x))
  (check-identity ((Lagrange-equations L F) x)
                  ((Lagrange-equations L #:force (- ((partial 2) F))) x))
  (check-identity ((Lagrangian->acceleration L F) (up 't 'x 'v))
                  ((Lagrangian->acceleration L #:force (drag 'b)) (up 't 'x 'v)))
  (check-identity ((power-balance L F) x) ((power-balance L #:force (drag 'b)) x)))

(test-case "verify-solution takes both"
  ;; e^{−γt} is a motion if m γ² − 2 b γ + k = 0
  (define (decay t) (exp (* -1 'gamma t)))
  (define L-2 (L-harmonic 'm (* 'gamma (- (* 2 'b) (* 'm 'gamma)))))
  (check-eq? (verdict-status (verify-solution L-2 decay (Rayleigh-dissipation 'b))) 'proved)
  (check-eq? (verdict-status (verify-solution L-2 decay #:force (drag 'b))) 'proved)
  (check-eq? (verdict-status (verify-solution L-2 decay)) 'refuted))

(test-case "a force that depends on time alone may be a potential instead: −f(t) q"
  (define (L-driven local) (+ (L local) (* (f (time local)) (coordinate local))))
  (check-identity ((Lagrange-equations L #:force (driving f)) x) ((Lagrange-equations L-driven) x)))

;; ---------------------------------------------------------------------------
;; The balance of power

(define any-L (literal-function 'L (Lagrangian 2)))
(define any-Q
  (literal-function 'Q (-> (UP Real (UP Real Real) (UP Real Real)) (DOWN Real Real))))
(define q (up (literal-function 'a) (literal-function 'b)))

(test-case "what is missing in the balance is the residual times the velocity, for any L and Q"
  (check-identity ((power-balance any-L #:force any-Q) q)
                  (* ((Lagrange-equations any-L #:force any-Q) q) (D q)))
  (check-pred refuted? (verify-equal ((power-balance any-L #:force any-Q) q)
                                     (* ((Lagrange-equations any-L) q) (D q))))
  (check-identity ((power-balance any-L) q) (* ((Lagrange-equations any-L) q) (D q))))

(test-case "so it is zero where the accelerations are those of the equations, and not elsewhere"
  (define Q (+ (drag 'b) (driving f)))
  (define (L local) (* (exp (time local)) ((L-harmonic 'm 'k) local)))
  (define slope (Lagrangian->state-derivative L #:force Q))
  (define E (Lagrangian->energy L))
  (define state (up 't 'x 'v))
  (define (balance acceleration)
    (- (* ((D E) state) (up 1 'v acceleration)) (- (* (Q state) 'v) (((partial 0) L) state))))
  (check-eq? (verdict-status (prove-zero (balance (ref (slope state) 2)))) 'proved)
  (check-eq? (verdict-status (prove-zero (balance 'a))) 'refuted))

(test-case "it is zero along motions"
  (define driven (L-harmonic 'm (* 'gamma (- (* 2 'b) (* 'm 'gamma)))))
  (define (decay t) (exp (* -1 'gamma t)))
  (check-eq? (verdict-status (prove-zero ((power-balance driven (Rayleigh-dissipation 'b)) decay)))
             'proved)
  (check-eq? (verdict-status (prove-zero ((power-balance driven) decay))) 'refuted))

(test-case "a zero force has no power, whatever its shape"
  (check-identity ((power-balance any-L #:force (lambda (local) 0)) q) ((power-balance any-L) q)))

(test-case "evolve and evolve-trajectory follow forces; energy and work agree to the last digits"
  (define (push t) (cos (* 2 t)))
  (define (derivative m k b)
    (Lagrangian->state-derivative (L-harmonic m k) #:force (+ (drag b) (driving push))))
  (define (work-too m k b)      ; the work done on the way, as a third part of the state
    (define slope (derivative m k b))
    (define Q (+ (drag b) (driving push)))
    (lambda (s)
      (define local (up (ref s 0) (ref s 1) (ref s 2)))
      (define next (slope local))
      (up 1 (ref next 1) (ref next 2) (* (Q local) (velocity local)))))
  (define end ((state-advancer work-too 1.0 4.0 0.1) (up 0.0 1.0 0.0 0.0) 10.0 1e-13))
  (define E (Lagrangian->energy (L-harmonic 1.0 4.0)))
  (check-= (- (E (up (ref end 0) (ref end 1) (ref end 2))) (E (up 0.0 1.0 0.0)))
           (ref end 3) 1e-11)
  (define trajectory (evolve-trajectory (derivative 1.0 4.0 0.1) (up 0.0 1.0 0.0) 10.0
                                        #:tolerance 1e-13))
  (check-= (coordinate (trajectory-final-state trajectory)) (ref end 1) 1e-11))

(test-case "it prints with what it was made from"
  (check-equal? (format "~a" (list (power-balance L) (power-balance L #:force f)
                                   ((power-balance L) x)))
                (string-append "((power-balance L-harmonic) (power-balance L-harmonic #:force f) "
                               "((power-balance L-harmonic) x))")))
