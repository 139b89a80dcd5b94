#lang racket/base
;; Constraints on velocities that are constraints on coordinates, and others.

(require (except-in rackunit fail)
         mechanics
         "../book/check.rkt")

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

(test-case "a wheel is nonholonomic, a wheel that keeps its direction is not"
  (define wheel-coordinates (up 'x 'y 'φ 'θ))
  (define (rolling t q v)
    (up (- (ref v 0) (* 'R (sin (ref q 3)) (ref v 2)))
        (- (ref v 1) (* 'R (cos (ref q 3)) (ref v 2)))))
  (define straight (nonholonomic (lambda (t q v) (- (ref v 3) 0))))
  (define (wheel-status constraints) (verdict-status (Frobenius-test constraints wheel-coordinates)))
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
  (check-same (G 't q) expected))

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

(test-case "an integral makes a holonomic constraint"
  (define rolling (form (t (x y θ) (vx vy ω)) (- vx (* 'R ω))))
  (define G (constraint-integral rolling q))
  (define (L (up t q v)) (- (* 1/2 'm (square (ref v 0))) (* -1/2 'J (square (ref v 2)))
                            (* 'F (ref q 0)) (* -1/2 (square (ref v 1)))))
  (define state (up 't q (up 'vx 'vy 'ω)))
  (check-same (ref ((constrained-accelerations L rolling) state) 0)
              (ref ((constrained-accelerations L (holonomic G)) state) 0)))

(test-case "an integral that is not found is not made up"
  (define odd (form (t (x y θ) (vx vy ω)) (+ vx (* (exp (square y)) vy))))
  (check-eq? (status odd) 'proved)
  (check-exn #rx"^constraint-integral: the constraint is integrable; its integral was not found"
             (lambda () (constraint-integral odd q))))

(test-case "coordinates are symbols"
  (check-exn #rx"^Frobenius-test: expected coordinates that are symbols other than t"
             (lambda () (Frobenius-test blade (up 1 2 3)))))
