#lang mechanics
;; An oscillator with forces outside its Lagrangian: a drag, and a driving force.

(define ((L-oscillator m k) (up t x v))
  (- (* 1/2 m (square v)) (* 1/2 k (square x))))
(define ((drag b) (up t x v)) (* -1 b v))
(define x (literal-function 'x))
(define L (L-oscillator 'm 'k))

;; Is e^{−γt} cos ωt a motion?  The residual says which two relations make it one.
(define (proposed t) (* 'a (exp (* -1 'gamma t)) (cos (* 'omega t))))
(define verdict (verify-solution L proposed #:force (drag 'b)))
verdict

;; Both together do; one does not.
(define (judge b k) (verify-solution (L-oscillator 'm k) proposed #:force (drag b)))
(define b-needed (* 2 'm 'gamma))
(define k-needed (* 'm (+ (square 'gamma) (square 'omega))))
(judge b-needed k-needed)
(map verdict-status (list (judge b-needed 'k) (judge 'b k-needed)))

;; They are necessary: the residual at time 0 and its rate there vanish only so.
(define residual ((Lagrange-equations L #:force (drag 'b)) proposed))
(verdict-conditions (prove-zero (residual 0)))
(verdict-conditions
 (prove-zero (substitute ((D residual) 0)
                         'k (+ (* 'b 'gamma) (* 'm (- (square 'omega) (square 'gamma)))))))

;; Rayleigh's dissipation function F = ½ b v² gives the same equations.
(define F (Rayleigh-dissipation (* 1/2 'b)))
(verify-equal ((Lagrange-equations L F) x) ((Lagrange-equations L #:force (drag 'b)) x))

;; Driven, it settles to an oscillation with the frequency of the drive.
(define ((drive A Omega) (up t x v)) (* A (cos (* Omega t))))
(define (settled t)
  (define stiffness (- 'k (* 'm (square 'Omega))))
  (define resistance (* 'b 'Omega))
  (* 'A (/ (+ (* stiffness (cos (* 'Omega t))) (* resistance (sin (* 'Omega t))))
           (+ (square stiffness) (square resistance)))))
(verify-solution L settled #:force (+ (drag 'b) (drive 'A 'Omega)))

;; A force that depends on time alone might as well be a potential, −f(t) x.
(define f (literal-function 'f))
(define (given-force local) (f (time local)))
(define (L-driven local) (+ (L local) (* (f (time local)) (coordinate local))))
(verify-equal ((Lagrange-equations L #:force given-force) x) ((Lagrange-equations L-driven) x))

;; The drag takes the energy that the drive supplies: along what has settled, the energy
;; changes by the power of both.
(prove-zero ((power-balance L #:force (+ (drag 'b) (drive 'A 'Omega))) settled))

(module+ test
  (require rackunit)
  (test-case "the verdict names the two relations"
    (check-true (refuted? verdict))
    (check-equal? (map cadr (map expression (verdict-conditions verdict))) '(b k)))
  (test-case "it is a motion when both hold, and only then"
    (check-true (proved? (judge b-needed k-needed)))
    (check-true (refuted? (judge b-needed 'k)))
    (check-true (refuted? (judge 'b k-needed))))
  (test-case "each way to state a force gives the same equations"
    (check-true (proved? (verify-equal ((Lagrange-equations L F) x)
                                       ((Lagrange-equations L #:force (drag 'b)) x))))
    (check-true (proved? (verify-equal ((Lagrange-equations L #:force given-force) x)
                                       ((Lagrange-equations L-driven) x)))))
  (test-case "the settled motion is one, and not without its drive"
    (check-true (proved? (verify-solution L settled #:force (+ (drag 'b) (drive 'A 'Omega)))))
    (check-true (refuted? (verify-solution L settled #:force (drag 'b)))))
  (test-case "whatever it starts from, it settles to that"
    (define slope
      (Lagrangian->state-derivative (L-oscillator 1.0 4.0)
                                    #:force (+ (drag 0.5) (drive 3.0 1.5))))
    (define tr (evolve-trajectory slope (up 0.0 2.0 -1.0) 100.0 #:tolerance 1e-12))
    (define at-end
      (substitute (settled 't) 't 100.0 'm 1.0 'k 4.0 'b 0.5 'A 3.0 'Omega 1.5))
    (check-= (coordinate (tr 100.0)) at-end 1e-9)))
