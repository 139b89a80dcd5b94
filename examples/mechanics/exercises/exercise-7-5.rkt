#lang mechanics
;; Exercise 7.5 (SICM 7.6): spin and orbit
;; Checked: middles and widths of three resonances, their overlap, the Moon's forced oscillation
;; How: read off the Hamiltonian, and against the section of the rotation

;; (7.89), with the mean anomaly φ = nt as an angle; ε is the out-of-roundness, e the eccentricity.
(define (rotor-and-clock (up t q (down P p))) (+ (/ (square p) (* 2 'C)) (* 'n P)))
(define (torque (up t (up phi theta) p))
  (define (wave k) (cos (- (* 2 theta) (* k phi))))
  (* -1/4 (square 'n) (square 'epsilon) 'C
     (+ (wave 2) (* 7/2 'e (wave 3)) (* -1/2 'e (wave 1)))))
(define state (up 's (up 'phi 'theta) (down 'P 'p)))

;; a. Middles and half-widths
(define resonances '((-2 2) (-3 2) (-1 2)))
(define (middle k) (resonance-center rotor-and-clock k state 1))
(define (half-width k)
  (assuming ('(> C 0) '(> n 0) '(> epsilon 0) '(> e 0))
    (simplify (ref (resonance-width rotor-and-clock torque k state) 1))))
(for ([k resonances]) (print-expression (up (middle k) (half-width k))))

;; The synchronous one and 3:2 overlap from ε = 1/(2 + √(14e)) on.
(define room (- (middle '(-3 2)) (middle '(-2 2)) (half-width '(-3 2)) (half-width '(-2 2))))
(define touching
  (assuming ('(> C 0) '(> n 0) '(> e 0))
    (verify-equal (substitute room 'epsilon (/ 1 (+ 2 (sqrt (* 14 'e))))) 0)))
touching
;; The slip: whole widths in place of halves.
(define slip
  (prove-zero (substitute room 'epsilon (/ 1 (* 2 (+ 2 (sqrt (* 14 'e))))))))
(verdict-status slip)

;; b. The synchronous wave kept, the others removed: where the state of rest is, at pericenter
(define P
  (perturbation-series rotor-and-clock torque state #:keep '((-2 2)) #:parameter 1))
(define told
  (ref ((perturbation-transformation P) (up 0 (up 0 0) (down 0 (* 'C 'n)))) 2 1))
(define offset (verify-equal told (* 'C 'n (- 1 (* 2 (square 'epsilon) 'e)))))
offset

;; Against the rotation itself, C = n = 1
(define-values (epsilon e) (values 0.1 0.05))
(define ((rotation) (up t theta p))
  (define (wave k) (sin (- (* 2 theta) (* k t))))
  (up 1 p (* -1/2 (square epsilon) (+ (wave 2) (* 7/2 e (wave 3)) (* -1/2 e (wave 1))))))
(define later (stroboscopic-map (rotation) :2pi #:tolerance 1e-11))
(define (section theta p return fail)
  (define s (later (up 0. theta p)))
  (return ((principal-value :pi) (coordinate s)) (momentum s)))
(define rest (find-fixed-point section (up 0. 1.)))
(fixed-point-coordinates rest)

(module+ test
  (require rackunit)
  (test-case "middles and widths"
    (for ([k resonances] [p '(1 3/2 1/2)])
      (check-pred proved? (verify-equal (middle k) (* p 'C 'n))))
    (for ([k resonances] [w (list 1 (sqrt (* 7/2 'e)) (sqrt (* 1/2 'e)))])
      (check-pred proved?
                  (assuming ('(> C 0) '(> n 0) '(> epsilon 0) '(> e 0))
                    (verify-equal (half-width k) (* w 'epsilon 'C 'n))))))
  (test-case "overlap"
    (check-pred proved? touching)
    (check-false (proved? slip)))
  (test-case "the state of rest is where the theory has it, to a twentieth of its offset"
    (check-pred proved? offset)
    (check-equal? (fixed-point-kind rest) 'elliptic)
    (check-= (- 1 (ref (fixed-point-coordinates rest) 1)) (* 2 (square epsilon) e) 5e-5))
  (test-case "the synchronous island is as high as told, to a hundredth"
    (define (swings? p)
      (for/fold ([theta 0.] [p p] [most 0.] #:result (< most (/ pi 2))) ([j 200])
        (define s (later (up 0. theta p)))
        (define next (- (coordinate s) :2pi))
        (values next (momentum s) (max most (abs next)))))
    (check-true (swings? (+ 1 -0.001 0.098)))
    (check-false (swings? (+ 1 -0.001 0.102)))))
