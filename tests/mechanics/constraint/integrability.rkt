#lang racket/base
;; Constraints on velocities that are constraints on coordinates, and others.

(require mechanics
         "../support/checks.rkt" "../support/random.rkt" "../support/session.rkt")

(define q (up 'x 'y 'θ))
(define-syntax-rule (form (t (x y θ) (vx vy ω)) value)
  (nonholonomic
   (lambda (t q v)
     (define-values (x y θ) (values (ref q 0) (ref q 1) (ref q 2)))
     (define-values (vx vy ω) (values (ref v 0) (ref v 1) (ref v 2)))
     value)))
(define (status constraints) (verdict-status (Frobenius-test constraints q)))

(define blade (form (t (x y θ) (vx vy ω)) (- (* vx (sin θ)) (* vy (cos θ)))))

(test-case "a knife edge is nonholonomic, with or without gravity"
  (check-eq? (status blade) 'refuted)
  (check-exn #rx"^constraint-integral: the constraint is not integrable\n"
             (lambda () (constraint-integral blade q))))

;; ω = dy − x dθ allows (1, 0, 0) and (0, x, 1), to which dω = −dx∧dθ gives −1.
(test-case "one number decides about one form of three coordinates"
  (define v (Frobenius-test (form (t (x y θ) (vx vy ω)) (- vy (* x ω))) q))
  (check-eqv? (verdict-residual v) -1))

(test-case "a wheel is nonholonomic, a wheel that keeps its direction is not"
  (define wheel-coordinates (up 'x 'y 'φ 'θ))
  (define (rolling t q v)
    (up (- (ref v 0) (* 'R (sin (ref q 3)) (ref v 2)))
        (- (ref v 1) (* 'R (cos (ref q 3)) (ref v 2)))))
  (define straight (nonholonomic (lambda (t q v) (- (ref v 3) 0))))
  (define (wheel-status constraints)
    (verdict-status (Frobenius-test constraints wheel-coordinates)))
  (check-eq? (wheel-status (nonholonomic rolling)) 'refuted)
  (check-eq? (wheel-status (list (nonholonomic rolling) straight)) 'proved))

(test-case "what is the rate of a function is integrable, also with time in it"
  (check-eq? (status (form (t (x y θ) (vx vy ω)) (+ (* y vx) (* x vy)))) 'proved)
  (check-eq? (status (form (t (x y θ) (vx vy ω)) (+ x (* t vx) (* -1 (cos θ) ω)))) 'proved)
  (check-eq? (status (form (t (x y θ) (vx vy ω)) (+ (* y vx) (* -1 x vy) (* t ω)))) 'refuted)
  (check-eq? (status (holonomic (lambda (t q) (- (ref q 0) (* t (sin (ref q 2))))))) 'proved))

;; The integral's rate is a multiple of the constraint: both vanish for the same velocities.
(define (check-integral constraint expected)
  (define G (constraint-integral constraint q))
  (check-identity (G 't q) expected))

(test-case "integrals of polynomials and waves"
  (check-integral (form (t (x y θ) (vx vy ω)) (+ (* y vx) (* x vy))) (* 'x 'y))
  (check-integral (form (t (x y θ) (vx vy ω)) (- vx (* 'R (cos θ) ω))) (- 'x (* 'R (sin 'θ))))
  (check-integral (form (t (x y θ) (vx vy ω)) (+ x (* t vx) (* -2 y vy))) (- (* 't 'x) (square 'y)))
  (check-integral (form (t (x y θ) (vx vy ω))
                        (+ (* 2 x (sin y) vx) (* (square x) (cos y) vy) (* 3 (square θ) ω)))
                  (+ (* (square 'x) (sin 'y)) (cube 'θ))))

(test-case "with an integrating factor"
  (check-integral (form (t (x y θ) (vx vy ω)) (- (* y vx) (* x vy))) (/ (* -1 'y) 'x))
  (check-integral (form (t (x y θ) (vx vy ω)) (+ vx (* 2 x ω))) (+ 'θ (/ (log 'x) 2)))
  (check-integral (form (t (x y θ) (vx vy ω)) (+ (* (+ (* 3 x) (* 2 y)) vx) (* x vy)))
                  (+ (cube 'x) (* (square 'x) 'y))))

(test-case "coefficients that depend on time count, with a term without velocity or none"
  (define turning (form (t (x y θ) (vx vy ω)) (+ (* (cos t) vx) (* (sin t) vy))))
  (check-eq? (status turning) 'refuted)
  (check-exn #rx"^constraint-integral: the constraint is not integrable\n"
             (lambda () (constraint-integral turning q)))
  (check-eq? (status (form (t (x y θ) (vx vy ω)) (* t (+ vx vy)))) 'proved)
  (check-eq? (status (form (t (x y θ) (vx vy ω)) (+ y vx))) 'refuted)
  (check-eq? (status (form (t (x y θ) (vx vy ω)) (+ x vx))) 'proved))

;; b + a₁ ẋ + a₂ ẏ = 0 is integrable where ω ∧ dω = 0 for ω = b dt + a₁ dx + a₂ dy.
(define (twist b a1 a2)
  (define-values (by-t by-x by-y) (values (partial 0) (partial 1) (partial 2)))
  (+ (* b (- (by-x a2) (by-y a1))) (* a1 (- (by-y b) (by-t a2))) (* a2 (- (by-t a1) (by-x b)))))

(define (random-polynomial)
  (define-values (c i j k) (values (random-rational) (random 2) (random 2) (random 2)))
  (define-values (d l) (values (random-rational) (random 3)))
  (lambda (t x y) (+ (* c (expt t i) (expt x j) (expt y k)) (* d (expt (ref (up t x y) l) 2)))))

(test-case "forms of time and two coordinates, at random: integrable where ω ∧ dω = 0"
  (define (check-form b a1 a2 expected)
    (define constraint
      (nonholonomic
       (lambda (t q v)
         (define (at f) (f t (ref q 0) (ref q 1)))
         (+ (at b) (* (at a1) (ref v 0)) (* (at a2) (ref v 1))))))
    (with-check-info (['form (list (b 't 'x 'y) (a1 't 'x 'y) (a2 't 'x 'y))])
      (check-eq? (verdict-status (Frobenius-test constraint (up 'x 'y))) expected)))
  (define (zero t x y) 0)
  (with-seed 1903
    (for ([k 12])
      (define-values (b a1 a2)
        (values (if (even? k) zero (random-polynomial)) (random-polynomial) (random-polynomial)))
      (define nothing? (zero? (simplify ((twist b a1 a2) 't 'x 'y))))
      (check-form b a1 a2 (if nothing? 'proved 'refuted))
      (define-values (mu G) (values (random-polynomial) (random-polynomial)))
      (check-form (* mu ((partial 0) G)) (* mu ((partial 1) G)) (* mu ((partial 2) G)) 'proved))))

(test-case "an integral makes a holonomic constraint"
  (define rolling (form (t (x y θ) (vx vy ω)) (- vx (* 'R ω))))
  (define G (constraint-integral rolling q))
  (define (L (up t q v)) (- (* 1/2 'm (square (ref v 0))) (* -1/2 'J (square (ref v 2)))
                            (* 'F (ref q 0)) (* -1/2 (square (ref v 1)))))
  (define state (up 't q (up 'vx 'vy 'ω)))
  (check-identity (ref ((constrained-accelerations L rolling) state) 0)
                  (ref ((constrained-accelerations L (holonomic G)) state) 0)))

(test-case "the integral of one constraint is a scalar, of several, or a list, a tuple of theirs"
  (define rolling (form (t (x y θ) (vx vy ω)) (- vx (* 'R ω))))
  (define both (form (t (x y θ) (vx vy ω)) (up (- vx (* 'R ω)) vy)))
  (define x-Rθ (- 'x (* 'R 'θ)))
  (check-identity ((constraint-integral rolling q) 't q) x-Rθ)
  (check-identity ((constraint-integral (list rolling) q) 't q) (up x-Rθ))
  (check-identity ((constraint-integral both q) 't q) (up x-Rθ 'y)))

(test-case "an integral that is not found is not made up"
  (define odd (form (t (x y θ) (vx vy ω)) (+ vx (* (exp (square y)) vy))))
  (check-eq? (status odd) 'proved)
  (check-exn #rx"^constraint-integral: the constraint is integrable; its integral was not found"
             (lambda () (constraint-integral odd q))))

(test-case "coordinates are symbols"
  (check-exn #rx"^Frobenius-test: expected coordinates that are symbols other than t"
             (lambda () (Frobenius-test blade (up 1 2 3)))))
