#lang racket/base
;; Forces in coordinates: known ones, in all the shapes that positions have.

(require mechanics
         "../support/checks.rkt" "../support/forces.rkt" "../support/session.rkt")

(define swinging (up 't 'theta 'thetadot))
(define turning (up 't (up 'r 'theta) (up 'rdot 'thetadot)))

(test-case "gravity on a pendulum, as a force and as a potential"
  (define (V t r) (* 'm 'g (ref r 1)))
  (define expected (* -1 'm 'g 'l (sin 'theta)))
  (check-identity ((generalized-force (pendulum 'l) (weight 'm 'g)) swinging) expected)
  (check-identity ((generalized-force (pendulum 'l) (potential->force V)) swinging) expected))

(test-case "drag in polar coordinates"
  (check-identity ((generalized-force polar (drag 'b)) turning)
                  (down (* -1 'b 'rdot) (* -1 'b (square 'r) 'thetadot))))

(test-case "the force of an angle is a torque"
  (define (F t r v) (up 'F_x 'F_y))
  (define at (polar 't (up 'r 'theta)))
  (check-identity (ref ((generalized-force polar F) turning) 1)
                  (- (* (ref at 0) 'F_y) (* (ref at 1) 'F_x)))
  ;; a wheel on an axle: its position is its angle
  (check-identity ((generalized-force (lambda (t q) (/ q 'n)) (lambda (t angle rate) 'tau))
                   (up 't 'q 'v))
                  (/ 'tau 'n)))

(test-case "a wheel that rolls has a place and an angle, with a mass and a moment of inertia"
  (define (wheel t x) (up (up x 'R) (/ x 'R)))
  (check-identity ((kinetic-energy '(m I) wheel) (up 't 'x 'v))
                  (* 1/2 (+ 'm (/ 'I (square 'R))) (square 'v)))
  (check-identity ((generalized-force wheel (lambda (t r v) (up (up 'F 0) 'tau))) (up 't 'x 'v))
                  (+ 'F (/ 'tau 'R))))

(test-case "positions that move do so in velocities, not in displacements"
  (define (cart t x) (up (+ x (* 1/2 'a (square t))) 0))
  (check-identity ((particle-velocities cart) (up 't 'x 'v)) (up (+ 'v (* 'a 't)) 0))
  (check-identity ((virtual-displacement cart) (up 't 'x 'v) 'dx) (up 'dx 0))
  (check-identity ((generalized-force cart (drag 'b)) (up 't 'x 'v)) (* -1 'b (+ 'v (* 'a 't)))))

(test-case "generalized forces do the work of the forces in virtual displacements"
  (define state (up 't (up 'a 'b) (up 'v_a 'v_b)))
  (define dq (up 'da 'db))
  (define dr ((virtual-displacement positions-2) state dq))
  (define r (positions-2 't (up 'a 'b)))
  (define v ((particle-velocities positions-2) state))
  (check-identity (* ((generalized-force positions-2 force-on-two) state) dq)
                  (dot-product (force-on-two 't r v) dr)))

(test-case "0 is no force, on one particle or all"
  (define (two t q) (up (up q 0) (up 0 (* 2 q))))
  (check-identity ((generalized-force two (lambda (t r v) 0)) (up 't 'q 'v)) 0)
  (check-identity ((generalized-force polar (lambda (t r v) 0)) turning) (down 0 0))
  (check-identity ((generalized-force two (lambda (t r v) (up 0 (up 0 'F)))) (up 't 'q 'v))
                  (* 2 'F)))

(test-case "particles on a line have scalars for positions"
  (define (atwood t x) (up x (- 'l x)))
  (check-identity ((kinetic-energy '(m_1 m_2) atwood) (up 't 'x 'v))
                  (* 1/2 (+ 'm_1 'm_2) (square 'v)))
  (check-identity (((d-Alembert-equations '(m_1 m_2) atwood
                                          (lambda (t r v) (up (* 'm_1 'g) (* 'm_2 'g))))
                    (literal-function 'x)) 't)
                  (- (* (+ 'm_1 'm_2) (((expt D 2) (literal-function 'x)) 't))
                     (* (- 'm_1 'm_2) 'g)))
  (check-identity ((kinetic-energy 'm (lambda (t x) x)) (up 't 'x 'v)) (* 1/2 'm (square 'v))))

(test-case "coordinates may be tuples of tuples"
  (define (chain t q) (up (ref q 0) (+ (ref q 0) (ref q 1))))
  (define state (up 't (up (up 'x 'y) (up 'u 'w)) (up (up 'vx 'vy) (up 'vu 'vw))))
  (define (F t r v) (up (up 'X 'Y) (up 'U 'W)))
  (check-identity ((generalized-force chain F) state)
                  (down (down (+ 'X 'U) (+ 'Y 'W)) (down 'U 'W)))
  (check-identity ((kinetic-energy '(m_1 m_2) chain) state)
                  (+ (* 1/2 'm_1 (+ (square 'vx) (square 'vy)))
                     (* 1/2 'm_2 (+ (square (+ 'vx 'vu)) (square (+ 'vy 'vw)))))))

(test-case "Racket vectors are up tuples"
  (define (plane t q) (vector (ref q 0) (ref q 1)))
  (define state (vector 't (vector 'x 'y) (vector 'u 'w)))
  (check-identity ((kinetic-energy 'm plane) state) (* 1/2 'm (+ (square 'u) (square 'w))))
  (check-identity ((generalized-force plane (lambda (t r v) (vector 'X 'Y))) state) (down 'X 'Y)))

(test-case "forces are added as functions, and one that depends on all is used as it is"
  (define both (+ (weight 'm 'g) (drag 'b)))
  (check-identity ((generalized-force (pendulum 'l) both) swinging)
                  (+ (* -1 'm 'g 'l (sin 'theta)) (* -1 'b (square 'l) 'thetadot)))
  (define (spring t r v) (* (cos t) (- (up 'a 'b) r)))
  (check-identity ((generalized-force polar spring) turning)
                  (* (cos 't) (down (- (+ (* 'a (cos 'theta)) (* 'b (sin 'theta))) 'r)
                                    (* 'r (- (* 'b (cos 'theta)) (* 'a (sin 'theta))))))))

(test-case "equilibrium is where no virtual displacement takes work"
  (define seesaw-work
    ((static-equilibrium (lambda (t q) (up (* -1 'a (sin q)) (* 'b (sin q))))
                         (lambda (t r v) (up (* -1 'W_a) (* -1 'W_b))))
     't 'q))
  (check-identity seesaw-work (* (cos 'q) (- (* 'a 'W_a) (* 'b 'W_b))))
  (test-case "a drag does none at rest"
    (check-identity ((static-equilibrium polar (drag 'b)) 't (up 'r 'theta)) (down 0 0))))

(test-case "numbers go through in flonums"
  (check-= (car (structure->list ((generalized-force polar (drag 2.0))
                                  (up 0.0 (up 3.0 0.5) (up 0.25 1.0)))))
           -0.5 1e-15))

(test-case "they print with what they were made from"
  (define-values (r F) (values (pendulum 'l) (weight 'm 'g)))
  (check-equal? (format "~a" (list (kinetic-energy 'm r) (kinetic-energy '(m M) r)
                                   (generalized-force r F) (virtual-displacement r)
                                   (particle-velocities r) (static-equilibrium r F)
                                   (d-Alembert-equations 'm r F)
                                   ((d-Alembert-equations 'm r F) (literal-function 'q))
                                   (potential->force (lambda (t r) 0))))
                (string-append
                 "((kinetic-energy m pendulum) (kinetic-energy (list m M) pendulum) "
                 "(generalized-force pendulum weight) (virtual-displacement pendulum) "
                 "(particle-velocities pendulum) (static-equilibrium pendulum weight) "
                 "(d-Alembert-equations m pendulum weight) "
                 "((d-Alembert-equations m pendulum weight) q) (potential->force <function>))")))

(test-case "0 is no force, on all particles or on one"
  (define plane (up 't (up 'x 'y) (up 'v_x 'v_y)))
  (define (two t q) (up q (* 2 q)))
  (define ((force value) t r v) value)
  (check-equal? ((generalized-force two (force 0)) plane) (down 0 0))
  (check-equal? ((generalized-force two (force (up 0 (up 'X 'Y)))) plane)
                (down (* 2 'X) (* 2 'Y))))
