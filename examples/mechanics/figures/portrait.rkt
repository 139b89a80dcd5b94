#lang mechanics
;; The phase plane of the tilt of a top, for the figures of section 3.4.
;;
;; With the momenta of φ and ψ given, θ and p_θ move on the contours of the Hamiltonian.  Where
;; the two momenta are equal it has no pole at θ = 0, and θ may have both signs.

(require mechanics/plot mechanics/book)

(provide top-portrait top-Hamiltonian spin)

;; A and C in kg m², gMR in kg m² / s²
(define-values (A C gMR) (values 6.96e-4 1.32e-4 0.112))

;; The momentum of a top that turns upright at this rate.
(define (spin omega) (* C omega))

;; θ, p_θ ↦ H
(define (top-Hamiltonian p-phi p-psi)
  (define H (Lagrangian->Hamiltonian (L-axisymmetric-top A C gMR)))
  (define (upright theta p)
    (+ (/ (square p) (* 2 A))
       (/ (square p-psi) (* 2 C))
       (/ (square (* p-psi (tan (/ theta 2)))) (* 2 A))
       (* gMR (cos theta))))
  (if (= p-phi p-psi)
      upright
      (lambda (theta p) (H (up 0. (up theta 0. 0.) (down p p-phi p-psi))))))

;; thetas : a contour for each passes through (θ, 0)
(define (top-portrait p-phi p-psi low high p-max thetas)
  (define H (top-Hamiltonian p-phi p-psi))
  (define picture (frame low high (- p-max) p-max #:x-label "θ" #:y-label "p_θ"))
  (plot-contours picture H (for/list ([theta thetas]) (H theta 0.)) #:samples 161)
  picture)
