#lang racket/base
;; SICM 5.2, General Canonical Transformations (pp. 342–357), in the reader's own language.

(require mechanics)

(provide H-harmonic rotating C-rotating K-rotating H-arbitrary
         a-non-canonical-transform C-general C-simple-time)

(define ((H-harmonic m k) (up t x p)) ; p. 345
  (+ (/ (square p) (* 2 m))
     (* 1/2 k (square x))))

;; From coordinates in space that turn about the z axis at the rate Ω to those at rest (p. 348).
(define ((rotating Omega) (up t (up x y z) p))
  (define-values (c s) (values (cos (* Omega t)) (sin (* Omega t))))
  (up (- (* c x) (* s y))
      (+ (* s x) (* c y))
      z))

(define (C-rotating Omega) (F->CH (rotating Omega)))

;; Correction of the Hamiltonian in turning coordinates: −Ω times the angular momentum (p. 349).
(define ((K-rotating Omega) (up t (up x y z) (down p_x p_y p_z)))
  (* -1 Omega (- (* x p_y) (* y p_x))))

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

;; One whose new time depends on the old one alone (p. 354).
(define (C-simple-time state)
  (define image (C-general state))
  (up ((literal-function 'tau) (time state))
      (coordinates image)
      (momenta image)))
