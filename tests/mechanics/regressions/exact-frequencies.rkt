#lang racket/base
;; Frequencies of exact numbers were flonums, those of symbols exact; and coordinates some
;; units in the last place away from pi were proved to be an equilibrium.

(require mechanics "../support/checks.rkt")

(define (shown x) (format "~a" x))
(define (frequencies L q) (for/list ([w (small-oscillation-frequencies L q)]) (shown w)))

;; Two masses between three springs, side ones of stiffness k, the middle one of c.
(define ((L-coupled m k c) s)
  (define-values (x y) (values (ref (coordinate s) 0) (ref (coordinate s) 1)))
  (- (* 1/2 m (square (velocity s)))
     (* 1/2 (+ (* k (square x)) (* k (square y)) (* c (square (- x y)))))))

(define ((L-magnetic B k) s)
  (define-values (q v) (values (coordinate s) (velocity s)))
  (+ (* 1/2 (square v))
     (* B (- (* (ref q 0) (ref v 1)) (* (ref q 1) (ref v 0))))
     (* -1/2 k (square q))))

(test-case "frequencies of exact numbers are exact"
  (check-equal? (frequencies (L-coupled 1 1 1) (up 0 0)) '("1" "(sqrt 3)"))
  (check-equal? (frequencies (L-coupled 2 1 3) (up 0 0)) '("(* 1/2 (sqrt 2))" "(* 1/2 (sqrt 14))"))
  (check-equal? (frequencies (L-magnetic 1 1) (up 0 0)) '("(- (sqrt 2) 1)" "(+ 1 (sqrt 2))"))
  (check-equal? (shown (normal-modes (L-magnetic 2 -1) (up 0 0)))
                (string-append "((up (- 2 (sqrt 3)) (up 1 0+1i))"
                               " (up (+ 2 (sqrt 3)) (up 1 0+1i)))")))

(test-case "those of decimals are decimal"
  (check-true (andmap flonum? (small-oscillation-frequencies (L-coupled 1.0 1 1) (up 0 0)))))

(test-case "slow ones before fast ones, though they are parted"
  (define (L s)
    (define q (coordinate s))
    (- (* 1/2 (square (velocity s)))
       (* 1/2 (+ (* 5 (square (ref q 0))) (* 2 (square (ref q 1))) (* 3 (square (ref q 2)))))))
  (check-equal? (frequencies L (up 0 0 0)) '("(sqrt 2)" "(sqrt 3)" "(sqrt 5)")))

(define-syntax-rule (check-root [u value ...] ...)
  (begin (check-equal? (simplify (sqrt u)) (simplify value ...)) ...))

(define (root n) (/ (sqrt (* n (square 'x))) 'x))   ; exact, where x is positive

(test-case "roots of numbers with roots are sums of roots where they can be"
  (assuming ('(> x 0))
    (check-root [(+ 3 (* 2 (root 2))) (+ 1 (root 2))]
                [(- 3 (* 2 (root 2))) (- (root 2) 1)]
                [(- (* 2 (root 2)) 3) (* +i (- (root 2) 1))]
                [(+ 5 (* 2 (root 6))) (+ (root 2) (root 3))]
                [(* 'x (square 'x) (- 7 (* 4 (root 3)))) (* 'x (sqrt 'x) (- 2 (root 3)))])
    (check-equal? (shown (simplify (sqrt (+ 1 (root 2))))) "(sqrt (+ 1 (sqrt 2)))")
    (check-true (proved? (prove-zero (- (sqrt (+ 4 (* 2 (root 3)))) (root 3) 1))))
    (check-true (refuted? (prove-zero (- (sqrt (+ 4 (* 2 (root 3)))) (root 3) -1))))))

(define ((L-pendulum m l g) s)
  (+ (* 1/2 m l l (square (velocity s))) (* m g l (cos (coordinate s)))))

(test-case "pi and its multiples are equilibria, their neighbours are not proved to be"
  (define (status q) (verdict-status (verify-equilibrium (L-pendulum 'm 'l 'g) q)))
  (for ([q (list pi (- pi) (* 2 pi) (* 3 pi) (* -5 pi) 9.42477796076938)])
    (check-eq? (status q) 'proved (shown q)))
  (for ([q (list 3.1415926535897936 3.141592653589794 (+ pi 1e-15) (- pi 1e-15) 3.14159)])
    (check-false (eq? (status q) 'proved) (shown q))))
