#lang mechanics
;; Is a proposed path a motion? The verdict changes with the path's frequency and the stiffness of
;; the spring: it is proved where the square of the frequency is k/m. Below, Lagrange's equation for
;; potentials that are powers of the distance.

(provide interaction equations)

(define ((L-power m k n) (up t x v)) (- (* 1/2 m (square v)) (* k (expt x n))))

(define interaction
  (interact ([k 1 16] [omega 1 4 #:step 1/2])
    (verify-solution (L-power 'm (* 1/2 k 'm) 2) (lambda (t) (* 'A (cos (* omega t)))))))
interaction

(define equations
  (interact ([n 2 8])
    (((Lagrange-equations (L-power 'm 'k n)) (literal-function 'x)) 't)))
equations

(module+ test
  (require rackunit)
  (define (verdict k omega)
    (verify-solution (L-power 'm (* 1/2 k 'm) 2) (lambda (t) (* 'A (cos (* omega t))))))
  (test-case "it is proved where k is the square of the frequency, and refuted elsewhere"
    (for* ([k '(1 4 9 10 16)] [omega '(1 2 5/2 3 4)])
      (check-equal? (proved? (verdict k omega)) (= k (* omega omega)))
      (check-equal? (refuted? (verdict k omega)) (not (= k (* omega omega)))))))
