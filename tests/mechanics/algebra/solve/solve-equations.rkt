#lang racket/base
;; Equations solved by factors: known ones, and every solution put back.

(require (only-in mechanics
                  + - * / expt square sin cos acos asin exp cosh sinh pi expression simplify
                  substitute proved? prove-zero)
         mechanics/algebra/assumption/assumption-set
         mechanics/algebra/solve/solve-equations
         "../../support/checks.rkt" "../../support/random.rkt")

(define (solutions equations unknowns)
  (define found (solve-equations equations unknowns no-assumptions))
  (and found
       (for/list ([s found])
         (cons (for/list ([entry (car s)]) (list (car entry) (expression (cdr entry))))
               (expression (cdr s))))))

(test-case "linear, quadratic and factored"
  (check-equal? (solutions (list (- (* 'a 'x) 'b)) '(x)) '((((x (/ b a))))))
  (check-equal? (solutions (list (* 'x (- 'x 'a))) '(x)) '((((x 0))) (((x a)))))
  (check-equal? (solutions (list (- (square 'x) 'a)) '(x))
                '((((x (sqrt a))) (>= a 0)) (((x (* -1 (sqrt a)))) (>= a 0))))
  (check-equal? (solutions (list (+ (square 'x) 1)) '(x)) '())
  (check-equal? (solutions (list (+ (square 'x) (square 'a))) '(x)) '())
  (check-equal? (solutions (list (- (square 'x) (square 'a))) '(x)) '((((x a))) (((x (* -1 a))))))
  (check-equal? (solutions (list (* 'x (- (square 'x) (* 2 (square 'a))))) '(x))
                '((((x 0))) (((x (* a (sqrt 2))))) (((x (* -1 a (sqrt 2)))))))
  (check-equal? (solutions (list 'a) '(x)) '())
  (check-equal? (solutions (list 0) '(x)) '((()))))

(test-case "roots of exact numbers stay exact"
  (check-equal? (solutions (list (- (square 'x) 2)) '(x))
                '((((x (sqrt 2)))) (((x (* -1 (sqrt 2)))))))
  (check-equal? (solutions (list (- (expt 'x 3) 2)) '(x)) '((((x (expt 2 1/3))))))
  ;; of 1 + √2 and 1 − √2 the second is no square
  (define nested (solutions (list (- (expt 'x 4) (* 2 (square 'x)) 1)) '(x)))
  (check-equal? nested '((((x (sqrt (+ 1 (sqrt 2)))))) (((x (* -1 (sqrt (+ 1 (sqrt 2)))))))))
  (check-equal? (solutions (list (- (square 'x) 2) (- (* 'x 'y) 1)) '(x y))
                '((((x (sqrt 2)) (y (* 1/2 (sqrt 2)))))
                  (((x (* -1 (sqrt 2))) (y (* -1/2 (sqrt 2)))))))
  ;; √2 cos(x − π/4) is no greater than √2
  (check-equal? (solutions (list (+ (sin 'x) (cos 'x) -1)) '(x)) '((((x (* 1/2 :pi)))) (((x 0)))))
  (check-equal? (solutions (list (+ (sin 'x) (cos 'x) -2)) '(x)) '()))

(test-case "flonums stay what they are"
  (check-equal? (solutions (list (- (* 3.0 'x) 0.3)) '(x)) `((((x ,(/ 0.3 3.0))))))
  (check-equal? (solutions (list (* 2.0 (- 'x 0.1)) (* 4.0 (- 'x 0.1) 'y)) '(x y))
                '((((x 0.1)))))
  (check-equal? (solutions (list (* 2.0 'x (- 'x 0.1))) '(x)) '((((x 0))) (((x 0.1)))))
  (check-equal? (solutions (list (- (* 4 (cos 'x) (sin 'x)) (* 9.8 (sin 'x)))) '(x))
                '((((x 0))) (((x :pi))))))

(test-case "sines and cosines of one angle, all of a turn"
  (check-equal? (solutions (list (cos (* 2 'x))) '(x))
                '((((x (* 1/4 :pi)))) (((x (* -1/4 :pi))))
                  (((x (* -3/4 :pi)))) (((x (* 3/4 :pi))))))
  (check-equal? (solutions (list (- (* 2 (sin 'x)) 3)) '(x)) '())
  (check-equal? (solutions (list (- (* 'a (sin 'x)) (* 'b (cos 'x)))) '(x))
                '((((x (atan (/ b a))))) (((x (+ :pi (atan (/ b a)))))))))

(test-case "exponentials, which are positive, and hyperbolic functions"
  (define (roots e) (map cadaar (solutions (list e) '(x))))
  (define log-2 0.6931471805599453)
  (check-within (roots (- (exp 'x) 2)) (list log-2) 1e-15)
  (check-equal? (roots (+ (exp 'x) 1)) '())
  (check-within (roots (+ (exp (* 2 'x)) (* -3 (exp 'x)) 2)) (list log-2 0) 1e-15)
  (check-within (roots (- (exp (* 2 'x)) (exp 'x) 2)) (list log-2) 1e-15)
  (check-within (roots (- (sinh 'x) 3/4)) (list log-2) 1e-15)
  (check-within (roots (- (cosh 'x) 5/4)) (list log-2 (- log-2)) 1e-15)
  (check-equal? (solutions (list (- (exp (+ (* 'a 'x) 'b)) 'c)) '(x))
                '((((x (/ (- (log c) b) a))) (>= c 0)))))

(test-case "angles are exact where their sines are, and where the equations are"
  (define (angles e) (map cadaar (solutions (list e) '(x))))
  (check-equal? (angles (- (* 2 (cos 'x)) 1)) '((* 1/3 :pi) (* -1/3 :pi)))
  (check-equal? (angles (+ (* 2 (sin 'x)) 1)) '((* -1/6 :pi) (* 7/6 :pi)))
  (check-equal? (angles (+ (sin 'x) 1)) '((* -1/2 :pi)))
  (check-equal? (angles (+ (cos 'x) 1)) '(:pi))
  (check-equal? (angles (- (sin 'x) (cos 'x))) '((* 1/4 :pi) (* 5/4 :pi)))
  (check-equal? (angles (- (* 3 (cos 'x)) 1)) '((acos 1/3) (* -1 (acos 1/3))))
  (check-equal? (angles (sin (+ (* 2 'x) 'a)))
                '((* -1/2 a) (* 1/2 (- :pi a)) (- :pi (* 1/2 a)) (- (* 3/2 :pi) (* 1/2 a))))
  (check-equal? (angles (- (* 2.0 (cos 'x)) 1.0)) '((* 1/3 :pi) (* -1/3 :pi)))
  (check-equal? (angles (- (* 2.0 (cos 'x)) 0.3)) (list (acos 0.15) (- (acos 0.15))))
  (check-equal? (angles (- (* 2.0 (sin 'x)) 0.3)) (list (asin 0.15) (- pi (asin 0.15)))))

(test-case "several unknowns"
  (check-equal? (solutions (list (* 'x 'y) (- (+ 'x 'y) 1)) '(x y))
                '((((x 0) (y 1))) (((x 1) (y 0)))))
  (check-equal? (solutions (list (* 'y (- (* 2 'x) 'y)) (* 'x (- 'x (* 2 'y)))) '(x y))
                '((((x 0) (y 0)))))
  (check-equal? (solutions (list (- 'x 'y)) '(x y)) '((((x y))))))

(test-case "what no factor can be solved for is answered by #f"
  (check-false (solutions (list (+ (expt 'x 5) 'x 1)) '(x)))
  (check-false (solutions (list (- (sin 'x) 'x)) '(x))))

(test-case "solutions of random linear systems with a product satisfy them"
  (with-seed 77
    (for ([_ (in-range 10)])
      (define (linear)
        (+ (* (random-rational) 'x) (* (random-rational) 'y) (* (random-rational) 'a)))
      (define equations (list (* (linear) (linear)) (linear)))
      (define found (solve-equations equations '(x y) no-assumptions))
      (check-equal? (length found) 2)
      (for* ([s found] [e equations])
        (define at
          (apply substitute e (apply append (for/list ([p (car s)]) (list (car p) (cdr p))))))
        (check-pred proved? (prove-zero at))))))
