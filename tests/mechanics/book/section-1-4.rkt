#lang racket/base
;; SICM 1.4, Computing Actions (pp. 14-23).

(require mechanics rackunit "check.rkt")

(define ((L-free-particle mass) local)
  (let ((v (velocity local)))
    (* 1/2 mass (dot-product v v))))

(define q (up (literal-function 'x) (literal-function 'y) (literal-function 'z)))

(define (test-path t)
  (up (+ (* 4 t) 7) (+ (* 3 t) 5) (+ (* 2 t) 1)))

(test-case "p. 15: a literal path, its derivative, its local tuple"
  (check-unsimplified (q 't) '(up (x t) (y t) (z t)))
  (check-unsimplified ((D q) 't) '(up ((D x) t) ((D y) t) ((D z) t)))
  (check-unsimplified ((Gamma q) 't)
                      '(up t (up (x t) (y t) (z t)) (up ((D x) t) ((D y) t) ((D z) t)))))

(test-case "p. 16: the Lagrangian along the path"
  (check-prints ((compose (L-free-particle 'm) (Gamma q)) 't)
                '(* 1/2 m (+ (expt ((D x) t) 2) (expt ((D y) t) 2) (expt ((D z) t) 2)))))

(test-case "p. 18: the action of a straight path"
  (check-= (Lagrangian-action (L-free-particle 3.0) test-path 0.0 10.0) 435.0 1e-10))

(define ((varied-action mass q nu t1 t2) epsilon)
  (let ((eta (make-eta nu t1 t2)))
    (Lagrangian-action (L-free-particle mass) (+ q (* epsilon eta)) t1 t2)))

(test-case "p. 18: the action of a varied path is greater"
  (check-= ((varied-action 3.0 test-path (up sin cos square) 0.0 10.0) 0.001)
           436.2912142857153 1e-9))

(test-case "p. 19: and least where there is no variation"
  (define result (minimize (varied-action 3.0 test-path (up sin cos square) 0.0 10.0) -2.0 1.0))
  (check-= (car result) 0.0 1e-5)
  (check-= (cadr result) 435.0 1e-9))

(test-case "p. 20: a path through given points"
  (check-prints ((make-path 0 'a 2 'c '(b)) 1) 'b))
