#lang racket/base
;; Verdicts on values of every shape.  How an expression is judged is tested with
;; the algebra.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/generic/up-down
         mechanics/value/matrix/matrix
         mechanics/value/series/series-access
         mechanics/value/simplify
         mechanics/value/signature
         mechanics/calculus/derivative
         mechanics/calculus/literal-function
         mechanics/verdict/prove-zero
         mechanics/verdict/verdict
         (only-in "../support/messages.rkt" check-message)
         "../support/checks.rkt")

(define V (literal-function 'V))
(define F (literal-function 'F (-> (X Real Real) Real)))
(define pythagoras (g:- (g:+ (g:square (g:sin 'x)) (g:square (g:cos 'x))) 1))

(test-case "scalars: proved or refuted"
  (for ([x (list 0 pythagoras (g:- (V 't) (V 't)))])
    (check-eq? (verdict-status (prove-zero x)) 'proved))
  (for ([x (list 1 'a (g:- 'a 'b) (V 't) (g:+ 1 pythagoras))])
    (check-eq? (verdict-status (prove-zero x)) 'refuted)))

(test-case "a structure or matrix is zero when every scalar of it is"
  (check-true (proved? (prove-zero (up 0 (down pythagoras (vector 0 0))))))
  (check-true (refuted? (prove-zero (up 0 (down pythagoras 'a)))))
  (check-true (proved? (prove-zero (matrix-by-rows (list pythagoras 0)))))
  (check-true (refuted? (prove-zero (matrix-by-rows '(0 1)))))
  (check-true (proved? (prove-zero (up)))))

(test-case "a function is judged at symbolic arguments, also inside structures"
  (check-true (proved? (prove-zero (g:- (D (g:square V)) (g:* 2 V (D V))))))
  (check-true (refuted? (prove-zero (g:- (D V) V))))
  (check-true
   (proved? (prove-zero (g:- ((partial 0) ((partial 1) F)) ((partial 1) ((partial 0) F))))))
  (check-true (proved? (prove-zero (up (g:- V V) 0)))))

(test-case "equality is a difference of zero"
  (check-true (proved? (verify-equal (g:* 'a (g:+ 'b 'c)) (g:+ (g:* 'a 'b) (g:* 'a 'c)))))
  (check-true (refuted? (verify-equal (up 'a 1) (up 1 'a))))
  (check-exn #rx"their orientations differ" (lambda () (verify-equal (up 1) (down 1)))))

(test-case "decimals are compared each with its partner, in a tuple as alone"
  (define (lines a b) (map caddr (cdr (verdict-lines (verify-equal a b)))))
  (check-equal? (cdr (lines (up 0.3) (up (+ 0.1 0.2)))) (lines 0.3 (+ 0.1 0.2)))
  (for ([pair '((0.1 0.1) (1/10 0.1) (0.1 1/10))])
    (define v (apply verify-equal pair))
    (check-equal? (verdict-reason v) 'decimals)
    (check-regexp-match #rx"\n  decimals: .*for 0.1" (format "~a" v)))
  (check-regexp-match #rx"evidence: decimals cancel, and" (format "~a" (prove-zero 0.0))))

(test-case "the residual of an equation is its left side without its right one, 0 or not"
  (for* ([a (list 0 'a 2)] [b (list 0 'b 3)])
    (check-equal? (verdict-residual (verify-equal a b)) (simplify (g:- a b)))))

(test-case "a series that ends is judged as a whole, of one that does not the first terms"
  (check-true (proved? (prove-zero (series 0 pythagoras))))
  (define v (prove-zero (g:- (g:exp (power-series 0 1)) (g:exp (power-series 0 1)))))
  (check-equal? (verdict-reason v) 'series)
  (check-regexp-match (string-append "^undecided: the residual is neither proved nor refuted to be "
                                     "zero\n  examined: terms up to order 7 of a series")
                      (format "~a" v)))

(test-case "a series within a tuple is judged as one alone"
  (check-true (proved? (prove-zero (up 0 (series 0 pythagoras)))))
  (define endless (g:- (g:exp (power-series 0 1)) (g:exp (power-series 0 1))))
  (check-equal? (verdict-reason (prove-zero (up 0 endless))) 'series))

(test-case "a verdict that is not undecided has no reason to be"
  (for ([x (list 0 pythagoras 'a (up 0 'a))]) (check-false (verdict-reason (prove-zero x)))))

(test-case "a number as small as rounding leaves is undecided on either side of 0"
  (check-true (undecided? (verify-equal 1e-17 0)))
  (check-true (undecided? (verify-equal 0 1e-17))))

(test-case "a witness is a point where the residual has the value that is given"
  (for ([x (list (g:- 'a 'b) (g:- (g:square (g:sin 'a)) 1) (up 0 (g:- (V 't) 1))
                 (g:- 'k (g:* 'm (g:square 'omega))))])
    (define v (prove-zero x))
    (define value
      (simplify (apply substitute (verdict-residual v)
                       (apply append (for/list ([w (verdict-witness v)]) (list (car w) (cdr w)))))))
    (check-true (for/or ([scalar (if (structure? value) (structure-elements value) (list value))])
                  (equal? scalar (verdict-value v))))
    (check-false (equal? 0 (verdict-value v)))))

(test-case "a proved verdict has no witness"
  (define v (prove-zero pythagoras))
  (check-false (verdict-witness v))
  (check-false (verdict-value v))
  (check-equal? (verdict-residual v) 0))

(test-case "what cannot be judged is named"
  (check-exn
   #rx"^prove-zero: expected a number, an expression, a tuple of them, or a function\n  given: \"x\", a string$"
   (lambda () (prove-zero "x")))
  (check-exn #rx"^prove-zero: .*given: [(]1 2[)], a list" (lambda () (prove-zero '(1 2))))
  (check-exn #rx"^prove-zero: expected the variables, a list of symbols\n  given: [(]x 1[)]"
             (lambda () (prove-zero 0 #:variables '(x 1))))
  (check-exn #rx"^prove-zero: D is an operator; give it a function to act on"
             (lambda () (prove-zero D))))

(test-case "a verdict prints its status first, in all three modes"
  (for ([mode '("~a" "~s" "~v")])
    (check-regexp-match #rx"^proved: " (format mode (prove-zero 0)))
    (check-regexp-match #rx"^refuted: .*\n  residual: " (format mode (prove-zero 'a)))))

;; ---------------------------------------------------------------------------
;; The report

(define (last-line v) (cadr (regexp-match #rx"([^\n]*)$" (format "~a" v))))

(test-case "a bound is given to two digits, rounded upwards"
  (check-regexp-match #rx"\n  evidence: at one point, zero to within 1.3e-15\n"
                      (format "~a" (prove-zero 1.234e-15)))
  (check-regexp-match #px"\n  evidence: at 12 points, zero to within [0-9]([.][0-9])?e-[0-9]+\n"
                      (format "~a" (verify-equal (g:* 0.12345678901 'x)
                                                 (g:* 0.12345678901000001 'x)))))

(test-case "several conditions stand on one line, and none speaks of the time"
  (define v (prove-zero (lambda (t) (g:+ (g:* (g:- 'a 'b) (g:sin t))
                                         (g:* (g:- 'c (g:square 'd)) (g:cos t))))))
  (check-regexp-match #rx"\n  zero if: a = b, c = [(]expt d 2[)]\n" (format "~a" v))
  (check-equal? (verdict-conditions (prove-zero (lambda (t) (g:- 'g (g:* 6 'c t))))) '()))

(test-case "of conditions together none that takes a single symbol for 0 is told"
  (define v (prove-zero (lambda (t) (g:+ (g:* 'a (g:sin t)) (g:* (g:- 'b 'c) (g:cos t))))))
  (check-equal? (verdict-conditions v) '()))

(test-case "what several components assume is told once, a step inwards"
  (define r (g:sqrt (g:square 'm)))
  (define v (verify-equal (up r (g:* 2 r)) (up 'm (g:* 2 'm))))
  (check-equal? (verdict-assumptions v) '((>= m 0)))
  (check-equal? (last-line v) "  assuming: (>= m 0)"))

(test-case "decimals are shown to twelve digits, exact numbers to all"
  (check-regexp-match #rx"\n  residual: [(][*] 0.123456789012 x[)]\n"
                      (format "~a" (prove-zero (g:* 0.1234567890123 'x))))
  (check-regexp-match #rx"\n  residual: [(][*] 1234567890123/1000 x[)]\n"
                      (format "~a" (prove-zero (g:* 1234567890123/1000 'x)))))

(test-case "scalars of a tuple and of a matrix are named by their places"
  (define (names v)
    (for/list ([line (verdict-lines v)] #:when (and (eqv? (car line) 1) (not (caddr line))))
      (cadr line)))
  (check-equal? (names (prove-zero (up 0 (down 0 'a) 'b))) '("component 1 1" "component 2"))
  (check-equal? (names (prove-zero (matrix-by-rows '(0 a) '(b 0))))
                '("row 0, column 1" "row 1, column 0"))
  (check-equal? (names (prove-zero 'a)) '()))

(test-case "all of a tuple vanishes where each of its components does, if there is a way"
  (check-equal? (verdict-alternatives (prove-zero (up (g:- 'a 'b) 1))) '())
  (define v (prove-zero (up (g:- 'a 'b) (g:- 'b 'c))))
  (check-equal? (map length (verdict-alternatives v)) '(2))
  (check-regexp-match #rx"\n  all zero if: " (format "~a" v))
  (check-regexp-match #rx"\n  zero if: a = b$"
                      (format "~a" (prove-zero (up (g:- 'a 'b) (g:- 'b 'a))))))

(test-case "of many decimals four are shown, and how many more there are"
  (define x (g:- (g:+ (g:* 0.1 'a) (g:* 0.2 'b) (g:* 0.3 'c) (g:* 0.4 'd) (g:* 0.7 'e))
                 (g:+ (g:* 1/10 'a) (g:* 1/5 'b) (g:* 3/10 'c) (g:* 2/5 'd)
                      (g:* 0.7000000000000001 'e))))
  (check-regexp-match #rx"and 2 more" (format "~a" (prove-zero x))))

(test-case "a symbol that is spelt like π is told, wherever it stands"
  (for ([x (list 'pi (g:* 'a 'pi) (up 'a 'pi 'b))])
    (check-regexp-match #rx"\n  note: the symbol pi is an unknown" (format "~a" (prove-zero x)))))

(test-case "a value of many digits is shown to six"
  (check-equal? (last-line (prove-zero (g:* (expt 10 60) 'm))) "  value: 1e+60")
  (check-equal? (last-line (prove-zero (g:/ 1 3))) "  value: 1/3"))

(test-case "what is no verdict is refused by the name that was called"
  (for ([f (in-list (list proved? refuted? undecided? verdict-status verdict-residual
                          verdict-witness verdict-value verdict-assumptions verdict-conditions
                          verdict-factored verdict-kinks verdict-readings verdict-reason
                          verdict-remarks))])
    (check-message (format (string-append "~a: expected a verdict, such as verify-solution or "
                                          "prove-zero gives\n  given: the number 5")
                           (object-name f))
                   (f 5))))
