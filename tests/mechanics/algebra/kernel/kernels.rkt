#lang racket/base
;; The relations simplification knows between kernels, class by class.

(require mechanics/algebra/expression/expression
         mechanics/algebra/simplify/simplify-expression
         mechanics/algebra/expression/read
         "../../support/checks.rkt")

(define (simplified d) (expression->datum (simplify-expression (datum->expression d))))

(define-syntax-rule (check-forms [before after] ...)
  (begin (check-equal? (simplified 'before) 'after) ...))

(define (assumptions d)
  (define-values (e as) (simplify-expression/assumptions (datum->expression d)))
  as)

;; ---------------------------------------------------------------------------
;; Sines

(test-case "angles are expanded only where they depend on each other"
  (check-forms
   [(sin (+ (* omega t) phi)) (sin (+ (* omega t) phi))]
   [(- (sin (+ a b)) (+ (* (sin a) (cos b)) (* (cos a) (sin b)))) 0]
   [(- (cos (* 3 x)) (- (* 4 (expt (cos x) 3)) (* 3 (cos x)))) 0]
   [(- (* 2 (sin (* 1/2 x)) (cos (* 1/2 x))) (sin x)) 0]
   [(+ (* A (cos (* 2 x))) (* B (cos x)) (* C (sin (* 2 x))))
    (+ (* A (cos (* 2 x))) (* B (cos x)) (* C (sin (* 2 x))))]))

(test-case "products of sines and cosines contract to angle differences and sums"
  (check-forms
   [(+ (* a (cos x) (cos y)) (* a (sin x) (sin y))) (* a (cos (- x y)))]
   [(- (* (cos x) (cos y)) (* (sin x) (sin y))) (cos (+ x y))]
   [(- (* (sin x) (cos y)) (* (cos x) (sin y))) (sin (- x y))]
   [(- (* (cos (- x y)) (cos z)) (* (sin (- x y)) (sin z))) (cos (+ x (* -1 y) z))]
   [(sin (- (theta t) (phi t))) (sin (- (theta t) (phi t)))]))

(test-case "the shorter of sine and cosine squared is shown"
  (check-forms
   [(- 1 (expt (cos x) 2)) (expt (sin x) 2)]
   [(+ (* A (expt (cos x) 2)) (* B (expt (sin x) 2)))
    (+ (* A (expt (cos x) 2)) (* B (expt (sin x) 2)))]
   [(/ 1 (- 1 (expt (cos x) 2))) (/ 1 (expt (sin x) 2))]
   [(expt (- 1 (expt (cos x) 2)) 2) (expt (sin x) 4)]))

(test-case "inverse functions under sine and cosine go"
  (check-forms
   [(sin (atan y x)) (/ y (sqrt (+ (expt x 2) (expt y 2))))]
   [(cos (atan y x)) (/ x (sqrt (+ (expt x 2) (expt y 2))))]
   [(sin (asin x)) x]
   [(cos (* 2 (acos x))) (- (* 2 (expt x 2)) 1)]
   [(tan (atan x)) x]))

(test-case "values of exact numbers that are exact"
  (check-forms
   [(acosh 1) 0] [(acosh (- x (- x 1))) 0] [(atan 0) 0]
   [(acosh 2) (acosh 2)] [(atan x 2) (atan x 2)] [(atan 2 x) (atan 2 x)] [(atan 1 0) (* 1/2 :pi)]))

;; ---------------------------------------------------------------------------
;; Exponentials, powers, logarithms

(test-case "exponentials multiply"
  (check-forms
   [(* (exp a) (exp b) (exp (* -1 (+ a b)))) 1]
   [(/ A (exp (* gamma t))) (* A (exp (* -1 gamma t)))]
   [(+ (exp (+ a (* 2 b))) (* 3 (exp a) (exp b) (exp b))) (* 4 (exp (+ a (* 2 b))))]
   [(expt (exp x) n) (exp (* n x))]))

(test-case "symbolic powers multiply"
  (check-forms
   [(* (expt x n) x) (expt x (+ 1 n))]
   [(* n (/ (expt x n) x)) (* n (expt x (- n 1)))]
   [(- (* (expt x n) (expt x (* 2 n))) (expt x (* 3 n))) 0]
   [(exp (* 2 (log x))) (expt x 2)]
   [(exp (* n (log x))) (expt x n)]))

(test-case "hyperbolic functions are exponentials where exponentials occur"
  (check-forms
   [(- (cosh x) (* 1/2 (+ (exp x) (exp (* -1 x))))) 0]
   [(tanh x) (/ (sinh x) (cosh x))]
   [(- (expt (cosh x) 2) (expt (sinh x) 2)) 1]))

(test-case "logarithms are split where several occur, and what that takes is told"
  (check-forms
   [(log (exp (+ a b))) (+ a b)]
   [(log (/ x y)) (log (/ x y))]
   [(- (log (* x y)) (log x) (log y)) 0]
   [(- (log (expt x 1/3)) (* 1/3 (log x))) 0]
   [(+ (log (* (sqrt x) (expt y 2/3))) (log y)) (+ (* 1/2 (log x)) (* 5/3 (log y)))])
  (check-equal? (assumptions '(- (log (* x y)) (log x) (log y))) '())
  (check-equal? (assumptions '(- (log (* x y)) (log y))) '())
  (check-equal? (assumptions '(log (* (expt x 2) (exp y)))) '((>= x 0))))

(test-case "absolute values keep the factors whose sign is not known"
  (check-forms
   [(abs (* -3 (- a b) (expt x 2))) (* 3 (expt x 2) (abs (- a b)))]
   [(- (abs (- a b)) (abs (- b a))) 0]
   [(expt (abs x) 2) (expt x 2)]
   [(abs (exp x)) (exp x)]))

;; ---------------------------------------------------------------------------
;; Roots

(test-case "powers of one radicand combine"
  (check-forms
   [(* (expt x 1/3) (expt x 2/3)) x]
   [(* (expt x 1/4) (sqrt x)) (expt x 3/4)]
   [(* x (sqrt x)) (expt x 3/2)]
   [(/ 1 (* x (sqrt x))) (/ 1 (expt x 3/2))]
   [(+ (/ 1 (+ 1 (sqrt x))) (/ 1 (- 1 (sqrt x)))) (/ -2 (- x 1))]))

(test-case "roots that are products of others are known"
  (check-forms
   [(- (sqrt 6) (* (sqrt 2) (sqrt 3))) 0]
   [(+ (sqrt 6) (* (sqrt -2) (sqrt -3))) 0]
   [(* (sqrt (/ k m)) (sqrt (* k m))) k]
   [(- (sqrt (- (* x x) (* y y))) (* (sqrt (- x y)) (sqrt (+ x y)))) 0])
  (check-equal? (assumptions '(- (* (sqrt x) (sqrt y)) (sqrt (* x y)))) '())
  (check-equal? (sort (map cadr (assumptions '(+ (sqrt x) (expt (* x y) 3/2)))) symbol<?) '()))

(test-case "of what is not real, or may not be, a root keeps it; numbers come out"
  (check-forms
   [(sqrt (* 4 (log y))) (* 2 (sqrt (log y)))]
   [(sqrt (* 4 (sqrt (- -1 (* y y))))) (* 2 (sqrt (sqrt (- -1 (expt y 2)))))]
   [(sqrt (* 4 (+ x +i))) (* 2 (sqrt (+ x +i)))]
   [(expt (* 8 (+ x +i)) 1/3) (* 2 (expt (+ x +i) 1/3))]
   [(* (sqrt (+ x +i)) (sqrt (* 4 (+ x +i)))) (* 2 (+ x +i))]))

(test-case "a long argument is simplified as a short one"
  (define long                          ; y, in 250 nodes
    `(+ y ,@(for/list ([k (in-range 1 13)])
              `(- (expt (+ x ,k) 2) (+ (* x x) (* ,(* 2 k) x) ,(* k k))))))
  (check-equal? (simplified `(f ,long)) '(f y))
  (check-equal? (simplified `(exp (sin ,long))) '(exp (sin y))))

(test-case "the root of one minus a squared cosine is a sine, taken to be positive"
  (check-forms [(sqrt (- 1 (expt (cos x) 2))) (sin x)])
  (check-equal? (assumptions '(sqrt (- 1 (expt (cos x) 2)))) '((>= (sin x) 0))))

(test-case "a force over a distance cubed stays apart from the rest"
  (check-forms
   [(+ (* m (((expt D 2) x) t))
       (/ (* mu (x t)) (expt (+ (expt (x t) 2) (expt (y t) 2)) 3/2)))
    (+ (* m (((expt D 2) x) t))
       (/ (* mu (x t)) (expt (+ (expt (x t) 2) (expt (y t) 2)) 3/2)))]))

(test-case "a distance keeps the radicand that was written"
  (check-forms
   [(/ m (sqrt (+ (expt (+ x (/ (* a M) (+ M N))) 2) (expt y 2))))
    (/ m (sqrt (+ (expt (+ x (/ (* M a) (+ M N))) 2) (expt y 2))))]
   [(sqrt (- (+ (expt (+ x y) 2) (expt (+ z u) 2)) (expt w 2)))
    (sqrt (+ (expt (+ u z) 2) (* -1 (expt w 2)) (expt (+ x y) 2)))]
   [(sqrt (- (expt (+ x y) 2) (expt (+ z u) 2)))
    (sqrt (- (expt (+ x y) 2) (expt (+ u z) 2)))]))

;; ---------------------------------------------------------------------------
;; Numbers

(test-case "flonums are exact inside and flonums outside, exponents exact"
  (check-forms
   [(* 9.8 m (+ a 1)) (* 9.8 m (+ 1 a))]
   [(+ 2.5 (* 1.5 x) (expt x 2.0) (expt x 0.5)) (+ 2.5 (expt x 2) (* 1.5 x) (sqrt x))]
   [(sin (+ 1.5 x)) (sin (+ 1.5 x))]
   [(sqrt (* 9.8 l)) (sqrt (* 9.8 l))]
   [(- (* 0.5 x) (/ x 2)) 0]))

(test-case "complex and infinite numbers do not stop it"
  (check-forms
   [(* 1+i 1-i m) (* 2 m)]
   [(* +inf.0 m 2) (* +inf.0 m)]))

(test-case "dividing by what is zero leaves the division standing"
  (check-forms
   [(+ a (/ b (- (expt (+ x 1) 2) (+ (* x x) (* 2 x) 1)))) (+ a (/ b 0))]))

;; ---------------------------------------------------------------------------
;; Signs

(test-case "the sign of what has one is a number"
  (check-forms
   [(sgn (- (cos x) 2)) -1]
   [(* x (sgn (exp y))) x]
   [(sgn (- (expt (+ x 1) 2) (+ (* x x) (* 2 x) 1))) 0]
   [(sgn (sqrt (+ 1 x))) (sgn (sqrt (+ 1 x)))]
   [(sgn (expt x 2)) (sgn (expt x 2))]))
