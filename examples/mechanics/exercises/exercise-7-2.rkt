#lang mechanics
;; Exercise 7.2 (SICM 7.4.1): the width of a resonance
;; Checked: the half-width 2 √(αγε) of the island at p = αω
;; How: energies of saddle and separatrix, the library's width, and a motion

;; Near the resonance H = (Σ − αω)²/(2α) + εγ cos σ.  The saddle is at σ = 0.
(define (H sigma Sigma)
  (+ (/ (square (- Sigma (* 'alpha 'omega))) (* 2 'alpha)) (* 'epsilon 'gamma (cos sigma))))

(define (separatrix-at half-width)
  (verify-equal (H pi (+ (* 'alpha 'omega) half-width)) (H 0 (* 'alpha 'omega))))
(define right
  (assuming ('(> alpha 0) '(> gamma 0) '(> epsilon 0))
    (separatrix-at (* 2 (sqrt (* 'alpha 'gamma 'epsilon))))))
right

;; The slip: half of it, which is where the second derivative would have it.
(define slip (separatrix-at (sqrt (* 'alpha 'gamma 'epsilon))))
(verdict-status slip)

;; By the library, from the Hamiltonian with three waves
(define (rotor-and-clock (up t q (down P p))) (+ (/ (square p) (* 2 'alpha)) (* 'omega P)))
(define (waves (up t (up phi theta) p))
  (* 'epsilon
     (+ (* -1 'beta (cos theta))
        (* 'gamma (+ (cos (+ theta phi)) (cos (- theta phi)))))))
(define width
  (ref (resonance-width rotor-and-clock waves '(-1 1) (up 's (up 'phi 'theta) (down 'P 'p))) 1))
width

;; In numbers: within it σ swings, beyond it turns.
(define ((flow) (up t sigma Sigma)) (up 1 (- Sigma 5) (* 1/4 (sin sigma))))
(define (angle-after Sigma) (coordinate ((state-advancer flow) (up 0. pi Sigma) 100. 1e-10)))
(list (angle-after (+ 5 0.99)) (angle-after (+ 5 1.01)))

(module+ test
  (require rackunit)
  (test-case "energies"
    (check-pred proved? right)
    (check-pred refuted? slip))
  (test-case "the library's"
    (check-pred proved?
                (assuming ('(> alpha 0) '(> gamma 0) '(> epsilon 0))
                  (verify-equal width (* 2 (sqrt (* 'alpha 'gamma 'epsilon)))))))
  (test-case "a motion"
    (check-true (< (abs (- (angle-after 5.99) pi)) pi))
    (check-true (> (- (angle-after 6.01) pi) :2pi))))
