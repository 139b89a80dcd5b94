#lang mechanics
;; A file that is read like a session: a path is replaced by another, and the
;; library's action by a rougher one, which takes symbols.

(define (test-path t) (up (* 4 t) (* 3 t)))
(define (speed t) (sqrt (square ((D test-path) t))))
(speed 't)

(define (test-path t) (up (* 5 t) (* 12 t)))
(speed 't)

(define ((L-free-particle m) (up t q v)) (* 1/2 m (square v)))
(define (test-action m) (Lagrangian-action (L-free-particle m) test-path 0 10))
(test-action 2.0)

(define (Lagrangian-action L q t1 t2)
  (* (- t2 t1) (L ((Gamma q) (/ (+ t1 t2) 2)))))
(test-action 'm)

(module+ test
  (require rackunit)
  (test-case "functions that were defined before see the last definitions"
    (check-equal? (speed 1) 13)
    (check-equal? (expression (simplify (test-action 'm))) '(* 845 m))))
