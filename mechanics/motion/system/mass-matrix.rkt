#lang racket/base
;; Derivatives of momenta in a program of t, q and v.
;;
;; A sweep forwards gives the derivatives of all values in one direction: in the direction
;; (1, v, 0) their rates, but for the accelerations; in that of each velocity, those of the
;; momenta are a column of the mass matrix.

(require "../../compile/program.rkt" "../../compile/derivative-sweep.rkt")

(provide known-rates mass-matrix)

;; b : a builder reloaded with p
;; xs : vector of operands -> (one of them ↦ its rate)
(define (known-rates b p xs)
  (define inputs (program-inputs p))
  (define n (quotient (- inputs 1) 2))
  (define last (last-dependent p xs))
  (derivative-along b p
                    (lambda (k) (cond [(= k 0) 1] [(<= k n) (place (+ n k))] [else 0]))
                    (lambda (k) (>= (vector-ref last k) 0))))

;; direction : input index -> operand; wanted? : place index -> does the derivative of what is
;; there matter?  -> (operand ↦ its derivative in that direction)
(define (derivative-along b p direction wanted?)
  (define tangents
    (sweep-forward! b p (build-vector (program-inputs p) direction) wanted?))
  (lambda (x) (if (place? x) (vector-ref tangents (place-index x)) 0)))

;; momenta : vector of operands -> (i j ↦ entry), half of which are enough
(define (mass-matrix b p momenta)
  (define n (vector-length momenta))
  (define last (last-dependent p momenta))
  (define columns
    (for/vector #:length n ([j (in-range n)])
      (derivative-along b p
                        (lambda (k) (if (= k (+ 1 n j)) 1 0))
                        (lambda (k) (>= (vector-ref last k) j)))))
  (lambda (i j) ((vector-ref columns (min i j)) (vector-ref momenta (max i j)))))
