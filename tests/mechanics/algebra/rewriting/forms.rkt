#lang racket/base
;; Expanded, collected, factored expressions, quotients and partial fractions:
;; the form expected, the value kept, and the same again when done again.

(require mechanics/algebra/expression/expression
         mechanics/algebra/rewriting/expand
         mechanics/algebra/rewriting/collect
         mechanics/algebra/rewriting/together
         mechanics/algebra/rewriting/apart
         mechanics/algebra/rewriting/factor
         mechanics/algebra/expression/read
         "../../support/checks.rkt" "../../support/close.rkt" "../../support/random.rkt"
         "../../support/random/expression.rkt")

(define (first-value f . arguments)
  (define-values (e assumptions) (apply f arguments))
  e)

(define ((on-datum f) d . more)
  (expression->datum (apply first-value f (datum->expression d) more)))

(define expanded (on-datum expand-expression))
(define united (on-datum together-expression))
(define factored (on-datum factored-expression))
(define (collected d . in) ((on-datum collect-expression) d (map datum->expression in)))
(define (parted d in) ((on-datum partial-fractions) d (datum->expression in)))

(define-syntax-rule (check-forms f [before after] ...)
  (begin (check-equal? (f 'before) 'after) ...))

(test-case "two collected terms of opposite signs are a difference"
  (check-equal? (collected '(+ (* x x) (* -1 a b x)) 'x) '(- (expt x 2) (* a b x)))
  (check-equal? (collected '(+ (* -1 a x x) b) 'x) '(- b (* a (expt x 2)))))

(test-case "any expression is a quotient, of itself and 1 if need be"
  (define (parts d)
    (define-values (above below _) (numerator-and-denominator (datum->expression d)))
    (map expression->datum (list above below)))
  (check-equal? (parts '(+ (/ a b) c)) '((+ a (* b c)) b))
  (check-equal? (parts '(+ a b)) '((+ a b) 1)))

(test-case "products and powers of sums are multiplied out"
  (check-forms expanded
   [(expt (+ a b) 3) (+ (expt a 3) (* 3 (expt a 2) b) (* 3 a (expt b 2)) (expt b 3))]
   [(* 1/2 m (+ (expt v 2) (expt w 2))) (+ (* 1/2 m (expt v 2)) (* 1/2 m (expt w 2)))]
   [(expt (+ 1 (sqrt x)) 2) (+ 1 x (* 2 (sqrt x)))]
   [(expt (+ a (sqrt (+ 1 y))) 2) (+ 1 (expt a 2) (* 2 a (sqrt (+ 1 y))) y)]
   [(* (+ b (expt (+ 1 y) 1/3)) (expt (+ 1 y) 2/3)) (+ 1 (* b (expt (+ 1 y) 2/3)) y)]
   [(* 1.5 (+ a 0.5) (+ b 2)) (+ 1.5 (* 1.5 a b) (* 3 a) (* 0.75 b))]
   [(- (* (+ a b) c) (+ (* a c) (* b c))) 0]
   [a a]))

(test-case "expanding combines no sines and cosines"
  (check-forms expanded
   [(expt (+ (sin x) (cos x)) 2)
    (+ (expt (cos x) 2) (* 2 (cos x) (sin x)) (expt (sin x) 2))]
   [(* (cos (* 2 x)) (+ (cos x) a)) (+ (* a (cos (* 2 x))) (* (cos x) (cos (* 2 x))))]
   [(* 2 (+ 1 (sin (* -1 x)))) (- 2 (* 2 (sin x)))]
   [(* (sqrt (cos x)) (+ (sin x) (sqrt (cos x)))) (+ (cos x) (* (sin x) (sqrt (cos x))))]))

(test-case "an expanded term keeps the divisors it needs"
  (check-forms expanded
   [(/ (+ a b) (+ c d)) (+ (/ a (+ c d)) (/ b (+ c d)))]
   [(+ (/ a (+ c d)) b) (+ b (/ a (+ c d)))]
   [(/ (* (+ a 1) (+ c d)) (+ c d)) (+ 1 a)]))

(test-case "a sum of quotients is one quotient in lowest terms"
  (check-forms united
   [(+ (/ a b) (/ c d)) (/ (+ (* a d) (* b c)) (* b d))]
   [(+ (/ a 2) (/ b 3)) (/ (+ (* 3 a) (* 2 b)) 6)]
   [(- (/ 1 (- x 1)) (/ 1 (+ x 1))) (/ 2 (- (expt x 2) 1))]
   [(/ (- (* -1 b) a) (* 2 c)) (/ (* -1 (+ a b)) (* 2 c))]
   [(/ 1 (sqrt x)) (/ 1 (sqrt x))]
   [(+ 1/2 1/3) 5/6]))

(test-case "collected terms have the highest powers first and simplified coefficients"
  (check-equal? (collected '(+ (* a m) (* b m m) (* c m) d (* -1 b m m)) 'm)
                '(+ (* m (+ a c)) d))
  (check-equal? (collected '(+ (* a x) (* b y) (* c x) (* d x y) (* x x)) 'x 'y)
                '(+ (expt x 2) (* d x y) (* x (+ a c)) (* b y)))
  (check-equal? (collected '(+ (* m (((expt D 2) x) t)) (* k (x t)) (* M (((expt D 2) x) t)))
                           '(((expt D 2) x) t))
                '(+ (* (+ M m) (((expt D 2) x) t)) (* k (x t))))
  (check-equal? (collected '(+ (* a m (expt (sin x) 2)) (* a m (expt (cos x) 2)) (* b m)) 'm)
                '(* m (+ a b)))
  (check-equal? (collected '(+ (/ a m) (/ b m) c (* 2 m)) 'm) '(+ (* 2 m) c (/ (+ a b) m)))
  (check-equal? (collected '(+ (* a b x) (* a c x)) 'x) '(* a x (+ b c)))
  (check-equal? (collected '(/ (+ (* b x y) (* c x y)) (* 2 d)) 'x 'y) '(/ (* x y (+ b c)) (* 2 d)))
  (check-equal? (collected '(/ (+ a m (* b m)) (+ 1 m (* m d))) 'm)
                '(/ (+ (* m (+ 1 b)) a) (+ (* m (+ 1 d)) 1)))
  (check-equal? (collected '(+ (* m m (/ a (+ c d))) (* m d)) 'm)
                '(+ (/ (* a (expt m 2)) (+ c d)) (* d m))))

(test-case "coefficients of powers, none where it is no polynomial"
  (define (coefficient d in n)
    (first-value expression-coefficient (datum->expression d) in n))
  (check-equal? (coefficient '(expt (+ a m) 3) 'm 2) (datum->expression '(* 3 a)))
  (check-equal? (coefficient '(expt (+ a m) 3) 'm 4) 0)
  (check-equal? (coefficient '(/ a m) 'm -1) 'a)
  (check-equal? (coefficient 'a 'm 0) 'a)
  (check-equal? (coefficient '(- a a) 'm 0) 0)
  (check-false (coefficient '(/ 1 (+ a m)) 'm 0)))

(test-case "partial fractions in one symbol"
  (check-equal? (parted '(/ 1 (* s (+ s 1))) 's) '(- (/ 1 s) (/ 1 (+ 1 s))))
  (check-equal? (parted '(/ (expt s 2) (* 2 (expt (+ s b) 2))) 's)
                '(+ 1/2 (/ (expt b 2) (* 2 (expt (+ b s) 2))) (/ (* -1 b) (+ b s))))
  (check-equal? (parted '(/ a (+ b c)) 's) '(/ a (+ b c)))
  (check-equal? (parted '(* 3 s) 's) '(* 3 s))
  (check-equal? (parted '(- s s) 's) 0))

(test-case "a factored expression is a product of irreducible factors"
  (check-forms factored
   [(- (expt a 4) (expt b 4)) (* (- a b) (+ a b) (+ (expt a 2) (expt b 2)))]
   [(- (* a k) (* a m (expt omega 2))) (* a (- k (* m (expt omega 2))))]
   [(+ (* 2 x x) (* 5 x y) (* 2 y y)) (* (+ x (* 2 y)) (+ (* 2 x) y))]
   [(/ (- (* x x) 1) (+ (* x x) (* -4 x) 4)) (/ (* (- x 1) (+ 1 x)) (expt (- x 2) 2))]
   [(- (expt (+ x y 1) 2) (expt (+ z 2) 2)) (* (+ x y (* -1 z) -1) (+ 3 x y z))]
   [(+ (* 1.5 a x) (* 1.5 a y)) (* 1.5 a (+ x y))]
   [(+ (expt x 2) (expt y 2)) (+ (expt x 2) (expt y 2))]
   [12 12]))

(test-case "signs are where they are least in the way"
  (check-forms factored
   [(- b a) (- b a)]
   [(* (- b a) (- d c)) (* (- a b) (- c d))]
   [(* -1 (+ a b) (+ c d)) (* -1 (+ a b) (+ c d))]
   [(* -1 c (- a b)) (* c (- b a))]))

(test-case "factors know that sin² is 1 - cos²"
  (check-forms factored
   [(* (expt (sin x) 4) (+ 1 (cos x))) (* (+ 1 (cos x)) (expt (sin x) 4))]
   [(- (expt (cosh u) 2) 1) (expt (sinh u) 2)]
   [(- (expt (* a (cos x)) 2) (expt (* b (sin x)) 2))
    (* (- (* a (cos x)) (* b (sin x))) (+ (* a (cos x)) (* b (sin x))))]))

;; ---------------------------------------------------------------------------
;; Any expression

(define tools
  (list (cons "expand" expand-expression)
        (cons "together" together-expression)
        (cons "factor" factored-expression)
        (cons "collect" (lambda (e) (collect-expression e '(a x))))
        (cons "apart" (lambda (e) (partial-fractions e 'a)))))

(define (check-kept name before after)
  (for ([_ 3])
    (define lookup (random-lookup))
    (define u (value-at before lookup))
    (define v (value-at after lookup))
    (when (and u v) (check-true (close? u v 1e-7) (format "~a: ~a is not ~a" name before after)))))

(for* ([kinds (in-list '((rational) (rational trigonometric) (radical) (exponential)))]
       [tool (in-list tools)])
  (test-case (format "~a keeps the value of what is ~a, and is done once and for all"
                     (car tool) kinds)
    (with-seeds 25
      (define e (random-expression 3 kinds))
      (define once (with-handlers ([exn:fail:contract:divide-by-zero? (lambda (x) #f)])
                     (first-value (cdr tool) e)))
      (when once
        (check-kept (car tool) e once)
        (check-equal? (first-value (cdr tool) once) once)))))

(test-case "partial fractions of high degree, with symbols for coefficients"
  (define e
    (datum->expression
     '(/ (expt s 4) (* (+ (expt s 3) a) (+ (expt s 2) (* b s) c) (expt (+ s x) 2)))))
  (define parts (first-value partial-fractions e 's))
  (check-kept "apart" e parts)
  (check-equal? (length (node-args parts)) 4))
