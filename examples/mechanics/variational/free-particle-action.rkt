#lang mechanics
;; The action of a free particle along a straight path, and along nearby paths
;; with the same ends (SICM 1.4, pp. 17–19).
;;
;; The straight path has action 435.  Adding ε t (t − 10) (sin t, cos t, t²) to it
;; adds a multiple of ε²: the straight path has the least action of its family.

(define ((L-free-particle mass) local)
  (* 1/2 mass (square (velocity local))))

(define (test-path t)
  (up (+ (* 4 t) 7) (+ (* 3 t) 5) (+ (* 2 t) 1)))

;; ν(t) made to vanish at both ends.
(define ((make-eta nu t1 t2) t)
  (* (- t t1) (- t t2) (nu t)))

(define ((varied-action mass q nu t1 t2) epsilon)
  (define eta (make-eta nu t1 t2))
  (Lagrangian-action (L-free-particle mass) (+ q (* epsilon eta)) t1 t2))

(define action (varied-action 3 test-path (up sin cos square) 0 10))

(action 0)
(action 0.001)
(minimize action -2.0 1.0)

(module+ test
  (require rackunit)
  (test-case "the straight path has action 435"
    (check-equal? (action 0) 435.0))
  (test-case "the action of the varied path is 435 + 18077/14000"
    (check-within (action 0.001) (+ 435 18077/14000) 1e-9))
  (test-case "the action of the family is least at the straight path"
    (define found (minimize action -2.0 1.0))
    (check-within (car found) 0.0 1e-6)
    (check-within (cadr found) 435.0 1e-9)))
