#lang mechanics
;; Is a motion near the triangle points stable beyond the linear terms?  In two degrees of freedom
;; with energies of both signs it is (Arnold 1961) unless frequencies are resonant or a determinant
;; of the normal form of degree 4 vanishes, which it does at one mass ratio.

(define ((H-restricted mu) (up t (up x y) (down p_x p_y)))
  (- (+ (* 1/2 (+ (square p_x) (square p_y))) (* y p_x) (* -1 x p_y))
     (/ (- 1 mu) (sqrt (+ (square (+ x mu)) (square y))))
     (/ mu (sqrt (+ (square (- x (- 1 mu))) (square y))))))

(define (triangle mu)
  (up 0 (up (- 1/2 mu) (/ (sqrt 3) 2)) (down (/ (sqrt 3) -2) (- 1/2 mu))))
(define state (up 't (up 'x 'y) (down 'p_x 'p_y)))

;; The linear motion: of Earth and Moon, at Routh's ratio, and beyond.
(define (linear mu) (symplectic-normal-form (H-restricted mu) state #:at (triangle mu)))
(linear 0.0121505856)
(linear 0.0385208965)
(linear 0.05)

;; The normal form; at the ratio where one frequency is twice the other, terms of degree 3 stay.
(define (form mu) (Birkhoff-normal-form (H-restricted mu) state #:at (triangle mu)))
(normal-form-frequencies (form 0.0121505856))
((series:ref (normal-form-Hamiltonian (form 0.0121505856)) 2) state)
(normal-form-resonances (form 0.024293897142052323))

;; Arnold's determinant: the terms of degree 4, functions of the actions, where those of degree 2
;; are 0.
(define (determinant mu)
  (define N (form mu))
  (define w (normal-form-frequencies N))
  (define (root k) (sqrt (* 2 (abs (ref w k)))))
  ((series:ref (normal-form-Hamiltonian N) 2) (up 0 (up (root 1) (root 0)) (down 0 0))))
(find-root determinant 0.0105 0.0113)

(module+ test
  (require rackunit)
  (test-case "the ratio of Deprit and Deprit-Bartholomé"
    (check-= (find-root determinant 0.0105 0.0113) 0.010913667677 1e-11))
  (test-case "frequencies and signs"
    (check-= (ref (normal-form-frequencies (form 0.0121505856)) 0) -0.29821 1e-5)
    (check-eq? (quadratic-normal-form-status (linear 0.0385208965)) 'undecided)
    (check-equal? (normal-form-resonances (form 0.024293897142052323)) '((2 1)))))
