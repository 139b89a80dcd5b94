#lang racket/base
;; Simplified forms: what the book prints, and what a physicist would write.

(require mechanics/algebra/expression/expression
         mechanics/algebra/assumption/assumption-set
         mechanics/algebra/assumption/reference-point
         mechanics/algebra/simplify/declare-relations
         mechanics/algebra/simplify/known-sign
         mechanics/algebra/simplify/simplify-expression
         mechanics/algebra/expression/read
         "../../support/checks.rkt")

(define (simplified d) (expression->datum (simplify-expression (datum->expression d))))

(define-syntax-rule (check-forms [before after] ...)
  (begin (check-equal? (simplified 'before) 'after) ...))

(test-case "residuals have the book's form"
  (check-forms
   [(+ (* m (((expt D 2) x) t)) (* k (x t)))
    (+ (* k (x t)) (* m (((expt D 2) x) t)))]
   [(+ ((D V) (r t)) (- (* m (((expt D 2) r) t)) (* m (r t) (expt ((D phi) t) 2))))
    (+ (* m (((expt D 2) r) t)) (* -1 m (r t) (expt ((D phi) t) 2)) ((D V) (r t)))]
   [(+ (* 2 m (r t) ((D r) t) ((D phi) t)) (* m (expt (r t) 2) (((expt D 2) phi) t)))
    (+ (* m (expt (r t) 2) (((expt D 2) phi) t)) (* 2 m (r t) ((D phi) t) ((D r) t)))]))

(test-case "a factor comes out in front when that is smaller"
  (check-forms
   [(- (* a k (cos (+ (* omega t) phi))) (* a m omega omega (cos (+ phi (* t omega)))))
    (* a (- k (* m (expt omega 2))) (cos (+ (* omega t) phi)))]
   [(+ (* 1/2 m vx vx) (* 1/2 m vy vy))
    (* 1/2 m (+ (expt vx 2) (expt vy 2)))]
   [(+ (* -1 a) (* -1 b)) (* -1 (+ a b))]))

(test-case "rational functions are in lowest terms"
  (check-forms
   [(/ (- (expt a 2) (expt b 2)) (- a b)) (+ a b)]
   [(+ (/ (expt p 2) (* 2 m)) (V x)) (+ (/ (* 1/2 (expt p 2)) m) (V x))]
   [(- (/ 1 (- x 1)) (/ 1 (+ x 1))) (/ 2 (- (expt x 2) 1))]
   [(- (/ (+ a b) c) (/ a c) (/ b c)) 0]))

(test-case "a fraction has one form, whichever of numerator and denominator had the root or sine"
  (check-forms
   [(/ 1 (+ 1 (sin x))) (/ 1 (+ 1 (sin x)))]
   [(/ (- 1 (sin x)) (expt (cos x) 2)) (/ 1 (+ 1 (sin x)))]
   [(/ (- a (sinh x)) (- (expt a 2) (expt (sinh x) 2))) (/ 1 (+ a (sinh x)))]
   [(/ (- (+ a b c d) (sqrt e)) (- (expt (+ a b c d) 2) e)) (/ 1 (+ a b c d (sqrt e)))]
   [(/ (- (sqrt (+ (expt x 9) 1)) 1) (expt x 9)) (/ 1 (+ 1 (sqrt (+ 1 (expt x 9)))))]))

(test-case "squares of sine and cosine add to one"
  (check-forms
   [(+ (expt (sin x) 2) (expt (cos x) 2)) 1]
   [(- (sin (+ a b)) (+ (* (sin a) (cos b)) (* (cos a) (sin b)))) 0]
   [(- (cos (* 2 a)) (- 1 (* 2 (expt (sin a) 2)))) 0]
   [(- (expt (cosh x) 2) (expt (sinh x) 2)) 1]))

(test-case "sums of angles are found under sines and hyperbolic sines, each by itself"
  (check-forms
   [(/ (- (* (cos a) (cos b)) (* (sin a) (sin b))) (+ (* (cosh a) (cosh b)) (* (sinh a) (sinh b))))
    (/ (cos (+ a b)) (cosh (+ a b)))]))

(test-case "square roots of squares come out, and the assumption is told"
  (define-values (e assumptions)
    (simplify-expression/assumptions
     (datum->expression '(sqrt (+ (expt (* R (cos x)) 2) (expt (* R (sin x)) 2))))))
  (check-equal? e 'R)
  (check-equal? assumptions '((>= R 0))))

(test-case "radicals keep their radicands"
  (check-forms
   [(/ (* mu x) (expt (+ (* x x) (* y y)) 3/2))
    (/ (* mu x) (expt (+ (expt x 2) (expt y 2)) 3/2))]
   [(sqrt (/ k m)) (sqrt (/ k m))]
   [(* (sqrt (* x y)) (sqrt (* x y)) z) (* x y z)]
   [(/ x (* (sqrt x) (sqrt x) (+ b y))) (/ 1 (+ b y))]
   [(/ x (* (+ b y) (sqrt x) (sqrt x))) (/ 1 (+ b y))]))

(test-case "a square of roots leaves the root of a product, by its positive root"
  (check-forms
   [(sqrt (- (* 3 x) (* 2 (sqrt 2) x))) (- (* (sqrt 2) (sqrt x)) (sqrt x))]
   [(sqrt (- (* 2 (sqrt 2) x) (* 3 x))) (* (- (sqrt 2) 1) (sqrt (* -1 x)))]
   [(sqrt (* -1 x (+ 3 (* 2 (sqrt 2))))) (* (+ 1 (sqrt 2)) (sqrt (* -1 x)))]))

(test-case "a sign is known by the form, or it is not; nothing is taken for granted"
  (define (sign d) (known-sign (datum->expression d) no-assumptions))
  (check-equal? (map sign '((- (cos x) 2) (exp x) (- x x) (cos x) (- 3) (sqrt 2)))
                '(-1 1 0 #f -1 1))
  (check-false (sign '(- (sqrt (expt x 2)) x))))

(test-case "functions of arguments that are equal, though written differently, are one"
  (define-values (one other) (values '(sin (* 2 a)) '(* 2 (sin a) (cos a))))
  (for ([f (list (lambda (u) `(h ,u))
                 (lambda (u) `(h ,u x))
                 (lambda (u) `(h (up ,u x)))
                 (lambda (u) `(g (h ,u)))
                 (lambda (u) `(exp (h ,u)))
                 (lambda (u) `(exp ,u)))])
    (check-equal? (simplified `(- ,(f one) ,(f other))) 0 (format "~s" (f 'u))))
  (check-equal? (simplified `(+ (h ,one) (h ,other) (h x))) `(+ (h x) (* 2 (h ,one)))))

(test-case "arguments too large to be compared stay as they are written"
  (define power '(expt (+ 1 (sin (* 2 a)) b c d) 60))
  (define-values (e notes)
    (simplify-expression/assumptions
     (datum->expression `(+ (f ,power) (f (* 2 (sin a) (cos a)))))))
  (check-equal? notes `((left-unexpanded ,power))))

(test-case "within a region a root is split by the signs there, and nothing is assumed"
  (define (within relations)
    (expression->datum
     (simplify-where (datum->expression '(sqrt (* x x y)))
                     (declare-relations no-assumptions relations))))
  (check-equal? (within '()) '(* (abs x) (sqrt y)))
  (check-equal? (within '((>= x 0))) '(* x (sqrt y))))

(test-case "where two roots have values, both radicands are known not to be negative"
  (define-values (e assumptions)
    (simplify-expression/assumptions
     (datum->expression '(* (sqrt (* k m)) (sqrt (- a b)) (abs (- a b))))))
  (check-equal? (expression->datum e) '(* (sqrt (* k m)) (expt (- a b) 3/2)))
  (check-equal? assumptions '()))

(test-case "where the root of a quotient and a logarithm have values, the denominator is positive"
  (check-forms
   [(+ (* (sqrt (/ k m)) (abs m)) (log k)) (+ (log k) (sqrt (* k m)))]))

(test-case "of a power with unknown sign an even power leaves an odd root"
  (define (careful n q)
    (simplify-expression (datum->expression `(expt (expt x ,n) ,(/ 1 q)))
                         (with-automatic-assumptions no-assumptions #f)))
  (check-equal? (expression->datum (careful 8 3)) '(* (expt x 2) (expt (expt x 2) 1/3)))
  ;; (-8)^n has a real root of odd degree that is positive, or none.
  (for* ([q '(3 5)] [n (in-range 2 16 2)])
    (define root (real-value (careful n q) (lambda (leaf arguments) -8.0)))
    (check-= root (expt 8.0 (/ n q)) (* 1e-12 root) (format "~a/~a" n q))))
