#lang racket/base
;; SICM 5.2, General Canonical Transformations (pp. 342–357), in the reader's own language.

(require mechanics)

(provide H-harmonic rotating C-rotating K-rotating H-arbitrary
         a-non-canonical-transform C-general C-simple-time)

(define ((H-harmonic m k) (up t x p)) ; p. 345
  (+ (/ (square p) (* 2 m))
     (* 1/2 k (square x))))

;; Coordinates in space that turn about the z axis at the rate n (p. 348).
(define ((rotating n) (up t (up x y z) p))
  (define-values (c s) (values (cos (* n t)) (sin (* n t))))
  (up (+ (* c x) (* s y))
      (- (* c y) (* s x))
      z))

(define (C-rotating n) (F->CH (rotating n)))

;; What the Hamiltonian gets in turning coordinates.
(define ((K-rotating n) (up t (up x y z) (down p_x p_y p_z)))
  (* n (- (* x p_y) (* y p_x))))

;; Any Hamiltonian in space (p. 348).
(define H-arbitrary
  (literal-function 'H (-> (UP Real (UP Real Real Real) (DOWN Real Real Real)) Real)))

;; Like polar coordinates, but not canonical (p. 352).
(define (a-non-canonical-transform (up t theta p))
  (up t (* p (sin theta)) (* p (cos theta))))

;; Any transformation of a state with two coordinates (p. 354).
(define C-general
  (literal-function 'C (-> (UP Real (UP Real Real) (DOWN Real Real))
                           (UP Real (UP Real Real) (DOWN Real Real)))))

;; One that leaves the time alone (p. 354).
(define (C-simple-time state)
  (define (component-of name) (literal-function name (Hamiltonian 2)))
  (up (time state)
      (up ((component-of 'q_x) state) ((component-of 'q_y) state))
      (down ((component-of 'p_x) state) ((component-of 'p_y) state))))
