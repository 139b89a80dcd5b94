#lang racket/base
;; SICM 1.5, The Euler-Lagrange Equations (pp. 23-37).

(require mechanics
         mechanics/book
         "../support/checks.rkt" "../support/session.rkt")

(define x (literal-function 'x))
(define r (literal-function 'r))
(define phi (literal-function 'phi))
(define (dot f) ((D f) 't))
(define (ddot f) (((expt D 2) f) 't))

(test-case "p. 31: variations (exercise 1.8), with literal F and a literal path"
  (define F (literal-function 'F (-> (UP Real Real Real) Real)))
  (define G (literal-function 'G (-> (UP Real Real Real) Real)))
  (define H (literal-function 'H))
  (define q (literal-function 'q))
  (define eta (literal-function 'eta))
  (define (f q) (compose F (Gamma q)))
  (define (g q) (compose G (Gamma q)))
  (define (vary h) ((((delta eta) h) q) 't))
  (check-prints (vary (lambda (q) q)) '(eta t))
  (check-prints (vary D) '((D eta) t))
  (check-identity (vary (+ f g)) (+ (vary f) (vary g)))
  (check-identity (vary (* 'c g)) (* 'c (vary g)))
  (check-identity (vary (* f g)) (+ (* (vary f) ((g q) 't)) (* ((f q) 't) (vary g))))
  (check-identity (vary (lambda (q) (compose H (g q)))) (* ((D H) ((g q) 't)) (vary g)))
  (check-identity ((D (((delta eta) f) q)) 't) (vary (lambda (q) (D (f q))))))

(test-case "p. 31: the vocabulary of signatures, quoted or not"
  (for ([signature (list (-> (UP Real (UP* Real 2) (UP* Real 2)) Real)
                         '(-> (UP Real (UP* Real 2) (UP* Real 2)) Real)
                         (Lagrangian 2))])
    (define L (literal-function 'L signature))
    (check-unsimplified (L (up 't (up 'x 'y) (up 'vx 'vy))) '(L (up t (up x y) (up vx vy)))))
  (define K (literal-function 'K (-> (X* Real 2) (DOWN* Real 2))))
  (check-unsimplified (K 'a 'b) '(down (K_0 a b) (K_1 a b)))
  (define M (literal-function 'M (-> (X Real (DOWN Real Real)) (UP Real Real))))
  (check-unsimplified (M 'a (down 'p 'q)) '(up (M^0 a (down p q)) (M^1 a (down p q)))))

(test-case "p. 33: the equations are what the book defines"
  (define ((Lagrange-equations-typed L) q)
    (- (D (compose ((partial 2) L) (Gamma q)))
       (compose ((partial 1) L) (Gamma q))))
  (define L (literal-function 'L (Lagrangian)))
  (check-identity (((Lagrange-equations L) x) 't) (((Lagrange-equations-typed L) x) 't)))

(test-case "p. 34: the free particle on a straight line"
  (define (straight t) (up (+ (* 'a t) 'a0) (+ (* 'b t) 'b0) (+ (* 'c t) 'c0)))
  (check-prints (((Lagrange-equations (L-free-particle 'm)) straight) 't) '(down 0 0 0))
  (check-prints (((Lagrange-equations (L-free-particle 'm)) test-path) 't) '(down 0 0 0)))

(test-case "p. 35: the free particle on any path"
  (check-prints (((Lagrange-equations (L-free-particle 'm)) x) 't)
                '(* m (((expt D 2) x) t))))

(test-case "p. 36: the harmonic oscillator on a proposed solution"
  (check-prints (((Lagrange-equations (L-harmonic 'm 'k)) proposed-solution) 't)
                '(* a (- k (* m (expt omega 2))) (cos (+ (* omega t) phi))))
  (define verdict (verify-solution (L-harmonic 'm 'k) proposed-solution))
  (check-eq? (verdict-status verdict) 'refuted)
  (check-equal? (verdict-conditions verdict) '((= k (* m (expt omega 2)))))
  (check-eq? (verdict-status
              (verify-solution (L-harmonic 'm (* 'm (square 'omega))) proposed-solution))
             'proved))

(test-case "p. 36: a central force in polar coordinates"
  (define U (literal-function 'U))
  (check-identity (((Lagrange-equations (L-central-polar 'm U)) (up r phi)) 't)
                  (down (+ (* 'm (ddot r)) (* -1 'm (r 't) (square (dot phi))) ((D U) (r 't)))
                        (+ (* 'm (square (r 't)) (ddot phi)) (* 2 'm (r 't) (dot r) (dot phi))))))

(test-case "p. 37: gravitational orbits in polar coordinates, with the reduced mass"
  (define mu (/ (* 'm_1 'm_2) (+ 'm_1 'm_2)))
  (check-identity (((Lagrange-equations
                     (L-central-polar mu (gravitational-energy 'G 'm_1 'm_2)))
                    (up r phi))
                   't)
                  (down (+ (- (* mu (ddot r)) (* mu (r 't) (square (dot phi))))
                           (/ (* 'G 'm_1 'm_2) (square (r 't))))
                        (* mu (+ (* (square (r 't)) (ddot phi)) (* 2 (r 't) (dot r) (dot phi)))))))

(test-case "exercise 1.11: Kepler's third law from the residual of a circular orbit"
  (define (circle t) (up 'a (* 'n t)))
  (define mu (/ (* 'm_1 'm_2) (+ 'm_1 'm_2)))
  (define residual
    (((Lagrange-equations (L-central-polar mu (gravitational-energy 'G 'm_1 'm_2))) circle) 't))
  (check-identity (* (ref residual 0) (/ (square 'a) mu))
                  (- (* 'G (+ 'm_1 'm_2)) (* (square 'n) (cube 'a))))
  (check-eq? (verdict-status
              (verify-solution (L-Kepler-polar (* (square 'n) (cube 'a)) 'm) circle))
             'proved))

(test-case "a planet about a sun at rest"
  (check-identity (((Lagrange-equations (L-Kepler-polar 'GM 'm)) (up r phi)) 't)
                  (down (+ (- (* 'm (ddot r)) (* 'm (r 't) (square (dot phi))))
                           (/ (* 'GM 'm) (square (r 't))))
                        (+ (* 'm (square (r 't)) (ddot phi)) (* 2 'm (r 't) (dot r) (dot phi))))))

(test-case "exercises 1.10 and 1.13: derivatives of higher order in the Lagrangian"
  (define (L (up t q v a)) (- (* -1/2 'm q a) (* 1/2 'k (square q))))
  (define expected '(+ (* k (x t)) (* m (((expt D 2) x) t))))
  (check-prints (((Lagrange-equations L #:order 2) x) 't) expected)
  (define any (literal-function 'L (-> (UP Real Real Real Real) Real)))
  (define along (Gamma x 4))
  (check-identity (((Lagrange-equations any #:order 2) x) 't)
                  ((- (D (compose ((partial 2) any) along))
                      ((expt D 2) (compose ((partial 3) any) along))
                      (compose ((partial 1) any) along))
                   't)))
