#lang racket/base
;; Printed values can be read back.

(require (except-in mechanics format)
         mechanics/lang/printer
         (only-in mechanics/algebra/expression/expression expression->datum)
         (only-in mechanics/book L-harmonic)
         (only-in "../support/property/expressions.rkt"
                  classes class-depth class-kinds random-expression)
         "../support/checks.rkt" "../support/messages.rkt" "../support/random.rkt")

(define (printed x)
  (define port (open-output-string))
  (parameterize ([current-output-port port]) (print-result x))
  (get-output-string port))

(define V (literal-function 'V (-> (UP Real (UP Real Real)) Real)))
(define x (literal-function 'x))

;; Of each kind that prints as an expression, as it prints before it is simplified.
(define values-of-every-kind
  (list 3 -1/2 2.5 +inf.0 (make-rectangular 1 2) 'm ':pi
        (* 2 ':pi 'x) (- 'a) (/ 1 'a) (- 'a 'b) (sqrt 'a) (expt 2 'x) (sec 'x)
        (exp 'a) (atan 'y 'x) (abs 'a) (sgn 'a) (acosh 'a)
        (x 't) ((D x) 't) (((expt D 2) x) 't)
        (V (up 't (up 'a 'b))) (((partial 0) V) (up 't (up 'a 'b)))
        (((partial 1 0) V) (up 't (up 'a 'b)))
        (((partial 1 0) ((partial 0) ((partial 0) V))) (up 't (up 'a 'b)))
        (V (up 't (up (x 't) ((D x) 't))))
        (up 'a (down 'b 1.5)) (down) (up (up 1 2) (up (sin 'x) 4))
        (matrix-by-rows (list 'a 2) (list (sin 'x) 3))
        (series 1 'a) (power-series 1 'a (sin 'b))
        ((D V) (up 't (up 'a 'b)))
        (((Lagrange-equations (L-harmonic 'm 'k)) x) 't)))

(define (check-read-back v)
  (check-equal? (read-expression (expression v)) v)
  (check-equal? (read-expression (format "~a" v)) v)
  (check-equal? (read-expression (printed v)) (simplify v)))

(test-case "a value of every kind, from its datum, its text and what the prompt shows"
  (for ([v (in-list values-of-every-kind)])
    (with-check-info (['value v]) (check-read-back v))))

(test-case "random expressions, as simplified, alone and in tuples"
  (with-seeds 300
    (define class (list-ref classes (random (length classes))))
    (define (one)
      (with-handlers ([exn:fail:contract:divide-by-zero? (lambda (e) 'a)])
        (define e (simplify (random-expression (class-depth class) (class-kinds class))))
        (read-expression (expression e))        ; what divides by zero may be left standing
        e))
    (for ([v (list (one) (up (one) (down 'q (one))))])
      (check-equal? (expression (read-expression (expression v))) (expression v))
      (check-equal? (read-expression (expression v)) v)
      (check-equal? (read-expression (format "~a" v)) v))))

(test-case "random expressions as they were made keep their values"
  (with-seeds 100
    (define class (list-ref classes (random (length classes))))
    (define e (random-expression (class-depth class) (class-kinds class)))
    (define d (expression->datum e))
    (with-handlers ([exn:fail:contract:divide-by-zero? void])
      (check-equal? (read-expression d) e))))

(test-case "the conditions of a verdict, and relations"
  (define v (prove-zero (* 'a (- 'k (* 'm (square 'omega))))))
  (define equations (verdict-conditions v))
  (check-equal? (map expression (read-expression (printed equations)))
                '((= k (* m (expt omega 2)))))
  (check-equal? (read-expression '(= k (* m (expt omega 2))))
                (list '= 'k (* 'm (expt 'omega 2))))
  (check-equal? (read-expression (map expression (verdict-alternatives v)))
                (list (list (list '= 'k (* 'm (expt 'omega 2))))))
  (check-equal? (assuming ((read-expression "(> (* 2 m) 0)")) (assumptions 'declared))
                '((> (* 2 m) 0))))

(test-case "what is read is a value like any other"
  (check-equal? (simplify (read-expression '(+ a a))) (* 2 'a))
  (check-equal? (simplify (+ 1 (read-expression "(- (square (sin x)) 1)"))) (expt (sin 'x) 2))
  (check-equal? (read-expression '(+ 1 2 (/ 6 3))) 5)
  (check-exn exn:fail:contract:divide-by-zero? (lambda () (read-expression '(/ a 0))))
  (check-equal? (read-expression '(* 2 (up a b))) (up (* 2 'a) (* 2 'b)))
  (check-equal? (read-expression "(list a (up b))") (list 'a (up 'b))))

(test-case "quotes, comments and several lines are as readers paste them"
  (check-equal? (read-expression "(+ 'a (sin\n  'b)) ; a sum") (+ 'a (sin 'b)))
  (check-equal? (read-expression ''a) 'a)
  (check-equal? (read-expression "#(a (+ b c))") (up 'a (+ 'b 'c)))
  (check-equal? (read-expression (list '+ 1 (sin 'x))) (+ 1 (sin 'x)))
  (check-equal? (read-expression (up 'a 'b)) (up 'a 'b))
  (check-equal? (read-expression '(cot x)) (/ 1 (tan 'x))))

(test-case "of a port one after the other"
  (define port (open-input-string "(+ a b) (up 1 2)"))
  (check-equal? (read-expression port) (+ 'a 'b))
  (check-equal? (read-expression port) (up 1 2))
  (check-pred eof-object? (read-expression port)))

(test-case "what is shared is read once"
  (define big (for/fold ([e 'x]) ([i 60]) (sin (+ (square e) (/ 'a e)))))
  (check-equal? (read-expression (expression big)) big)
  (define within (for/fold ([e 'x]) ([i 60]) (x (* e (+ 'a e)))))
  (check-equal? (read-expression (expression within)) within))

(says
 [(read-expression sin)
  "read-expression: the procedure `sin` is no expression\n"
  "  a function is no expression, but its value at 't is one"]
 [(read-expression #t) "read-expression: #t is no expression"]
 [(read-expression '()) "read-expression: () is no expression"]
 [(read-expression '(+ a "b")) "read-expression: \"b\" is no expression\n  in: (+ a \"b\")"]
 [(read-expression '(a . 2)) "read-expression: (a . 2) is no expression"]
 [(read-expression '(2 x)) "read-expression: 2 is no expression\n  in: (2 x)"]
 [(read-expression '(D x))
  "read-expression: (D x) is no expression\n"
  "  it is written like a function; an expression is its value, as ((D x) t)"]
 [(read-expression '(sin x y)) "read-expression: (sin x y) is no expression\n"
                                  "  `sin` takes another number of values"]
 [(read-expression '(= a)) "read-expression: (= a) is no expression\n"
                           "  it has a left side and a right side: (= left right)"]
 [(read-expression "(power-series 1 1 1/2 ...)")
  "read-expression: ... is no expression\n  in: (power-series 1 1 1/2 ...)\n"
  "  it stands for what was not printed; (print-limit #f) has all of an expression printed"]
 [(read-expression "(+ a b)) c")
  "read-expression: the text is no whole expression\n  at character 8: unexpected `)`"]
 [(read-expression "(+ a b") "read-expression: the text is no whole expression\n"
                             "  at character 1: expected a `)` to close `(`"]
 [(read-expression "2 x") "read-expression: expected one expression; the text has several\n"
                          "  text: \"2 x\"\n  a formula as on paper is read by read-infix"]
 [(read-expression "x ! x") "read-expression: expected one expression; the text has several\n"
                            "  text: \"x ! x\""]
 [(read-expression " ") "read-expression: there is no expression in the text\n  text: \" \""])
