#lang mechanics
;; A free particle moves in a straight line (SICM 1.5, p. 35).
;;
;; The residual of Lagrange's equations vanishes for a proposed straight path;
;; for a literal path it is the equation of motion itself.

(define ((L-free-particle mass) local)
  (* 1/2 mass (square (velocity local))))

(define (straight-path t)
  (up (+ (* 'a t) 'a0) (+ (* 'b t) 'b0) (+ (* 'c t) 'c0)))

(((Lagrange-equations (L-free-particle 'm)) straight-path) 't)
(((Lagrange-equations (L-free-particle 'm)) (literal-function 'x)) 't)
(verify-solution (L-free-particle 'm) straight-path)

(module+ test
  (require rackunit)
  (test-case "the straight line is a solution"
    (define verdict (verify-solution (L-free-particle 'm) straight-path))
    (check-eq? (verdict-status verdict) 'proved)
    (check-equal? (verdict-residual verdict) (down 0 0 0)))
  (test-case "a literal path gives mass times acceleration"
    (check-equal? (expression
                   (simplify
                    (((Lagrange-equations (L-free-particle 'm)) (literal-function 'x)) 't)))
                  '(* m (((expt D 2) x) t))))
  (test-case "a parabola is refuted"
    (define (parabola t) (up (square t) 0 0))
    (check-eq? (verdict-status (verify-solution (L-free-particle 'm) parabola)) 'refuted)))
