#lang racket/base
;; Formulas as on paper, and how they are written here.

(require mechanics/lang/paper-notation/prefix-form
         mechanics/lang/paper-notation/operation-sign
         (only-in mechanics/lang/prompt/typed-forms forms-in)
         "../../support/checks.rkt")

;; The form of a call such as f(x)
(define (call-form text) (prefix-form (forms-in text)))

(define-check (check-prefix forms form)
  (define found (prefix-form forms))
  (unless (equal? found form)
    (with-check-info (['forms forms] ['expected form] ['found found]) (fail-check))))

(test-case "a sign in second place makes a formula"
  (check-true (infix? '(m * v)))
  (check-true (infix? '(1/2 * m * v^2)))
  (check-true (infix? '(x = 3)))
  (check-false (infix? '(* m v)))
  (check-false (infix? '(- * v)))
  (check-false (infix? '(f 3)))
  (check-false (infix? '(f)))
  (check-false (infix? '())))

(test-case "products, quotients, sums, powers and comparisons"
  (check-prefix '(m * v) '(* m v))
  (check-prefix '(1/2 * m * v^2) '(* 1/2 m (expt v 2)))
  (check-prefix '(a + b * c) '(+ a (* b c)))
  (check-prefix '(a * b + c) '(+ (* a b) c))
  (check-prefix '(a - b - c) '(- (- a b) c))
  (check-prefix '(a - b + c) '(+ (- a b) c))
  (check-prefix '(a / b * c) '(* (/ a b) c))
  (check-prefix '(a * b / c) '(/ (* a b) c))
  (check-prefix '(2 * x ^ 3) '(* 2 (expt x 3)))
  (check-prefix '(x ** y ** z) '(expt x (expt y z)))
  (check-prefix '(omega ^ 2 = k / m) '(= (expt omega 2) (/ k m))))

(test-case "what stands side by side is multiplied, a name before parentheses called"
  (check-prefix '(1/2 m v^2 - m g h) '(- (* 1/2 m (expt v 2)) (* m g h)))
  (check-prefix '(2 x ^ 3) '(* 2 (expt x 3)))
  (check-prefix '(a * cos (x)) '(* a (cos x)))
  (check-prefix '(a * (cos x)) '(* a (cos x)))
  (check-prefix '(a * (b + c)) '(* a (+ b c)))
  (check-prefix '(m (b + c) + 1) '(+ (* m (+ b c)) 1))
  (check-prefix '('m * 'v) '(* 'm 'v)))

(test-case "a function of one argument takes what stands behind it"
  (check-prefix '(A cos (omega t)) '(* A (cos (* omega t))))
  (check-prefix '(A cos (omega*t + phi)) '(* A (cos (+ (* omega t) phi))))
  (check-prefix '(sin x + 1) '(+ (sin x) 1))
  (check-prefix '(omega sin (x)) '(* omega (sin x)))
  (check-prefix '(sin (square x) + 1) '(+ (sin (square x)) 1))
  (check-equal? (call-form "cos(pi/2)") '(cos (/ pi 2)))
  (check-equal? (call-form "cos(omega t)") '(cos (* omega t)))
  (check-equal? (call-form "sin(30 deg)") '(sin (* 30 (/ pi 180))))
  (check-equal? (call-form "atan(y,x)") '(atan y x))
  (check-equal? (call-form "tan(+ 1 1)") '(tan (+ 1 1)))
  (check-equal? (call-form "f(x/2 y)") '(f (/ x 2) y)))

(test-case "a number before names is a product, within a formula too"
  (check-prefix '((1/2 m (square v)) - (g * h)) '(- (* 1/2 m (square v)) (* g h))))

(test-case "names are those that are known"
  (define ((known . names) s) (and (memq s names) #t))
  (check-equal? (prefix-form (forms-in "m*x_1dot + theta-dot") (known 'x_1dot 'theta-dot))
                '(+ (* m x_1dot) theta-dot))
  (check-equal? (prefix-form (forms-in "m*x_1dot")) #f)
  (check-equal? (prefix-form (forms-in "1 - e^2") (known 'e)) '(- 1 (expt e 2)))
  (check-equal? (prefix-form (forms-in "1 - e^2")) #f)
  (check-equal? (prefix-form (forms-in "2 e^x")) '(* 2 (exp x)))
  (check-equal? (prefix-form (forms-in "f(x)(y) + 1")) #f)
  (check-equal? (prefix-form (forms-in "x(-1) + 1")) #f))

(test-case "what is none has no other form"
  (check-prefix '(a *) #f)
  (check-prefix '(a * + b) #f)
  (check-prefix '() #f))
