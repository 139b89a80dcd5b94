#lang mechanics
;; Is a cos(ωt + φ) a motion of the harmonic oscillator?  (SICM 1.5, p. 36)
;;
;; The residual a (k − m ω²) cos(ωt + φ) is not zero in general, and its core says
;; when it is: for k = m ω².

(define ((L-harmonic m k) (up t q v))
  (- (* 1/2 m (square v)) (* 1/2 k (square q))))

(define (proposed-solution t)
  (* 'a (cos (+ (* 'omega t) 'phi))))

(define residual
  (((Lagrange-equations (L-harmonic 'm 'k)) proposed-solution) 't))

residual
(prove-zero residual)
(prove-zero (substitute residual 'k (* 'm (expt 'omega 2))))

(module+ test
  (require rackunit)
  (define verdict (prove-zero residual))
  (test-case "the residual shows its factors"
    (check-equal? (expression (simplify residual))
                  '(* a (- k (* m (expt omega 2))) (cos (+ (* omega t) phi)))))
  (test-case "the proposed solution is refuted at a frequency of its own"
    (check-eq? (verdict-status verdict) 'refuted))
  (test-case "the witness is a point where the residual does not vanish"
    (check-false (zero? (verdict-value verdict))))
  (test-case "the verdict names the condition k = m ω²"
    (check-equal? (map expression (verdict-conditions verdict))
                  '((= k (* m (expt omega 2))))))
  (test-case "the condition makes it a solution"
    (check-eq? (verdict-status (prove-zero (substitute residual 'k (* 'm (expt 'omega 2)))))
               'proved)))
