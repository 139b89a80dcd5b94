#lang racket/base
;; Antiderivatives: known ones, and the derivative of each is what it was asked of.

(require (only-in mechanics + - * / expt sqrt square exp log sin cos tan asin atan sinh cosh tanh
                  literal-function D partial expression proved? verify-equal)
         mechanics/algebra/assumption/assumption-set
         mechanics/calculus/antiderivative
         mechanics/calculus/expression-function
         "../support/checks.rkt" "../support/random.rkt")

(define (integral e) (antiderivative e 'x no-assumptions))

(define-check (check-integral e expected)
  (define found (integral e))
  (with-check-info (['integrand e] ['found found])
    (unless (and found
                 (equal? (expression found) expected)
                 (proved? (verify-equal (expression-derivative found 'x) e)))
      (fail-check))))

(test-case "powers"
  (check-integral 0 0)
  (check-integral 'a '(* a x))
  (check-integral (+ 1 (* 3 (square 'x))) '(+ (expt x 3) x))
  (check-integral (/ 'a 'x) '(* a (log x)))
  (check-integral (/ (+ 1 'x) (expt 'x 3)) '(+ (/ -1 x) (/ -1/2 (expt x 2))))
  (check-integral (sqrt 'x) '(* 2/3 (expt x 3/2))))

(test-case "waves"
  (check-integral (cos (* 'omega 'x)) '(/ (sin (* omega x)) omega))
  (check-integral (* 'x (cos 'x)) '(+ (* x (sin x)) (cos x)))
  (check-integral (square (sin 'x)) '(- (* 1/2 x) (* 1/4 (sin (* 2 x)))))
  (check-integral (expt (cos 'x) 4)
                  '(+ (* 3/8 x) (* 1/4 (sin (* 2 x))) (* 1/32 (sin (* 4 x)))))
  (check-integral (expt (cos (+ (* 2 'x) 'b)) 3)
                  '(+ (* 3/8 (sin (+ b (* 2 x)))) (* 1/24 (sin (+ (* 3 b) (* 6 x)))))))

(test-case "substitutions"
  (check-integral (/ 'x (sqrt (+ (square 'x) (square 'y)))) '(sqrt (+ (expt x 2) (expt y 2))))
  (check-integral (* (expt (sin 'x) 3) (cos 'x)) '(* 1/4 (expt (sin x) 4)))
  (check-integral (* 'x (exp (square 'x))) '(* 1/2 (exp (expt x 2))))
  (check-integral (/ 1 (+ 1 'x)) '(log (+ 1 x)))
  (check-integral (tan 'x) '(* -1 (log (cos x))))
  (check-integral (expt 'x 'n) '(/ (expt x (+ 1 n)) (+ 1 n))))

(test-case "derivatives of literal functions, and sums of such with others"
  (define V (literal-function 'V))
  (define U (literal-function 'U '(-> (UP Real Real) Real)))
  (check-integral ((D V) 'x) '(V x))
  (check-integral (((expt D 2) V) 'x) '((D V) x))
  (check-integral (+ (cos 'x) (* 'a ((D V) 'x))) '(+ (* a (V x)) (sin x)))
  (check-integral (((partial 1) U) (vector 't 'x)) '(U (up t x))))

(test-case "each integral of a known function, with arcs and signs, has it for its derivative"
  (for ([e (list (log 'x) (cosh 'x) (sinh 'x) (tanh 'x) (asin 'x) (atan 'x)
                 (/ 1 (square (cosh 'x))) (/ 1 (square (cos 'x))) (/ 1 (square (sin 'x)))
                 (/ 1 (cos 'x)) (/ 1 (sin 'x)) (/ 1 (+ 2 (cos 'x))) (exp (* -4 (square 'x))))])
    (define found (antiderivative e 'x no-assumptions #t))
    (with-check-info (['integrand e] ['found found])
      (check-not-false found)
      (check-pred proved? (verify-equal (expression-derivative found 'x) e)))))

(test-case "what has none of these is answered by #f"
  (for ([e (list (exp (square 'x)) (/ (sin 'x) 'x) ((literal-function 'f) 'x) (exp (cos 'x)))])
    (check-false (integral e))))

;; A product of a power, an exponential and two waves, whose parameters are numbers or symbols.
(define (random-term)
  (define (parameter) (random-choice 'a 'b (random-rational)))
  (define (wave) ((random-choice sin cos) (+ (* (parameter) 'x) (random-choice 0 'phi))))
  (* (random-rational) (expt 'x (random 3))
     (random-choice 1 (exp (* (parameter) 'x)))
     (random-choice 1 (wave)) (random-choice 1 (wave))))

(test-case "random sums of waves are integrated, and differentiated back"
  (with-seed 611
    (for ([_ (in-range 25)])
      (define e (+ (random-term) (random-term)))
      (define found (integral e))
      (with-check-info (['integrand e] ['found found])
        (check-not-false found)
        (check-pred proved? (verify-equal (expression-derivative found 'x) e))))))
