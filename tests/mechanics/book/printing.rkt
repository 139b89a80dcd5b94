#lang racket/base
;; Every value prints, in each of Racket's three modes, as the expression that
;; makes it: no address, no tag, no dual number, no internal name.

(require mechanics "../support/checks.rkt")

(define x (literal-function 'x))
(define F (literal-function 'F (-> (X Real Real) Real)))
(define (L local) (square (velocity local)))
(define (friction local) (* -1 (velocity local)))

(define-syntax-rule (with-texts [value text] ...)
  (list (cons value text) ...))

(define values-and-texts
  (with-texts
    [(up 1 'a (down 2.5 1/2)) "(up 1 a (down 2.5 1/2))"]
    [(sin 'a) "(sin a)"]
    [(+ 'a (* 2 (x 't))) "(+ a (* 2 (x t)))"]
    [(matrix-by-rows '(1 a) '(0 2)) "(matrix-by-rows (list 1 a) (list 0 2))"]
    [x "x"]
    [(D x) "(D x)"]
    [((expt D 2) x) "((expt D 2) x)"]
    [((partial 1) F) "((partial 1) F)"]
    [(((partial 1) F) 'a 'b) "(((partial 1) F) a b)"]
    [D "D"]
    [I "I"]
    [Dt "Dt"]
    [(partial 1 0) "(partial 1 0)"]
    [(* (+ D 1) (- D x)) "(* (+ D 1) (- D x))"]
    [(commutator D x) "(- (* D x) (* x D))"]
    [(delta x) "(delta x)"]
    [(((delta x) square) x) "(((delta x) square) x)"]
    [(+ x sin) "(+ x sin)"]
    [(sqrt (+ 1 (square x))) "(sqrt (+ 1 (square x)))"]
    [(compose x sin) "(compose x sin)"]
    [(constant-function 3) "(constant-function 3)"]
    [(component 1 0) "(component 1 0)"]
    [(ref L 1) "(ref L 1)"]
    [(dot-product x x) "(dot-product x x)"]
    [(determinant L) "(determinant L)"]
    [(Gamma x) "(Gamma x)"]
    [(Gamma (up x x) 4) "(Gamma (up x x) 4)"]
    [(F->C p->r) "(F->C p->r)"]
    [(Lagrange-equations L) "(Lagrange-equations L)"]
    [(Lagrange-equations L #:force friction) "(Lagrange-equations L #:force friction)"]
    [((Lagrange-equations L) x) "((Lagrange-equations L) x)"]
    [(Euler-Lagrange-operator L) "(Euler-Lagrange-operator L)"]
    [((D (lambda (a) (lambda (b) (* a b)))) 3) "((D <function>) 3)"]
    [((D (lambda (a) (up (lambda (b) (* a b)) a))) 'q) "(up (ref ((D <function>) q) 0) 1)"]
    [(up sin x (lambda (t) t)) "(up sin x <function>)"]))

(define (printed mode value) (format mode value))

(test-case "each value in each mode, alone and in a list"
  (for ([entry values-and-texts])
    (define value (car entry))
    (define text (cdr entry))
    (for ([mode '("~a" "~s" "~v")])
      (check-equal? (printed mode value) text))
    (check-equal? (printed "~s" (list value)) (string-append "(" text ")"))
    (check-equal? (printed "~v" (list value)) (string-append "(list " text ")"))))

(define-namespace-anchor here)

(test-case "what is printed makes the value again"
  (define namespace (namespace-anchor->namespace here))
  (for ([value (list (up 1 (down 2 1/2)) (matrix-by-rows '(1 2) '(3 4)) (x 2) (((expt D 2) x) 3)
                     (((partial 0) F) 1 2) x (sin (x 1)))])
    (check-equal? (eval (read (open-input-string (printed "~s" value))) namespace) value))
  (for ([f (list (D x) (+ x sin) (compose x sin) (sqrt (+ 1 (square x))) (- x) (* 2 (cube x))
                 ((* (+ D 1) (- D x)) x) ((Lagrange-equations L) x))])
    (define again (eval (read (open-input-string (printed "~s" f))) namespace))
    (check-equal? (again 't) (f 't))))

(define (take-three xs) (list (car xs) (cadr xs) (caddr xs)))

(test-case "a dual number inside a running function shows itself as its value"
  (define seen '())
  (define (f t)
    (set! seen (list* (printed "~a" t) (printed "~s" (up t 1)) (printed "~v" (list (* 2 t))) seen))
    (square t))
  (void ((D f) 'q))
  (check-equal? (take-three seen) '("q" "(up q 1)" "(list (* 2 q))"))
  (set! seen '())
  (void (((expt D 2) f) 'q))
  (check-equal? (take-three seen) '("q" "(up q 1)" "(list (* 2 q))")))

(test-case "long values stop and say how much is left out"
  (define big (for/fold ([e 'x]) ([_ 40]) (sin (* e (+ e 1)))))
  (parameterize ([print-limit 30])
    (check-regexp-match #rx" [.][.][.][0-9]+ more" (printed "~a" big))
    (check-true (< (string-length (printed "~a" big)) 1000)))
  (check-true (< (string-length (printed "~a" big)) 40000)))
