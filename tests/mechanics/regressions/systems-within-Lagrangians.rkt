#lang racket/base
;; The rates of a Lagrangian of six coordinates or more that holds a system of equations, as an
;; inverse matrix, whose entries vary: the sweep forwards knew no derivatives of systems, and failed
;; with a contract of our own.

(require racket/flonum
         (except-in rackunit fail)
         mechanics
         (only-in mechanics/motion/system/Lagrangian-code Lagrangian-code)
         (only-in mechanics/value/shape structure->flvector))

(define n 6)

(define (L local)
  (define-values (q v) (values (coordinate local) (velocity local)))
  (define (entry i j) (if (= i j) (+ 3 (square (ref q i))) (* (ref q i) (ref q j))))
  (define m
    (apply matrix-by-rows (for/list ([i (in-range n)]) (for/list ([j (in-range n)]) (entry i j)))))
  (* 1/2 (dot-product v (* (/ 1 m) v))))

(define state (up 0.0 (up 0.1 0.2 0.3 0.4 0.5 0.6) (up 0.1 0.0 0.2 0.0 0.1 0.3)))

(test-case "are those of the equations"
  (define derivative (Lagrangian->state-derivative L))
  (define code (Lagrangian-code 'test derivative state))
  (define (flonums s) (structure->flvector s values))
  (for ([x (in-flvector (code (flonums state)))] [y (in-flvector (flonums (derivative state)))])
    (check-= x y 1e-12)))
