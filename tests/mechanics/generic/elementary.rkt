#lang racket/base
;; Elementary operations: values, exactness, arity.  (Their derivatives are the
;; matter of rules.rkt, and where they have none, of singular-derivatives.rkt.)

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/generic/up-down
         mechanics/calculus/derivative
         "../support/checks.rkt" "../support/random.rkt" "../support/same.rkt")

;; ---------------------------------------------------------------------------
;; Values

(test-case "numbers are computed as Racket computes them"
  (check-equal? (g:sqrt 4) 2)
  (check-equal? (g:sqrt -4) +2i)
  (check-equal? (g:sqrt 2.0) (sqrt 2.0))
  (check-equal? (g:sin 1.0) (sin 1.0))
  (check-equal? (g:atan 1.0 2.0) (atan 1.0 2.0))
  (check-equal? (g:atan 1 -1) (atan 1 -1))
  (check-equal? (g:log 8 2) (/ (log 8) (log 2)))
  (check-equal? (g:expt 2 10) 1024)
  (check-equal? (g:expt 4 1/2) 2))

(test-case "exact arguments with exact values stay exact"
  (check-equal? (map (lambda (f) (f 0))
                     (list g:sin g:cos g:tan g:exp g:asin g:atan g:sinh g:cosh g:tanh))
                '(0 1 0 1 0 0 0 1 0))
  (check-equal? (g:log 1) 0)
  (check-equal? (g:acos 1) 0)
  (check-equal? (g:abs -1/2) 1/2)
  (check-equal? (g:expt 2/3 -2) 9/4))

(test-case "hyperbolic functions are accurate to a few units in the last place"
  ;; Taylor series summed exactly
  (define (series x first step)
    (define q (inexact->exact x))
    (let loop ([term (expt q first)] [k first] [sum 0])
      (if (> k 60)
          (exact->inexact sum)
          (loop (/ (* term q q) (* (+ k 1) (+ k 2))) (+ k 2) (+ sum term)))))
  (with-seed 205
    (for* ([scale '(1e-8 1e-4 5e-3 0.009999 0.010001 0.1 1.0 4.0)] [_ (in-range 5)])
      (define x (* scale (- (* 2 (random)) 1.0)))
      (check-same (/ (g:sinh x) (series x 1 2)) 1.0 3e-14)
      (check-same (/ (g:cosh x) (series x 0 2)) 1.0 1e-15)
      (check-same (/ (g:tanh x) (/ (series x 1 2) (series x 0 2))) 1.0 3e-14))))

(test-case "hyperbolic functions at the ends of the line"
  (check-equal? (g:tanh 1000.0) 1.0)
  (check-equal? (g:tanh -1000.0) -1.0)
  (check-equal? (g:sinh 1000.0) +inf.0)
  (check-equal? (g:cosh -1000.0) +inf.0)
  (check-eqv? (g:sinh +nan.0) +nan.0)
  (check-eqv? (g:tanh +nan.0) +nan.0))

(test-case "reciprocal functions are made of the others"
  (check-equal? (g:sec 'x) (g:/ 1 (g:cos 'x)))
  (check-equal? (g:csc 'x) (g:/ 1 (g:sin 'x)))
  (check-equal? (g:cot 'x) (g:/ (g:cos 'x) (g:sin 'x)))
  (check-same (g:cot 0.7) (/ (tan 0.7)) 1e-15))

(test-case "functions report the number of arguments they take"
  (for ([f (list g:sqrt g:exp g:sin g:cos g:tan g:asin g:acos g:sinh g:cosh g:tanh
                 g:asinh g:acosh g:atanh g:abs g:sgn g:sec g:csc g:cot g:sech g:csch g:coth
                 g:square g:cube g:negate g:invert)])
    (check-equal? (procedure-arity f) 1))
  (check-equal? (procedure-arity g:log) '(1 2))
  (check-equal? (procedure-arity g:atan) '(1 2))
  (check-equal? (procedure-arity g:expt) 2))

(test-case "inverse hyperbolic functions undo the hyperbolic ones, to the last places"
  (with-seed 206
    (for* ([scale '(1e-10 1e-5 0.01 0.3 1.0 5.0)] [_ (in-range 5)])
      (define x (* scale (- (* 2 (random)) 1.0)))
      (check-same (/ (g:asinh (g:sinh x)) x) 1.0 1e-13)
      (check-same (/ (g:atanh (g:tanh (/ x 5))) (/ x 5)) 1.0 1e-13)
      (check-same (g:acosh (g:cosh x)) (abs x) (/ 1e-15 (abs x))))))

(test-case "inverse hyperbolic functions at the ends, at exact points, off the real line"
  (check-equal? (list (g:asinh 0) (g:acosh 1) (g:atanh 0)) '(0 0 0))
  (check-equal? (list (g:asinh +inf.0) (g:asinh -inf.0) (g:acosh +inf.0)) '(+inf.0 -inf.0 +inf.0))
  (check-equal? (g:atanh 1.0) +inf.0)
  (check-same (/ (g:asinh 1e200) (+ (log 1e200) (log 2))) 1.0 1e-15)
  (for ([f (list g:asinh g:acosh g:atanh)] [inverse (list g:sinh g:cosh g:tanh)]
        #:when #t
        [z '(2.0+1.0i -0.5+0.3i 0.2-2.0i)])
    (check-same (inverse (f z)) z 1e-14))
  (check-same (g:cosh (g:acosh 1/2)) 1/2 1e-15)
  (check-same (g:tanh (g:atanh 3)) 3 1e-15))

(test-case "the sign is as exact as its argument"
  (check-equal? (map g:sgn '(-3 0 1/2 -0.5 0.0 7.5)) '(-1 0 1 -1.0 0.0 1.0))
  (check-equal? (g:sgn 3+4i) 3/5+4/5i))

(test-case "the magnitude of a tuple is that of its components"
  (check-equal? (g:abs (up 3 (down 0 +4i))) 5)
  (check-equal? (g:abs (up 'a 0)) (g:sqrt (g:square 'a))))

(test-case "D erf is 2/√π exp(−x²), at exact roots, too"
  (check-same ((D g:erf) (g:sqrt 2)) (* (/ 2 (sqrt (acos -1.0))) (exp -2)) 1e-15))
