#lang racket/base
;; Taylor series of functions, and exponentials of operators.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/generic/up-down
         mechanics/value/compose
         mechanics/value/operator
         mechanics/value/signature
         mechanics/value/simplify
         mechanics/value/series/series-access
         mechanics/value/series/calculus
         mechanics/calculus/derivative
         mechanics/calculus/literal-function
         mechanics/calculus/Taylor
         "../support/checks.rkt" "../support/random.rkt" "../support/same.rkt"
         "../support/laws/derivation.rkt")

(define-syntax-rule (check-same a b) (check-true (same? a b)))
(define (head s [n 6]) (series:head s n))

(define f (literal-function 'f))
(define g (literal-function 'g))
(define F (literal-function 'F (-> (UP Real (UP Real Real)) Real)))

;; ---------------------------------------------------------------------------

(test-case "the coefficients are derivatives divided by factorials"
  (check-equal? (head ((Taylor-series g:sin) 0)) '(0 1 0 -1/6 0 1/120))
  (check-equal? (head (Taylor-series-coefficients g:exp 0) 4) '(1 1 1/2 1/6))
  (for ([k 10])
    (check-same (series:ref ((Taylor-series f) 'x) k)
                (g:/ (((g:expt D k) f) 'x) (for/product ([j (in-range 1 (add1 k))]) j)))))

(test-case "the terms at an increment sum up to the function"
  (with-seed 621
    (for ([_ 20])
      (define h (random-function))
      (define a (random-flonum))
      (check-= (series:sum (((Taylor-series h) a) 0.01) 8) (h (+ a 0.01)) 1e-9))))

(test-case "of a polynomial the terms end in zeros"
  (check-equal? (head ((Taylor-series g:cube) 2)) '(8 12 6 1 0 0))
  (check-equal? (map simplify (head (((Taylor-series g:cube) 'x) (g:- 'x)) 5))
                (map simplify (list (g:expt 'x 3) (g:* -3 (g:expt 'x 3)) (g:* 3 (g:expt 'x 3))
                                    (g:- (g:expt 'x 3)) 0))))

(test-case "a function of a structure has terms in a structure of increments"
  (define about (up 't (up 'x 'y)))
  (define by (up 'dt (up 'dx 'dy)))
  (define s ((Taylor-series F) about))
  (define terms (s by))
  (check-same (series:ref terms 0) (F about))
  (check-same (series:ref terms 1) (g:* ((D F) about) by))
  (check-same (series:ref terms 2) (g:* 1/2 (g:* ((D (D F)) about) by) by))
  (check-same (series:ref s 2) (g:/ ((D (D F)) about) 2))
  (check-same (series:ref (((Taylor-series (lambda (x y) (g:* x (g:square y)))) 'x 'y) (up 'dx 'dy))
                          3)
              (g:* 'dx (g:square 'dy))))

(test-case "the values may have any shape"
  (define s (((Taylor-series (lambda (t) (up (g:cos t) (g:square t)))) 0) 'h))
  (check-equal? (head s 4)
                (list (up 1 0) (up 0 0) (up (g:* -1/2 (g:expt 'h 2)) (g:expt 'h 2)) (up 0 0)))
  (define k ((Taylor-series (lambda (x) (lambda (y) (g:exp (g:* x y))))) 0))
  (check-same ((series:ref k 3) 'y) (g:/ (g:expt 'y 3) 6)))

(test-case "as many terms as are wanted"
  (check-equal? (series:ref ((Taylor-series (lambda (x) (g:/ 1 (g:- 1 x)))) 0) 100) 1)
  (define runs 0)
  (define s ((Taylor-series (lambda (x) (set! runs (add1 runs)) (g:exp x))) 0))
  (series:head s 30)
  (check-equal? runs 5)
  (series:head s 30)
  (check-equal? runs 5))

(test-case "Taylor series are differentiated and nest"
  (check-same (D ((Taylor-series g:sin) 'x)) ((Taylor-series g:cos) 'x))
  (check-same ((D (lambda (x) (series:ref ((Taylor-series f) x) 2))) 'x)
              (g:/ (((g:expt D 3) f) 'x) 2))
  (check-same (((Taylor-series f) 'x) (power-series 0 1)) ((Taylor-series f) 'x)))

(test-case "an unknown function of a series is its Taylor series about the first term"
  (define t (power-series 'a 'b 'c))
  (check-same (series:ref (f t) 2)
              (g:+ (g:* ((D f) 'a) 'c) (g:* 1/2 (((g:expt D 2) f) 'a) (g:square 'b))))
  (check-same ((g:* f g) t) (g:* (f t) (g t)))
  (check-same (series:derivative (f t)) (g:* ((D f) t) (series:derivative t)))
  (check-same (f (series 2 0)) (f 2))
  (check-exn #rx"^F: was declared" (lambda () (F t))))

(test-case "misuse is explained"
  (check-exn #rx"^Taylor-series: needs a function; 3 is a number" (lambda () (Taylor-series 3)))
  (check-exn
   #rx"^Taylor-series: the increment must have the shape of the argument\n  argument: .up 1 2.\n  increment: 3$"
   (lambda () (series:ref (((Taylor-series F) (up 1 2)) 3) 1))))

;; ---------------------------------------------------------------------------
;; Exponentials of operators

(define x identity)

(test-case "exp(hD) shifts the argument: its value is the Taylor series"
  (check-equal? (format "~a" (g:exp (g:* 'h D))) "(exp (* h D))")
  (check-pred operator? (g:exp D))
  (check-same (((g:exp (g:* 'h D)) f) 'x) (((Taylor-series f) 'x) 'h))
  (check-equal? (map simplify (head (((g:exp (g:* 'h D)) g:cube) 'x) 5))
                (map simplify (list (g:expt 'x 3) (g:* 3 'h (g:square 'x)) (g:* 3 (g:square 'h) 'x)
                                    (g:expt 'h 3) 0)))
  (check-= (series:sum (((g:exp (g:* 0.5 D)) g:sin) 0.3) 20) (sin 0.8) 1e-14))

(test-case "exponentials of one operator multiply by adding exponents"
  (check-same ((g:* (g:exp (g:* 'a D)) (g:exp (g:* 'b D))) f)
              ((g:exp (g:* (g:+ 'a 'b) D)) f))
  (check-same (((g:* (g:exp (g:* 'a D)) (g:exp (g:* 'b D))) f) 't)
              (((g:exp (g:* (g:+ 'a 'b) D)) f) 't))
  (check-same (((g:* (g:exp D) (g:exp (g:- D))) f) 't) (f 't)))

(test-case "exp(x D) stretches the argument"
  (check-equal? (map simplify (head (((g:exp (g:* 'h x D)) g:square) 'x) 4))
                (map simplify (list (g:expt 'x 2) (g:* 2 'h (g:expt 'x 2))
                                    (g:* 2 (g:expt 'h 2) (g:expt 'x 2))
                                    (g:* 4/3 (g:expt 'h 3) (g:expt 'x 2))))))

(test-case "the exponential of a series of functions is that of each, by orders"
  (define E (g:exp (g:* 'h D)))
  (define s ((E (series f g)) 't))
  (check-same s (g:+ ((E f) 't) ((series x ((E g) 't)) 0)))
  (check-same (series:ref s 2)
              (g:+ (g:/ (g:* (g:square 'h) (((g:expt D 2) f) 't)) 2) (g:* 'h ((D g) 't)))))

(test-case "exponentials by exercise 6.10: the conjugate of an operator"
  ;; e^A B e^-A = B + [A, B] + [A, [A, B]]/2! + ..., order by order in h
  (define A (g:* 'h x D))
  (define B D)
  (define conjugate ((g:* (g:exp A) (g:* B (g:exp (g:- A)))) f))
  (define C1 (commutator A B))
  (define C2 (commutator A C1))
  (check-same (series:ref (conjugate 't) 1) ((C1 f) 't))
  (check-same (series:ref (conjugate 't) 2) (g:/ ((C2 f) 't) 2)))

(test-case "exercise 6.11: Baker, Campbell and Hausdorff, to order three"
  (define A (g:* x D))
  (define B (g:* (g:square x) D))
  (define C
    (series 0
            (g:+ A B)
            (g:/ (commutator A B) 2)
            (g:/ (g:+ (commutator A (commutator A B)) (commutator B (commutator B A))) 12)))
  (define by-exponents (((g:* (g:exp A) (g:exp B)) f) 't))
  (define by-C (((g:+ 1 C (g:/ (g:expt C 2) 2) (g:/ (g:expt C 3) 6)) f) 't))
  (for ([k 4]) (check-same (series:ref by-exponents k) (series:ref by-C k)))
  (define without ((g:+ 1 (series 0 (g:+ A B)) (g:/ (g:expt (series 0 (g:+ A B)) 2) 2)) f))
  (check-false (same? (series:ref by-exponents 2) (series:ref (without 't) 2))))

(test-case "iterated derivatives, exercise 6.8"
  (define fg (g:* f g))                 ; the rule of Leibniz
  (check-same (g:expt (g:* 'h D) 4) (g:* (g:expt 'h 4) (g:expt D 4)))
  (check-same (((g:expt D 4) fg) 't)
              (for/fold ([sum 0]) ([k 5] [binomial '(1 4 6 4 1)])
                (g:+ sum (g:* binomial (((g:expt D k) f) 't) (((g:expt D (- 4 k)) g) 't)))))
  (check-same (((g:exp (g:* 'h D)) fg) 't)
              (g:* (((g:exp (g:* 'h D)) f) 't) (((g:exp (g:* 'h D)) g) 't))))
