#lang racket/base
;; Energies and their change along paths (SICM 1.8.1).

(require mechanics
         "../support/checks.rkt" "../support/session.rkt")

(define (T m) (lambda (local) (* 1/2 m (square (velocity local)))))
(define (V m k) (lambda (local) (* 1/2 k (square (coordinate local)))))
(define q (literal-function 'q))
(define any-L (literal-function 'L (Lagrangian)))

(test-case "a Lagrangian is the difference of kinetic and potential energy"
  (define L (make-Lagrangian (T 'm) (V 'm 'k)))
  (check-equal? (expression (simplify (L (up 't 'x 'v))))
                (expression (simplify (- (* 1/2 'm (square 'v)) (* 1/2 'k (square 'x))))))
  (define made-of-parameters (make-Lagrangian (lambda (m k) (T m)) V))
  (check-identity ((made-of-parameters 'm 'k) (up 't 'x 'v)) (L (up 't 'x 'v)))
  (check-exn #rx"^make-Lagrangian: .*an energy: a function of the local tuple"
             (lambda () (make-Lagrangian (T 'm) 'V))))

(test-case "its energy is their sum"
  (check-identity ((Lagrangian->energy (make-Lagrangian (T 'm) (V 'm 'k))) (up 't 'x 'v))
                  (((+ (lambda (m k) (T m)) V) 'm 'k) (up 't 'x 'v))))

(test-case "energy changes by the residual times the velocity and by ∂₀L, for any L and path"
  (check-identity (((Lagrangian->power-loss any-L) q) 't)
                  (- (* (((Lagrange-equations any-L) q) 't) ((D q) 't))
                     (((partial 0) any-L) ((Gamma q) 't)))))

(test-case "a drag takes twice its dissipation function"
  (define L (make-Lagrangian (T 'm) (V 'm 'k)))
  (define slope (Lagrangian->state-derivative L (Rayleigh-dissipation 'b)))
  (define state (up 't 'x 'v))
  (check-identity (* ((D (Lagrangian->energy L)) state) (slope state))
                  (* -2 ((Rayleigh-dissipation 'b) state))))

(test-case "they print with what they were made from"
  (check-equal? (format "~a" (list (Lagrangian->energy any-L) (Lagrangian->power-loss any-L)
                                   (Rayleigh-dissipation 'k)))
                "((Lagrangian->energy L) (Lagrangian->power-loss L) (Rayleigh-dissipation k))")
  (check-exn #rx"^Lagrangian->power-loss: a path is a function of time"
             (lambda () ((Lagrangian->power-loss any-L) 'q))))
