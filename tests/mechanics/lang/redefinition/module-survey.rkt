#lang racket/base
;; A name that a `#lang mechanics` module neither defines again nor uses before it replaces it
;; is defined as in any module of Racket.

(require racket/match
         "../../support/checks.rkt" "../../support/run-text.rkt")

;; How often the core forms `define-values` and `set!` of a name stand in the
;; expansion of a module: (list definitions assignments).
(define (expanded name . text)
  (define module-text (apply lines language text))
  (define expansion
    (parameterize ([current-namespace (namespace)]
                   [read-accept-reader #t]
                   [read-accept-lang #t])
      (syntax->datum (expand (read-syntax 'example (open-input-string module-text))))))
  (define (count head)
    (let count ([form expansion])
      (match form
        [(list (== head) (or (== name) (list _ ... (== name) _ ...)) _) 1]
        [(? list?) (apply + (map count form))]
        [_ 0])))
  (list (count 'define-values) (count 'set!)))

(test-case "only what is defined again, or replaced after it was used, is assigned"
  (define once '(1 0))
  (define (assigned n) (list 1 n))
  (define (check expected name . text)
    (check-equal? (apply expanded name text) expected (format "~a in ~s" name text)))
  (check once 'f "(define (f) (g))" "(define (g) (f))")
  (check once 'g "(define (f) (g))" "(define (g) (f))" "(define (f) 1)")
  (check (assigned 1) 'f "(define (f) (g))" "(define (g) (f))" "(define (f) 1)")
  (check (assigned 2) 'x "(define x 1)" "(define x 2)" "(define x 3)")
  (check once 'square "(define (f) (square 1))" "(define (square x) x)" "(f)")
  (check once 'square "'square" "(define (square x) (square x))")
  (check (assigned 1) 'square "(define (f) (square 1))" "(f)" "(define (square x) x)")
  (for ([use '("(define (f square) (square 1)) (f list)"
               "(define ((f a) (up b square) [c square]) (square 1)) (f 2)"
               "(define ((f square) a) (square 1)) ((f list) 1)"
               "((lambda square square) 1)"
               "(let* ([square 1] [cube square] [(up a b) (up square 2)]) cube)"
               "(let square ([n 2]) (if (= n 0) 'end (square (- n 1))))"
               "(define (f) (define (square) 1) (define cube square) (cube)) (f)"
               "(define (f) (square 1))"
               "(define (f) (g)) (define (g) (square 1)) '(f)"
               "(struct point (square))")])
    (check once 'square use "(define (square x) x)"))
  (for ([use '("(define (f [a (square 1)] [square 2]) a) (f)"
               "(define (f) (g)) (define (g) (square 1)) (define y (f))"
               "(let ([square (square 1)]) square)"
               "(define f (list square))"
               "(define-syntax-rule (f) (square 1)) (f)"
               "(begin (define (f) (square 1)) (f))"
               "((lambda (f) (f 1)) square)")])
    (check (assigned 1) 'square use "(define (square x) x)"))
  (check once 'first "(require racket/list)" "(define (first x) x)" "(first 1)")
  (check (assigned 1) 'first "(require racket/list)" "(first '(1))" "(define (first x) x)"))
