#lang racket/base
;; Sines and exponentials as rational functions of tangents and exponentials.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/nodes
         mechanics/algebra/expression/operation
         mechanics/algebra/expression/read
         mechanics/algebra/zero/half-angles
         "../../support/checks.rkt" "../../support/evaluate.rkt")

(define numbers '((x . 0.7) (y . -0.4) (z . 1.3)))
(define (value e [more '()]) (evaluate-expression e (point-lookup (append more numbers))))

(define functions (list op:sin op:cos op:tan op:exp op:sinh op:cosh op:tanh))

(test-case "no function is left, and with what the symbols stand for the value is the same"
  (for ([d '((sin x) (cos x) (tan (- x y)) (* (sin (* 3/2 x)) (cos (+ x (/ y 3))))
             (exp x) (sinh (- x)) (cosh (* 2 x)) (tanh (+ x y))
             (- (exp (* -1/2 x)) (* z (cosh y)) (sin (+ 1 z))))])
    (define e (datum->expression d))
    (define-values (rational stand-ins) (rationalized e))
    (check-equal? (filter (lambda (n) (memq (node-head n) functions)) (nodes-in rational)) '())
    (define (quotient s) (/ (value (stand-in-over s)) (value (stand-in-under s))))
    (define tangents (for/list ([s stand-ins]) (cons (stand-in-symbol s) (quotient s))))
    (check-= (value rational tangents) (value e) 1e-12 (format "~s" d))))

(test-case "exponentials are told from tangents"
  (define (kinds d)
    (define-values (rational stand-ins) (rationalized (datum->expression d)))
    (map exponential-stand-in? stand-ins))
  (check-equal? (kinds '(+ (sin x) (exp y))) '(#f #t)))

;; Nine steps would be a polynomial of a high degree.
(test-case "an angle of more than eight steps stays"
  (define (stays? n)
    (define-values (rational stand-ins)
      (rationalized (datum->expression `(+ (sin (* ,n x)) (sin x)))))
    (pair? (filter (lambda (n) (eq? (node-head n) op:sin)) (nodes-in rational))))
  (check-false (stays? 8))
  (check-true (stays? 9)))
