#lang racket/base
;; SICM, appendix on notation (pp. 509-523).

(require mechanics
         "../support/checks.rkt" "../support/session.rkt")

(test-case "p. 511: derivatives are functions"
  (define derivative-of-sine (D sin))
  (check-prints (derivative-of-sine 'x) '(cos x))
  (check-prints (((square D) sin) 'x) '(* -1 (sin x)))
  (check-prints ((compose (D sin) square) 'x) '(cos (expt x 2))))

(test-case "p. 512: literal functions and composition"
  (check-prints ((compose (literal-function 'f) (literal-function 'g)) 'x) '(f (g x)))
  (check-prints ((D (compose (literal-function 'f) (literal-function 'g))) 'x)
                '(* ((D f) (g x)) ((D g) x))))

(test-case "p. 513: up and down tuples, components, slots"
  (define v (up 'v^0 'v^1 'v^2))
  (define p (down 'p_0 'p_1 'p_2))
  (check-unsimplified v '(up v^0 v^1 v^2))
  (check-equal? (ref v 1) 'v^1)
  (check-equal? ((component 1) p) 'p_1)
  (define s (up 't (up 'x 'y) (down 'p_x 'p_y)))
  (check-equal? (ref (ref s 2) 1) (ref s 2 1))
  (check-true (up? v))
  (check-true (down? p))
  (check-true (structure? s)))

(test-case "p. 515: contraction and tensor products"
  (check-prints (* (down 'p_0 'p_1 'p_2) (up 'v^0 'v^1 'v^2))
                '(+ (* p_0 v^0) (* p_1 v^1) (* p_2 v^2)))
  (check-prints (* (up 'a 'b) (up 'x 'y)) '(up (up (* a x) (* b x)) (up (* a y) (* b y))))
  (check-prints (square (up 'x 'y)) '(+ (expt x 2) (expt y 2))))

(test-case "p. 516: linear transformations as tuples of tuples"
  (define m (down (up 'a 'c) (up 'b 'd)))
  (check-prints (* m (up 'x 'y)) '(up (+ (* a x) (* b y)) (+ (* c x) (* d y))))
  (check-prints (* (down 'x 'y) m) '(down (+ (* a x) (* c y)) (+ (* b x) (* d y)))))

(test-case "p. 517: derivatives of functions of several arguments, as tuples"
  (define g (literal-function 'g (-> (X Real Real) Real)))
  (define h (literal-function 'h (-> (UP Real Real) Real)))
  (check-unsimplified ((D g) 'x 'y) '(down (((partial 0) g) x y) (((partial 1) g) x y)))
  (check-unsimplified ((D h) (up 'x 'y))
                      '(down (((partial 0) h) (up x y)) (((partial 1) h) (up x y))))
  (check-prints (* ((D g) 'x 'y) (up 'dx 'dy))
                '(+ (* dx (((partial 0) g) x y)) (* dy (((partial 1) g) x y)))))

(test-case "p. 518: derivatives of a function of a structured argument"
  (define H (literal-function 'H '(-> (UP Real (UP Real Real) (DOWN Real Real)) Real)))
  (define s (up 't (up 'x 'y) (down 'p_x 'p_y)))
  (check-unsimplified (((partial 1 0) H) s) '(((partial 1 0) H) (up t (up x y) (down p_x p_y))))
  (check-unsimplified (((partial 2) H) s)
                      '(up (((partial 2 0) H) (up t (up x y) (down p_x p_y)))
                           (((partial 2 1) H) (up t (up x y) (down p_x p_y))))))

(test-case "p. 521: a helix"
  (define (helix t) (up (cos t) (sin t) t))
  (check-prints ((D helix) 't) '(up (* -1 (sin t)) (cos t) 1))
  (check-prints (square ((D helix) 't)) 2))

(test-case "operators: sums, products, powers, the identity"
  (define f (literal-function 'f))
  (check-prints (((+ D 1) f) 'x) '(+ (f x) ((D f) x)))
  (check-prints (((* (- D 1) (+ D 1)) f) 'x) '(- (((expt D 2) f) x) (f x)))
  (check-prints ((I f) 'x) '(f x)))
