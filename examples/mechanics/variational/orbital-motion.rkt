#lang mechanics
;; Motion about a fixed center of gravitation (SICM 1.5, exercise 1.11).
;;
;; A circular orbit solves the equations exactly when m ω² R³ = μ, which is
;; Kepler's third law.

(define ((L-orbital m mu) (up t (up x y) (up vx vy)))
  (+ (* 1/2 m (+ (square vx) (square vy)))
     (/ mu (sqrt (+ (square x) (square y))))))

(define (circular-orbit t)
  (up (* 'R (cos (* 'omega t))) (* 'R (sin (* 'omega t)))))

(define literal-path (up (literal-function 'x) (literal-function 'y)))

(((Lagrange-equations (L-orbital 'm 'mu)) literal-path) 't)
(verify-solution (L-orbital 'm 'mu) circular-orbit)
(define kepler-mu (* 'm (square 'omega) (cube 'R)))
(verify-solution (L-orbital 'm kepler-mu) circular-orbit)

(module+ test
  (require rackunit)
  (define verdict (verify-solution (L-orbital 'm 'mu) circular-orbit))
  (test-case "a circular orbit of any period is refuted"
    (check-eq? (verdict-status verdict) 'refuted))
  (test-case "both components vanish under Kepler's third law"
    (check-equal? (map expression (verdict-conditions verdict))
                  '((= mu (* (expt R 3) m (expt omega 2))))))
  (test-case "Kepler's third law makes it a solution, for R ≥ 0"
    (define kept (verify-solution (L-orbital 'm kepler-mu) circular-orbit))
    (check-eq? (verdict-status kept) 'proved)
    (check-equal? (verdict-assumptions kept) '((>= R 0))))
  (test-case "the equations are Newton's, with an inverse-square force"
    (define (component q other)
      (+ (* 'm (((expt D 2) (literal-function q)) 't))
         (/ (* 'mu ((literal-function q) 't))
            (expt (+ (square ((literal-function q) 't)) (square ((literal-function other) 't)))
                  3/2))))
    (check-eq? (verdict-status
                (verify-equal (((Lagrange-equations (L-orbital 'm 'mu)) literal-path) 't)
                              (down (component 'x 'y) (component 'y 'x))))
               'proved)))
