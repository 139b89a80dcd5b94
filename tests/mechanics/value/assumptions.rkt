#lang racket/base
;; Declaring, scoping, listing and withdrawing assumptions, as users do.

(require (except-in mechanics define lambda let let* case-lambda λ)
         "../support/checks.rkt" "../support/messages.rkt")

;; Each test has a session of its own.
(define-syntax-rule (session name body ...)
  (test-case name
    (dynamic-wind forget-assumptions (lambda () body ...) forget-assumptions)))

(define (shown x)
  (define port (open-output-string))
  (parameterize ([current-output-port port]) (print-expression x))
  (get-output-string port))

;; ---------------------------------------------------------------------------
;; A session

(session "a declared sign is used, and not told as an assumption"
  (check-equal? (shown (sqrt (square 'r))) "r\n; assuming (>= r 0)\n")
  (assume '(>= r 0))
  (check-equal? (shown (sqrt (square 'r))) "r\n")
  (assume '(< x 0))
  (check-equal? (simplify (sqrt (square 'x))) (* -1 'x))
  (check-equal? (shown (up (abs 'x) (sqrt (square 'y)))) "(up (* -1 x) y)\n; assuming (>= y 0)\n"))

(session "a symbol quoted within the quote is that symbol"
  (assume '(> 'm 0) '(< 'x (* 2 'y)))
  (check-equal? (assumptions) '((> m 0) (< x (* 2 y))))
  (check-equal? (shown (sqrt (square 'm))) "m\n"))

(session "every form honours what is declared"
  (assume '(< x 0))
  (define r (sqrt (square 'x)))
  (check-equal? (expression (expand (* r (+ 'a 1)))) '(+ (* -1 a x) (* -1 x)))
  (check-equal? (expression (factor (- (* 'a r) (* 'b 'x)))) '(* -1 x (+ a b)))
  (check-equal? (expression (collect (* r 'a) 'a)) '(* -1 a x))
  (check-equal? (expression (coefficient (* r 'a) 'a 1)) '(* -1 x))
  (check-equal? (expression (together (/ 1 r))) '(/ -1 x))
  (check-equal? (expression (denominator (/ 1 (* r 'b)))) '(* b x))
  (check-equal? (expression (apart (/ r (* 's (+ 's 'x))) 's))
                (expression (apart (/ (* -1 'x) (* 's (+ 's 'x))) 's))))

(session "declared and used assumptions are listed, and told apart"
  (check-equal? (assumptions) '())
  (assume '(> m 0) '(positive k l) '(> a b c))
  (simplify (sqrt (square 'r)))
  (check-equal? (assumptions 'declared) '((> m 0) (> k 0) (> l 0) (> a b) (> b c)))
  (check-equal? (assumptions 'used) '((>= r 0)))
  (check-equal? (assumptions) '((> m 0) (> k 0) (> l 0) (> a b) (> b c) (>= r 0)))
  (assume '(>= r 0))
  (check-equal? (assumptions 'used) '())
  (check-message (string-append "assumptions: expected 'declared or 'used, or no argument\n"
                                "  given: the symbol all")
                 (assumptions 'all)))

(session "assumptions are withdrawn, all or some"
  (assume '(> m 0) '(> k 0) '(> (* m r) 0))
  (check-equal? (shown (sqrt (square 'r))) "r\n")
  (forget-assumptions '(> m 0))
  (check-equal? (assumptions) '((> k 0) (> (* m r) 0)))
  (check-equal? (shown (sqrt (square 'r))) "r\n; assuming (>= r 0)\n")
  (check-message "forget-assumptions: (> q 0) was not declared\n  declared: (> k 0), (> (* m r) 0)"
                 (forget-assumptions '(> q 0)))
  (forget-assumptions)
  (check-equal? (assumptions) '())
  (check-message "forget-assumptions: (> q 0) was not declared; nothing is"
                 (forget-assumptions '(> q 0))))

(session "values may stand within a relation"
  (assume `(> ,(- 'a 'b) 0) (list '>= ((literal-function 'r) 't) 0))
  (check-equal? (assumptions) '((> (- a b) 0) (>= (r t) 0)))
  (check-equal? (shown (sqrt (square ((literal-function 'r) 't)))) "(r t)\n"))

;; ---------------------------------------------------------------------------
;; Scopes

(session "assuming holds for its body, whose value is simplified in it"
  (check-equal? (expression (assuming ('(< x 0)) (sqrt (square 'x)))) '(* -1 x))
  (check-equal? (expression (simplify (sqrt (square 'x)))) 'x)
  (check-equal? (assuming ('(> x 0)) (assumptions 'declared)) '((> x 0)))
  (check-equal? (assumptions 'declared) '()))

(session "a result shows the assumptions of a scope it has left"
  (check-equal? (shown (assuming ('(< x 0)) (sqrt (* (square 'x) (square 'z)))))
                "(* -1 x z)\n; assuming (< x 0)\n; assuming (>= z 0)\n"))

(session "scopes nest, and give several values, tuples, lists, functions"
  (check-equal? (assuming ('(> a 0)) (assuming ('(< b 0)) (expression (simplify (abs (* 'a 'b))))))
                '(* -1 a b))
  (define-values (u v) (assuming ('(< x 0)) (values (abs 'x) (up (abs 'x) 1))))
  (check-equal? (expression u) '(* -1 x))
  (check-equal? (expression v) '(up (* -1 x) 1))
  (check-equal? (map expression (assuming ('(< x 0)) (list (abs 'x) 1))) '((* -1 x) 1))
  (check-equal? ((assuming ('(< x 0)) sin) 0) 0))

(session "a scope ends however it is left"
  (with-handlers ([void void]) (assuming ('(< x 0)) (error "out")))
  (check-equal? (assumptions) '())
  (check-equal? (let/ec k (assuming ('(< x 0)) (k (assumptions 'declared)))) '((< x 0)))
  (check-equal? (assumptions) '()))

(session "assume in a scope is for the scope"
  (assuming ('(> a 0)) (assume '(> b 0)))
  (check-equal? (assumptions) '()))

;; ---------------------------------------------------------------------------
;; Assuming nothing by itself

(session "the switch leaves absolute values"
  (parameterize ([automatic-assumptions #f])
    (check-equal? (shown (sqrt (square 'x))) "(abs x)\n")
    (check-eq? (verdict-status (verify-equal (sqrt (square 'x)) (abs 'x))) 'proved)
    (check-equal? (verdict-assumptions (verify-equal (sqrt (square 'x)) (abs 'x))) '())
    (check-eq? (verdict-status (verify-equal (sqrt (square 'x)) 'x)) 'refuted)
    (assume '(>= x 0))
    (check-equal? (shown (sqrt (square 'x))) "x\n"))
  (check-equal? (assumptions 'used) '()))

(session "the switch may be set for the session"
  (automatic-assumptions #f)
  (check-equal? (shown (sqrt (square 'x))) "(abs x)\n")
  (automatic-assumptions #t)
  (check-equal? (shown (sqrt (square 'x))) "x\n; assuming (>= x 0)\n"))

;; ---------------------------------------------------------------------------
;; Mistakes

(session "an ill-formed relation is refused, and nothing is declared"
  (assume '(> m 0))
  (check-message "assume: expected a quoted relation such as '(>= r 0); given the symbol x"
                 (assume 'x))
  (check-message "assume: expected a quoted relation such as '(>= r 0); given #t, a boolean"
                 (assume '(> k 0) #t))
  (check-message (string-append "assume: unknown relation ~; known are > >= < <= between"
                                " expressions, and positive, negative, nonpositive, nonnegative before some\n"
                                "  given: (~ r 0)")
                 (assume '(> k 0) '(~ r 0)))
  (check-message (string-append "assume: an equation is no assumption about a sign\n"
                                "  given: (= r 0)\n"
                                "  (impose L '(= r 0)) puts it into L, (verify-again verdict '(= r 0)) "
                                "into a question")
                 (assume '(= r 0)))
  (check-message "assume: the relation lacks an operand: (> r)" (assume '(> r)))
  (check-message (string-append "assume: expected an expression in the relation;"
                                " given \"a\", a string\n  in: (> (+ r \"a\") 0)")
                 (assume '(> (+ r "a") 0)))
  (check-message (string-append "assume: only real numbers are greater or less than others;"
                                " given 0+1i\n  in: (> r 0+1i)")
                 (assume '(> r +i)))
  (check-equal? (assumptions) '((> m 0))))

(session "a contradiction is refused, and nothing is declared"
  (assume '(> x 0) '(> a b))
  (check-message (string-append "assume: (< x 0) contradicts what was assumed: (> x 0)\n"
                                "  forget-assumptions withdraws what was assumed")
                 (assume '(> k 0) '(< x 0)))
  (check-message "assume: the relation cannot hold: (< (exp x) 0)" (assume '(< (exp x) 0)))
  (check-message "assume: the relations contradict each other: (> y 0), (< y 0)"
                 (assume '(> y 0) '(< y 0)))
  (check-message (string-append "assuming: (> b a) contradicts what was assumed: (> a b)\n"
                                "  forget-assumptions withdraws what was assumed")
                 (assuming ('(> b a)) 1))
  (check-equal? (assumptions) '((> x 0) (> a b))))

(define (syntax-message form)
  (parameterize ([current-namespace (make-base-namespace)])
    (namespace-require 'mechanics)
    (message-of (eval form) exn:fail:syntax?)))

(test-case "a relation without a quote is noticed where it is written"
  (check-regexp-match #rx"a relation is quoted here: write '[(]>= r 0[)]"
                      (syntax-message '(assume (>= r 0))))
  (check-regexp-match #rx"a relation is quoted here: write '[(]>= r 0[)]"
                      (syntax-message '(assuming ((>= r 0)) 1)))
  (check-regexp-match #rx"relations stand in parentheses: [(]assuming [(]'[(]>= r 0[)][)] body[)]"
                      (syntax-message '(assuming '(>= r 0))))
  (check-regexp-match #rx"expected relations in parentheses, then a body"
                      (syntax-message '(assuming ('(>= r 0))))))

(test-case "comparing symbols says how to declare a relation"
  (check-message (string-append ">=: an expression that is not a number has no order;"
                                " give its symbols values first\n"
                                "  as an assumption, the relation is quoted: (assume '(>= r 0))\n"
                                "  value: the symbol r")
                 (>= 'r 0)))

(session "assume is a function too"
  (apply assume '((> a 0) (> b 0)))
  (check-equal? (assumptions) '((> a 0) (> b 0))))

;; ---------------------------------------------------------------------------
;; Verdicts

(session "a verdict says what was given and what was assumed"
  (assume '(> m 0) '(> k 0))
  (define v (verify-equal (* (sqrt (square 'm)) (sqrt (square 'r))) (* 'm 'r)))
  (check-equal? (format "~a" v)
                "proved: the residual is zero\n  given: (> m 0)\n  assuming: (>= r 0)")
  (check-equal? (verdict-assumptions v) '((> m 0) (>= r 0)))
  (forget-assumptions)
  (check-equal? (format "~a" v)
                "proved: the residual is zero\n  given: (> m 0)\n  assuming: (>= r 0)"))

(session "a witness satisfies what is declared"
  (assume '(< x 0))
  (define v (verify-equal (sqrt (square 'x)) 'x))
  (check-eq? (verdict-status v) 'refuted)
  (check-true (< (cdr (assq 'x (verdict-witness v))) 0))
  (check-eq? (verdict-status (verify-equal (sqrt (square 'x)) (- 'x))) 'proved))

(session "where no point satisfies what is declared, the evidence says so"
  (assume '(> (* x (- 1 x) (- x 999999/1000000)) 0) '(< x 1) '(> x 0))
  (check-regexp-match #rx"no point was found where it has a real value and the assumptions hold"
                      (format "~a" (prove-zero 'x))))

;; ---------------------------------------------------------------------------
;; Threads

(session "four threads with assumptions of their own do not mix"
  (define (work sign)
    (assuming ((list (if (positive? sign) '> '<) 'x 0))
      (for/and ([i (in-range 30)])
        (equal? (simplify (* 'x (sqrt (square 'x)))) (simplify (* sign (square 'x)))))))
  (define results (make-vector 4 #f))
  (for-each thread-wait
            (for/list ([i (in-range 4)])
              (thread (lambda () (vector-set! results i (work (if (even? i) 1 -1)))))))
  (check-equal? results (make-vector 4 #t))
  (check-equal? (assumptions) '()))
