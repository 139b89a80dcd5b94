#lang racket/base
;; Dual numbers: order of tags, extraction, renaming, and what they look like.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/generic/up-down
         mechanics/generic/describe
         mechanics/generic/rounding
         mechanics/value/matrix/matrix
         mechanics/calculus/perturbed-value
         mechanics/calculus/dual
         mechanics/calculus/infinitesimal-part
         "../support/checks.rkt" "../support/random.rkt" "../support/same.rkt")

(test-case "a dual number without tangent is its value"
  (check-equal? (make-dual 1 'x 0) 'x)
  (check-pred dual? (make-dual 1 'x 0.0))
  (check-pred dual? (perturb 1 'x)))

(test-case "what is constant is a number, what only has no slope bears its ε"
  (define x (make-dual 1 0 1))
  (for ([c (list (g:* 0 x) (g:* x 0) (g:/ 0 (g:+ 1 x)) (g:expt x 0)
                 (g:expt 1 x) (g:expt 0 (g:+ 1 x))
                 (g:floor (g:+ x 1/2)))])
    (check-pred number? c))
  (for ([v (list (g:* x x) (g:square x) (g:expt x 2) (g:cos x) (g:- x x))])
    (check-pred dual? v)
    (check-equal? (extract-tangent 1 v) 0))
  (check-equal? (g:square (make-dual 1 'x 0)) (g:square 'x)))

(test-case "dual numbers are equal where their ε and their parts are"
  (define x (make-dual 1 'x 2))
  (check-equal? (make-dual 1 (g:+ 'x 0) 2) x)
  (check-equal? (hash-ref (hash x 'found) (make-dual 1 'x 2) #f) 'found)
  (for ([other (list (make-dual 3 'x 2) (make-dual 1 'y 2) (make-dual 1 'x 3) 'x)])
    (check-not-equal? other x))
  (define nested (make-dual 4 x 1))
  (check-equal? (make-dual 4 (make-dual 1 'x 2) 1) nested)
  (check-not-equal? (make-dual 4 (make-dual 3 'x 2) 1) nested))

(test-case "tags are fresh, and increase"
  (define tags (for/list ([_ 5]) (fresh-tag)))
  (check-equal? tags (sort tags <))
  (check-true (apply < tags)))

(test-case "the greatest tag is outermost, in whatever order it comes"
  (for ([op (list g:+ g:- g:* g:/ g:expt g:atan)])
    (for ([r (list (op (make-dual 1 2 3) (make-dual 4 5 6))
                   (op (make-dual 4 5 6) (make-dual 1 2 3)))])
      (check-equal? (dual-tag r) 4)
      (check-equal? (dual-tag (primal-part r 4)) 1))))

(test-case "ε² = 0, and different ε multiply"
  (define x (make-dual 1 0 1))
  (define y (make-dual 2 0 1))
  (check-equal? (primal-part (g:* x x) 1) 0)
  (check-equal? (extract-tangent 1 (g:* x x)) 0)
  (check-equal? (extract-tangent 1 (extract-tangent 2 (g:* x y))) 1)
  (check-equal? (extract-tangent 2 (extract-tangent 1 (g:* x y))) 1)
  (check-equal? (extract-tangent 1 (extract-tangent 2 (g:* x x y))) 0))

(test-case "the coefficient of an ε that is not there is 0"
  (for ([x (list 3 'a (g:sin 'a) (make-dual 7 1 2))])
    (check-equal? (extract-tangent 5 x) 0))
  (check-equal? (extract-tangent 5 (up 1 (down 'a (make-dual 5 1 'b)))) (up 0 (down 0 'b))))

(test-case "extraction reaches every level and every container"
  (define d (make-dual 2 (make-dual 1 'a 'b) (make-dual 1 'c 'd)))
  (check-true (same? (extract-tangent 2 d) (make-dual 1 'c 'd)))
  (check-true (same? (extract-tangent 1 d) (make-dual 2 'b 'd)))
  (check-equal? (extract-tangent 1 (extract-tangent 2 d)) 'd)
  (check-equal? (extract-tangent 1 (matrix-by-rows (list 1 (make-dual 1 2 3))))
                (matrix-by-rows '(0 3)))
  (check-equal? ((extract-tangent 1 (lambda (x) (g:* x (make-dual 1 2 3)))) 'x) (g:* 3 'x)))

(test-case "what has no derivative is refused"
  (check-exn #rx"^D: the function returned a value that has no derivative: \"s\", a string$"
             (lambda () (extract-tangent 1 "s")))
  (check-exn
   #rx"^D: the function returned a value that has no derivative: [(]1 x[)], a list\n  a list is not a tuple; use [(]up x y [.][.][.][)]$"
   (lambda () (extract-tangent 1 (list 1 (make-dual 1 'x 2))))))

(test-case "a dual number shows itself as its value, in all three modes"
  (for ([d (list (make-dual 3 'x 1) (make-dual 4 (make-dual 3 'x 1) 'y))])
    (for ([mode '("~a" "~s" "~v" "~e")])
      (check-equal? (format mode d) "x"))
    (check-equal? (format "~v" (up d 1)) "(up x 1)")
    (check-equal? (describe-with-value d) "x, a number-like expression being differentiated")))

(test-case "a message about a dual number shows its value"
  (check-exn #rx"argument 1: x, a number-like expression being differentiated\n"
             (lambda () (g:+ (make-dual 3 'x 1) (up 1 2)))))

(test-case "arithmetic agrees with the product of truncated polynomials"
  ;; (a + bε)(c + dε) by hand, at two levels
  (with-seed 401
    (for ([_ 20])
      (define-values (a b c d) (apply values (for/list ([_ 4]) (random-rational))))
      (check-equal? (extract-tangent 1 (g:* (make-dual 1 a b) (make-dual 1 c d)))
                    (+ (* a d) (* b c)))
      (check-equal? (extract-tangent 1 (g:/ (make-dual 1 a b) (make-dual 1 c d)))
                    (/ (- (* b c) (* a d)) (* c c))))))

(test-case "a dual number with structures: each component gets its part"
  (define d (make-dual 1 2 3))
  (check-equal? (extract-tangent 1 (g:* d (up 1 'a))) (up 3 (g:* 3 'a)))
  (check-equal? (extract-tangent 1 (g:* (up d 1) (down d 1))) 12))
