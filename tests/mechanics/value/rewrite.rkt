#lang racket/base
;; Forms asked for, on values of every shape, as the prompt shows them.

(require mechanics
         mechanics/lang/printer
         "../support/checks.rkt" "../support/random.rkt" "../support/same.rkt"
         "../support/random/element.rkt")

(define (shown x)
  (define port (open-output-string))
  (parameterize ([current-output-port port]) (print-result x))
  (get-output-string port))

(define square-of-sum (expt (+ 'a 'b) 2))

(test-case "the prompt shows the form asked for, simplify undoes it"
  (define e (expand square-of-sum))
  (check-equal? (shown e) "(+ (expt a 2) (* 2 a b) (expt b 2))\n")
  (check-equal? (shown (simplify (together (+ (/ 'a 'b) (/ 'c 'b) (/ 'c 'd)))))
                (shown (+ (/ 'a 'b) (/ 'c 'b) (/ 'c 'd))))
  (check-equal? (shown (list (factor (- (square 'a) (square 'b)))))
                "(list (* (- a b) (+ a b)))\n")
  (check-equal? (shown (up 1 (factor (- (square 'a) (square 'b)))))
                "(up 1 (* (- a b) (+ a b)))\n"))

(test-case "a value in a form asked for is like any other in arithmetic"
  (define e (factor (- (square 'a) (square 'b))))
  (check-equal? e (* (- 'a 'b) (+ 'a 'b)))
  (check-equal? (shown (/ e (+ 'a 'b))) "(- a b)\n")
  (check-equal? (shown (+ e (square 'b))) "(expt a 2)\n")
  (check-equal? (hash-ref (hash (* (- 'a 'b) (+ 'a 'b)) 'found) e) 'found))

(test-case "what was assumed is shown beneath"
  (check-equal? (shown (expand (* (sqrt (square 'r)) (+ 1 'a))))
                "(+ (* a r) r)\n; assuming (>= r 0)\n"))

(test-case "structures and matrices keep their shape"
  (check-equal? (expression (expand (up square-of-sum (down 1 'x))))
                '(up (+ (expt a 2) (* 2 a b) (expt b 2)) (down 1 x)))
  (check-equal? (expression (together (matrix-by-rows (list (+ (/ 1 'a) (/ 1 'b)) 2))))
                '(matrix-by-rows (list (/ (+ a b) (* a b)) 2)))
  (with-seed 611
    (for ([_ 8])
      (define value ((random-nested random-expression)))
      (for ([f (list expand factor together (lambda (x) (collect x 'a)) (lambda (x) (apart x 'a)))])
        (check-true (same? (f value) value))))))

(test-case "numerators and denominators of numbers and of expressions"
  (check-equal? (numerator 6/4) 3)
  (check-equal? (denominator 0.5) 2.0)
  (check-equal? (expression (numerator (+ (/ 'a 'b) (/ 'c 'd)))) '(+ (* a d) (* b c)))
  (check-equal? (expression (denominator (+ (/ 'a 'b) (/ 'c 'd)))) '(* b d))
  (check-equal? (denominator 'a) 1))

(test-case "coefficients"
  (check-equal? (expression (coefficient (up (expt (+ 'a 'm) 2) 3) 'm 1)) '(up (* 2 a) 0))
  (check-exn
   #rx"^coefficient: the expression is no polynomial in m: it is divided by a sum with m in it"
   (lambda () (coefficient (/ 1 (+ 1 'm)) 'm 0)))
  (check-exn #rx"an integer, the power whose coefficient is wanted\n  given: the number 1/2"
             (lambda () (coefficient 'm 'm 1/2))))

(test-case "what is wrong with the arguments is said"
  (check-exn
   #rx"^expand: expected an expression, or a tuple or matrix of them\n  given: the procedure `sin`\n  apply the function first, and use it on its value$"
   (lambda () (expand sin)))
  (check-exn #rx"^factor: .*given: \"a\", a string$" (lambda () (factor "a")))
  (check-exn
   #rx"^collect: it is not said in what; use [(]collect x 'm[)] or [(]collect x [(]list 'm 'n[)][)]\n  given only: 3$"
   (lambda () (collect 3)))
  (check-exn
   #rx"^collect: expected a symbol, or a literal function applied such as [(][(]D f[)] 't[)]\n  given: the number 3$"
   (lambda () (collect 'a 3)))
  (check-exn #rx"^apart: expected a symbol, .*\n  given: the number 3$" (lambda () (apart 'x 3)))
  (check-exn #rx"^apart: it is not said in what" (lambda () (apart 'x))))
