#lang racket/base
;; Equations solved by factors: known ones, and every solution put back.

(require (only-in mechanics
                  + - * / expt square sqrt abs magnitude sin cos acos asin exp cosh sinh pi
                  expression simplify substitute proved? prove-zero)
         mechanics/algebra/assumption/assumption-set
         mechanics/algebra/expression/constant-value
         (only-in mechanics/algebra/expression/expression expression->datum)
         mechanics/algebra/expression/read mechanics/algebra/solve/angles-in
         mechanics/algebra/solve/solve-by-cases mechanics/algebra/solve/solve-equations
         "../../support/checks.rkt" "../../support/random.rkt")

(define (solutions equations unknowns #:by [solve solve-equations])
  (define found (solve equations unknowns no-assumptions))
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

(define (put equation values)
  (apply substitute equation (apply append (for/list ([p values]) (list (car p) (cdr p))))))

(test-case "a cosine and a sine have as many zeros in a turn of x as the angle goes round, twice"
  (for* ([n '(1 3)] [amplitudes '((3 4) (-3 4) (4 -3) (-1 -2))] [c '(2 -1 7)])
    (define u (+ (* n 'x) 1/5))
    (define e (+ (* (car amplitudes) (cos u)) (* (cadr amplitudes) (sin u)) c))
    (define found (solve-equations (list e) '(x) no-assumptions))
    (define hypotenuse² (apply + (map square amplitudes)))
    (check-equal? (length found) (if (< (* c c) hypotenuse²) (* 2 n) 0))
    (for ([s found]) (check-within (constant-value (put e (car s))) 0.0 1e-13))
    (define places (for/list ([s found]) (exp (* +i (constant-value (cdaar s))))))
    (for* ([z places] [w places] #:unless (eq? z w)) (check-true (> (magnitude (- z w)) 1e-3)))))

(test-case "of an angle found the sine and cosine are put into the others"
  (check-equal? (solutions (list (sin 'x) (- (cos 'x) 1)) '(x)) '((((x 0)))))
  (check-equal? (solutions (list (- (* 3 (cos 'x)) 1) (- 'y (sin 'x))) '(x y))
                '((((x (acos 1/3)) (y (* 2/3 (sqrt 2)))))
                  (((x (* -1 (acos 1/3))) (y (* -2/3 (sqrt 2)))))))
  (check-equal? (solutions (list (- (* 3 (sin 'x)) 1) (- 'y (* 3 (sin 'x)))) '(x y))
                '((((x (asin 1/3)) (y 1))) (((x (- :pi (asin 1/3))) (y 1))))))

(test-case "a right angle has the sine 1 or −1, and a cosine is from −1 to 1"
  (check-equal? (solutions (list (cos 'x) (- 'y (sin 'x))) '(x y))
                '((((x (* 1/2 :pi)) (y 1))) (((x (* -1/2 :pi)) (y -1)))))
  (check-equal? (solutions (list (- (cos 'x) 'a)) '(x))
                '((((x (acos a))) (<= -1 a 1)) (((x (* -1 (acos a)))) (<= -1 a 1)))))

(test-case "an angle is what stands in a sine or cosine"
  (define e (datum->expression '(+ (cos (* 2 x)) (exp y) x)))
  (check-equal? (map (lambda (u) (in-angle? u e)) '(x y)) '(#t #f))
  (define (other-period d)
    (define u (angle-of-other-period (list (datum->expression d)) '(x) no-assumptions))
    (and u (expression->datum u)))
  (check-equal? (other-period '(cos (* k x))) '(* k x))
  (check-false (other-period '(+ (cos (+ a (* 2 x))) (sin (* 1/2 y))))))

(test-case "powers of one power"
  (define (roots e) (map cadaar (solutions (list e) '(x))))
  (check-equal? (roots (+ (expt 'x 4) (* -13 (square 'x)) 36)) '(3 2 -2 -3))
  (check-equal? (roots (+ (expt 'x 6) (* -7 (expt 'x 3)) -8)) '(2 -1))
  (check-equal? (roots (+ (expt 'x 3) 8)) '(-2))
  (check-equal? (solutions (list (- (expt 'x 3) 'a)) '(x))
                '((((x (* (sgn a) (expt (abs a) 1/3)))))))
  (check-equal? (solutions (list (- (expt 'x 4) 'a)) '(x))
                '((((x (expt a 1/4))) (>= a 0)) (((x (* -1 (expt a 1/4)))) (>= a 0)))))

(test-case "a divisor is no factor, even one that cannot be solved"
  (check-equal? (solutions (list (/ (- 'x 1) (+ (expt 'x 5) 'x 1))) '(x)) '((((x 1))))))

(test-case "one equation with flonums makes the quotients of all flonums"
  (check-equal? (solutions (list (- (* 2.0 'x) 1) (- (* 3 'y) 1)) '(x y))
                `((((x 0.5) (y ,(/ 1.0 3.0)))))))

(test-case "each side of an absolute value by itself, its border once"
  (define (cases e) (solutions (list e) '(x) #:by solve-by-cases))
  (check-equal? (cases (- (abs (- 'x 1/2)) 1/4)) '((((x 3/4))) (((x 1/4)))))
  (check-equal? (cases (- (abs (- 'x 0.1)) (* 2 (- 'x 0.1)))) '((((x 0.1)))))
  (check-equal? (cases (- (abs 'x) 'a)) '((((x a)) (> a 0)) (((x (* -1 a))) (> a 0)))))

(test-case "where the equation would divide by zero, a condition is strict"
  (define (cases e) (solutions (list e) '(x) #:by solve-by-cases))
  (check-equal? (cases (- (sqrt 'x) 'b)) '((((x (expt b 2))) (>= b 0))))
  (check-equal? (cases (- (/ 'a (sqrt 'x)) 'b))
                '((((x (/ (expt a 2) (expt b 2)))) (> (* a b) 0))))
  (check-equal? (cases (/ (* (abs 'x) (sin 'x)) 'x)) '((((x :pi))))))

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
        (check-pred proved? (prove-zero (put e (car s))))))))
