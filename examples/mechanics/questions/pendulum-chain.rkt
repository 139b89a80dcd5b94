#lang mechanics
;; Pendulums that hang from each other: their normal modes.

;; Equal masses m and rods of length l; the angles from the vertical are an up tuple.
(define ((L-chain m l g) (up t angles rates))
  (define (sums terms)                  ; from the first to each
    (let next ([terms terms] [sum 0])
      (if (null? terms)
          '()
          (cons (+ sum (car terms)) (next (cdr terms) (+ sum (car terms)))))))
  (define-values (as ws) (values (structure->list angles) (structure->list rates)))
  (define (each f) (sums (map f as ws)))
  (for/sum ([vx (each (lambda (a w) (* l w (cos a))))]
            [vy (each (lambda (a w) (* l w (sin a))))]
            [y (each (lambda (a w) (* -1 l (cos a))))])
    (- (* 1/2 m (+ (square vx) (square vy))) (* m g y))))

(define double (up 't (up 'a 'b) (up 'adot 'bdot)))
(equilibria (L-chain 'm 'l 'g) double)
(normal-modes (L-chain 'm 'l 'g) (up 0 0))

;; Three of them, by numbers but for the common factor.
(normal-modes (L-chain 'm 'l 'g) (up 0 0 0))
(assuming ('(> m 0) '(> l 0) '(> g 0))
  (equilibrium-stability (L-chain 'm 'l 'g) (up 0 ':pi 0)))

(module+ test
  (require rackunit)
  (test-case "two: ω² = (2 ± √2) g/l"
    (check-equal? (map expression (small-oscillation-frequencies (L-chain 'm 'l 'g) (up 0 0)))
                  '((sqrt (/ (* g (- 2 (sqrt 2))) l)) (sqrt (/ (* g (+ 2 (sqrt 2))) l)))))
  (test-case "three: ω² l/g are the zeros of Laguerre's polynomial, x³ − 9x² + 18x − 6"
    (for ([omega (small-oscillation-frequencies (L-chain 1.0 1.0 1.0) (up 0.0 0.0 0.0))])
      (define x (square omega))
      (check-= (+ (cube x) (* -9 (square x)) (* 18 x) -6) 0 1e-11)))
  (test-case "hanging is stable, and no other way is"
    (define (kind . angles)
      (stability-kind (equilibrium-stability (L-chain 1 1 10) (apply up angles))))
    (check-eq? (kind 0 0 0) 'stable)
    (check-eq? (kind 0 pi 0) 'unstable)))
