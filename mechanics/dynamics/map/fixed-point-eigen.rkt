#lang racket/base
;; Multipliers and directions of a map at a fixed point, with the convention of scmutils
;; (SICM 4.3, p. 308).

(require "jacobian.rkt" "map-of-the-plane.rkt"
         "../../error/complain.rkt"
         "../../generic/describe.rkt" "../../generic/function.rkt"
         "../../generic/number-argument.rkt")

(provide fixed-point-eigen)

;; continue : takes a multiplier, its direction x, y, the other multiplier, its direction x, y
;; eps      : the greatest step of finite differences, for maps without derivatives
(define (fixed-point-eigen map xe ye eps continue)
  (define who 'fixed-point-eigen)
  (check-map who map)
  (define-values (x y step)
    (values (finite-number who xe) (finite-number who ye) (finite-number who eps)))
  (unless (and (procedure? continue) (accepts? continue 6))
    (complain who "expected a procedure of two multipliers, each with a direction~a\n  given: ~a"
              ": (lambda (A dx dy B dx dy) ...)" (describe-with-value continue)))
  (define J (map-jacobian who map x y (max (abs step) 1e-4)))
  (define-values (A B) (eigenvalues J))
  (define-values (ax ay) (eigenvector J A))
  (define-values (bx by) (eigenvector J B #f))
  (continue A ax ay B bx by))
