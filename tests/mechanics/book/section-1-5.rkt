#lang racket/base
;; SICM 1.5, The Euler-Lagrange Equations (pp. 23-37).

(require mechanics rackunit "check.rkt")

(define ((L-free-particle mass) local)
  (* 1/2 mass (square (velocity local))))
(define ((L-harmonic m k) local)
  (- (* 1/2 m (square (velocity local))) (* 1/2 k (square (coordinate local)))))

(test-case "p. 31: variations (exercise 1.8), with literal F and a literal path"
  (define F (literal-function 'F (-> (UP Real Real Real) Real)))
  (define G (literal-function 'G (-> (UP Real Real Real) Real)))
  (define q (literal-function 'q))
  (define eta (literal-function 'eta))
  (define (f q) (compose F (Gamma q)))
  (define (g q) (compose G (Gamma q)))
  (define (vary h) ((((delta eta) h) q) 't))
  (check-prints (vary (lambda (q) q)) '(eta t))
  (check-prints (vary D) '((D eta) t))
  (check-prints (- (vary (+ f g)) (+ (vary f) (vary g))) 0)
  (check-prints (- (vary (* 'c g)) (* 'c (vary g))) 0)
  (check-prints (- (vary (* f g)) (+ (* (vary f) ((g q) 't)) (* ((f q) 't) (vary g)))) 0)
  (check-prints (- ((D (((delta eta) f) q)) 't) (vary (lambda (q) (D (f q))))) 0))

(test-case "p. 34: the free particle on a straight line"
  (define (straight t) (up (+ (* 'a t) 'a0) (+ (* 'b t) 'b0) (+ (* 'c t) 'c0)))
  (check-prints (((Lagrange-equations (L-free-particle 'm)) straight) 't) '(down 0 0 0)))

(test-case "p. 35: the free particle on any path"
  (check-prints (((Lagrange-equations (L-free-particle 'm)) (literal-function 'x)) 't)
                '(* m (((expt D 2) x) t))))

(test-case "p. 36: the harmonic oscillator on a proposed solution"
  (define (proposed-solution t) (* 'a (cos (+ (* 'omega t) 'phi))))
  (check-prints (((Lagrange-equations (L-harmonic 'm 'k)) proposed-solution) 't)
                '(* a (- k (* m (expt omega 2))) (cos (+ (* omega t) phi)))))

(test-case "p. 37: gravitational orbits in polar coordinates"
  (define ((L-central-polar m V) (up t (up r phi) (up rdot phidot)))
    (- (* 1/2 m (+ (square rdot) (square (* r phidot)))) (V r)))
  (define ((gravitational-energy G m1 m2) r) (- (/ (* G m1 m2) r)))
  (define residual
    (((Lagrange-equations (L-central-polar (/ (* 'm_1 'm_2) (+ 'm_1 'm_2))
                                           (gravitational-energy 'G 'm_1 'm_2)))
      (up (literal-function 'r) (literal-function 'phi)))
     't))
  (define r ((literal-function 'r) 't))
  (define mu (/ (* 'm_1 'm_2) (+ 'm_1 'm_2)))
  (define (dot f) ((D (literal-function f)) 't))
  (define (ddot f) (((expt D 2) (literal-function f)) 't))
  (check-prints (- residual
                   (down (+ (- (* mu (ddot 'r)) (* mu r (square (dot 'phi))))
                            (/ (* 'G 'm_1 'm_2) (square r)))
                         (* mu (+ (* (square r) (ddot 'phi)) (* 2 r (dot 'r) (dot 'phi))))))
                '(down 0 0)))

(test-case "exercise 1.13: accelerations in the Lagrangian"
  (define (L (up t q v a)) (- (* -1/2 'm q a) (* 1/2 'k (square q))))
  (check-prints (((Lagrange-equations L #:order 2) (literal-function 'x)) 't)
                '(+ (* k (x t)) (* m (((expt D 2) x) t)))))
