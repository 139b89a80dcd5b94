#lang racket/base
;; Gauss–Legendre methods of orders 2, 4 and 6: implicit, and symplectic for
;; Hamiltonian systems of any kind (Hairer, Lubich and Wanner, Geometric Numerical
;; Integration, 2nd ed. 2006, II.1.3 and VI.4).
;;
;; The slopes at s points, the zeros of a Legendre polynomial, solve
;;
;;     kᵢ = f(y + h Σⱼ aᵢⱼ kⱼ)
;;
;; and lead to y + h Σ bᵢ kᵢ (gauss-equations.rkt says how they are found).  Of order 2 it is
;; the implicit midpoint rule.

(require racket/flonum
         "gauss-equations.rkt" "shorter-step.rkt" "stepper.rkt" "vector-formulas.rkt"
         "../flvector.rkt")

(provide gauss-legendre-2 gauss-legendre-4 gauss-legendre-6)

;; b : weights; the tolerance has no effect
(define ((start A b) f! y0 [tolerance #f])
  (define n (flvector-length y0))
  (define y (flvector-copy y0))
  (define-vectors n z)
  (define q (make-equations f! y A))
  (define (try! h slope)
    (define solved? (solve-equations! q h))
    (add-slopes! q z h b)
    (if (and solved? (flvector-finite? z)) 0.0 +nan.0))
  (stepper-by-shorter-steps (start A b) f! y z try!))

(define ((implicit name order A b) h)
  (fixed-step-method name order h (start A b) #:asks 'jacobian))

(define gauss-legendre-2
  (implicit 'Gauss-Legendre-2 2 '((0.5)) '(1.0)))

(define gauss-legendre-4
  (let ([r (/ (sqrt 3.0) 6.0)])
    (implicit 'Gauss-Legendre-4 4
              (list (list 0.25 (- 0.25 r))
                    (list (+ 0.25 r) 0.25))
              '(0.5 0.5))))

(define gauss-legendre-6
  (let ([r (sqrt 15.0)])
    (implicit 'Gauss-Legendre-6 6
              (list (list (/ 5.0 36.0) (- (/ 2.0 9.0) (/ r 15.0)) (- (/ 5.0 36.0) (/ r 30.0)))
                    (list (+ (/ 5.0 36.0) (/ r 24.0)) (/ 2.0 9.0) (- (/ 5.0 36.0) (/ r 24.0)))
                    (list (+ (/ 5.0 36.0) (/ r 30.0)) (+ (/ 2.0 9.0) (/ r 15.0)) (/ 5.0 36.0)))
              (list (/ 5.0 18.0) (/ 4.0 9.0) (/ 5.0 18.0)))))
