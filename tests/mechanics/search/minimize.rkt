#lang racket/base
;; Minima of generic functions.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/generic/rounding
         mechanics/error/failure
         mechanics/value/structure
         mechanics/search/minimize
         "../support/checks.rkt")

(test-case "a minimum of a function made by arithmetic, as (argument value steps)"
  (define result (minimize (g:+ g:square (g:* -2 values)) -3 5))
  (check-equal? (length result) 3)
  (check-= (car result) 1 1e-7)
  (check-= (cadr result) -1 1e-12))

(test-case "what is no function of one variable, or no number, is refused"
  (check-exn #rx"^minimize: expected a function of one variable"
             (lambda () (minimize (lambda (x y) x) 0 1)))
  (check-exn #rx"^minimize: expected a real number\n  given: the symbol b"
             (lambda () (minimize values 0 'b))))

;; ---------------------------------------------------------------------------
;; In one variable

;; Minima that Emmy is tested with
(define examples
  (list (list (lambda (x) (g:+ (g:square x) (g:exp (g:- x)))) 0 1 0.351734)
        (list (lambda (x) (g:+ (g:expt x 4) (g:* 2 (g:square x)) x 3)) -1 0 -0.236733)
        (list (lambda (x) (g:+ (g:exp x) (g:/ 0.01 x))) 0.001 1 0.0953446)
        (list (lambda (x) (g:+ (g:exp x) (g:* -2 x) (g:/ 0.01 x) (g:/ -1e-6 (g:square x))))
              0.001 1 0.703205)
        (list (lambda (x) (g:+ 5 (g:square x))) -2 2 0)))

(test-case "Brent's method and golden sections find the same"
  (for ([example (in-list examples)])
    (define-values (f low high expected) (apply values example))
    (for ([method (list minimize brent-min golden-section-min)])
      (define-values (x y steps) (apply values (method f low high)))
      (check-= x expected 1e-6)
      (check-= y (f x) 1e-15))
    (check-true (< (caddr (minimize f low high)) (caddr (golden-section-min f low high)))
                "golden sections are slower")))

(test-case "tolerances and predicates end the search"
  (check-= (car (brent-min g:cos 2 4 1e-3)) (acos -1.0) 1e-2)
  (check-= (car (golden-section-min g:cos 2 4 1e-3)) (acos -1.0) 1e-2)
  (define seen '())
  (define (after-ten low x high f-low f-x f-high count)
    (check-true (<= low x high))
    (check-true (<= f-x (min f-low f-high)))
    (set! seen (cons (- high low) seen))
    (= count 10))
  (check-equal? (caddr (golden-section-min g:cos 2 4 after-ten)) 10)
  (check-= (/ (car seen) (cadr seen)) (/ 2 (+ 1 (sqrt 5.0))) 1e-12)
  (check-exn
   #rx"^golden-section-min: a predicate that ends the search takes three arguments, .*\n  given: "
   (lambda () (golden-section-min g:cos 2 4 (lambda (width) #t)))))

(test-case "each point tried is observed"
  (for ([method (list minimize brent-min golden-section-min)])
    (define count 0)
    (define found
      (method g:cos 2 4 #:observe (lambda (x y) (check-= y (cos x) 0.0) (set! count (+ count 1)))))
    (check-true (<= (caddr found) count (+ 4 (caddr found))))))

(test-case "each says its own name"
  (for ([method (list minimize brent-min golden-section-min)]
        [name '("minimize" "brent-min" "golden-section-min")])
    (define (says what) (regexp (format "^~a: ~a" name what)))
    (check-exn (says "expected a function of one variable")
               (lambda () (method 3 0 1)))
    (check-exn (says "expected a real number\n  given: the symbol b")
               (lambda () (method g:cos 0 'b)))
    (check-exn (says "expected a real number\n  given: .*up tuple of 2")
               (lambda () (method (lambda (x) (up x x)) 0 1)))
    (check-exn (says "the function is not finite") (lambda () (method (lambda (x) +nan.0) 0 1)))
    (for ([low '(0 -inf.0)] [high '(+inf.0 0)])
      (check-exn (says "expected a finite real number as end")
                 (lambda () (method g:cos low high)))))
  (check-exn #rx"^golden-section-min: expected a positive tolerance"
             (lambda () (golden-section-min g:cos 0 1 'close)))
  (check-exn #rx"^golden-section-min: no minimum found\n  steps: 200"
             (lambda () (golden-section-min g:cos 2 4 (lambda arguments #f)))))

;; ---------------------------------------------------------------------------
;; In several variables

(define (bowl v) (g:+ (g:square (g:- (ref v 0) 3)) (g:square (g:+ (ref v 1 0) 4))))

(test-case "the report: argument, value, size of the gradient, evaluations"
  (define (report f start . method)
    (keyword-apply multidimensional-minimize '(#:report) (list list) f start method))
  (define-values (x y slope count) (apply values (report bowl (up 0 (up 0 0)))))
  (check-= (ref x 0) 3 1e-7)
  (check-= (ref x 1 0) -4 1e-7)
  (check-equal? (ref x 1 1) 0.0)
  (check-= y 0 1e-12)
  (check-true (< slope 1e-6))
  (check-true (<= 3 count 10))
  ;; at a kink there is no gradient
  (define-values (x* y* slope* count*) (apply values (report g:abs 1)))
  (check-= x* 0 1e-7)
  (check-false slope*))

(test-case "the downhill simplex method by its name: argument, value, evaluations"
  (define-values (x y count) (apply values (nelder-mead bowl (up 0 (up 0 0)))))
  (check-= (ref x 0) 3 1e-6)
  (check-= (ref x 1 0) -4 1e-6)
  (define-values (from-list y* count*)
    (apply values (nelder-mead (lambda (v) (bowl (up (car v) (up (cadr v) 0)))) '(0 0) 1 1e-3)))
  (check-= (cadr from-list) -4 1e-2)
  (check-true (< count* count))
  (check-= (car (nelder-mead g:cos 3)) (acos -1.0) 1e-6))

(test-case "a start where the gradient vanishes is not taken for a minimum"
  (check-= (abs (multidimensional-minimize g:cos 0)) (acos -1.0) 1e-6)
  (check-= (abs (multidimensional-minimize g:cos 0 #:method 'quasi-newton)) (acos -1.0) 1e-6)
  (define (saddle v)
    (g:+ (g:square (ref v 0)) (g:* -1 (g:square (ref v 1))) (g:expt (ref v 1) 4)))
  (define-values (x y slope count)
    (apply values (multidimensional-minimize saddle (up 0 0) #:report list)))
  (check-= (ref x 0) 0 1e-6)
  (check-= (abs (ref x 1)) (sqrt 1/2) 1e-6)
  (check-= y -1/4 1e-12)
  (check-true (< slope 1e-6) "found from the gradient, beside the saddle"))

(test-case "a failure carries the best point in its own shape"
  (for ([method '(quasi-newton nelder-mead)])
    (define failure
      (with-handlers ([exn:fail:mechanics:not-convergent? values])
        (multidimensional-minimize (lambda (v) (g:- (g:square (ref v 0))))
                                   (up 1 2)
                                   #:method method)))
    (check-pred up? (exn:fail:mechanics:not-convergent-value failure))
    (check-regexp-match #rx"^multidimensional-minimize: no minimum found: the function "
                        (exn-message failure)))
  (check-regexp-match #rx"^multidimensional-minimize: no minimum found: "
                      (with-handlers ([exn:fail:mechanics:not-convergent? exn-message])
                        (multidimensional-minimize (lambda (v) (g:- (g:square (ref v 0))))
                                                   (up 1 2) #:method 'nelder-mead))))

(test-case "nelder-mead has a limit of evaluations, at which it returns its best point"
  (define found (nelder-mead bowl (up 0 (up 0 0)) 1 1e-8 20))
  (define better (nelder-mead bowl (up 0 (up 0 0)) 1 1e-8 60))
  (check-true (<= 20 (caddr found) 24))
  (check-equal? (bowl (car found)) (cadr found))
  (check-true (< (cadr better) (cadr found))))

;; It falls with slope −1 up to 2, where it jumps upwards.
(define (sawtooth x) (g:- (g:* 2 (g:floor x)) x))

(test-case "where the gradient does not vanish, yet nothing near is lower, it is said"
  (define failure
    (with-handlers ([exn:fail:mechanics:not-convergent? values])
      (multidimensional-minimize sawtooth 1.3 #:method 'quasi-newton)))
  (check-regexp-match
   #rx"^multidimensional-minimize: no minimum found: the gradient does not vanish, yet nothing near is lower\n"
   (exn-message failure))
  (check-regexp-match #rx"\n  size of the gradient there: 1.0\n" (exn-message failure))
  (check-= (exn:fail:mechanics:not-convergent-value failure) 2 1e-6)
  ;; unless told, the values alone are searched from there
  (check-= (multidimensional-minimize sawtooth 1.3) 2 1e-6))

(test-case "mistakes"
  (check-exn #rx"^nelder-mead: expected a positive step"
             (lambda () (nelder-mead g:cos 1 0)))
  (check-exn #rx"^nelder-mead: expected a positive tolerance"
             (lambda () (nelder-mead g:cos 1 1 -1)))
  (check-exn #rx"^multidimensional-minimize: expected a positive tolerance"
             (lambda () (multidimensional-minimize g:cos 1 #:tolerance 0)))
  (check-exn #rx"^nelder-mead: expected real numbers to start from.*the symbol x"
             (lambda () (nelder-mead g:cos 'x)))
  (check-exn #rx"^nelder-mead: expected a function of one variable"
             (lambda () (nelder-mead (lambda (x y) x) 1)))
  (check-exn #rx"^multidimensional-minimize: expected a real number\n  given: .*up tuple of 2"
             (lambda () (multidimensional-minimize (lambda (x) (up x x)) 1))))
