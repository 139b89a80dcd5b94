#lang mechanics
;; Exercise 5.11 (SICM 5.4.4): circular orbits in steep fields
;; Checked: for which force laws circular orbits are stable
;; How: the second derivative of the Hamiltonian by the radius, for any exponent; two orbits

;; A force −k r^(1−n) has V = k r^(2−n)/(2 − n). In r and p_r, at the angular momentum of a
;; circular orbit of radius R, the second derivative of H by r is m Ω² (4 − n).

(define ((radial n L m k) state)
  (define-values (r p) (values (coordinate state) (momentum state)))
  (+ (/ (square p) (* 2 m))
     (/ (square L) (* 2 m (square r)))
     (/ (* k (expt r (- 2 n))) (- 2 n))))

;; L² = m k R^(4−n), and Ω = L/(m R²).
(define L (sqrt (* 'm 'k (expt 'R (- 4 'n)))))
(define H (radial 'n L 'm 'k))
(define circle (up 't 'R 0))
(define at-rest (verify-equal (((partial 1) H) circle) 0))
at-rest
(define Omega (/ L (* 'm (square 'R))))
(define right
  (verify-equal (((partial 1) ((partial 1) H)) circle) (* 'm (square Omega) (- 4 'n))))
right

;; So circular orbits are stable for n < 4: there H has a minimum. Beyond it is a saddle: for n = 5
;; what starts inside by a thousandth falls in, what starts outside goes away. Areas are kept all
;; the same: what is drawn out in r is pressed together in p_r.
(define (later n start time)
  ((state-advancer Hamiltonian->state-derivative (radial n 1 1 1)) (up 0 start 0) time 1e-10))
(define falling (coordinate (later 5 0.999 6.3)))
(define leaving (coordinate (later 5 1.001 6.3)))
(define staying (coordinate (later 3 0.999 6.3)))
(list (< falling 1/2) (> leaving 11/10) (< (abs (- staying 1)) 0.002))

;; The slip: that the force law decides by whether it is attracting.
(define slip (verify-equal (((partial 1) ((partial 1) H)) circle) (* 'm (square Omega))))
(verdict-status slip)

(module+ test
  (require rackunit)
  (test-case "stable below the exponent 4"
    (check-pred proved? at-rest)
    (check-pred proved? right)
    (check-true (< falling 1/2))
    (check-true (> leaving 11/10))
    (check-= staying 1 0.002))
  (test-case "attraction alone is not enough"
    (check-pred refuted? slip)))
