#lang racket/base
;; Witnesses: points that certify that an expression is not zero.

(require (only-in mechanics/algebra/assumption/assumption-set no-assumptions)
         mechanics/algebra/expression/flat-graph
         mechanics/algebra/expression/read
         mechanics/algebra/simplify/declare-relations
         mechanics/algebra/zero/region
         mechanics/algebra/zero/witness
         "../../support/checks.rkt" "../../support/random.rkt"
         "../../support/evaluate.rkt")

;; The expression alone is looked at, without a simpler form of it.
;; -> witness value bound points
(define (witness-of d [relations '()])
  (define t (expression->tape (datum->expression d)))
  (find-witness t t (make-region (declare-relations no-assumptions relations) t) #f))

(define (point d) (let-values ([(point value bound points) (witness-of d)]) point))
(define (value d) (let-values ([(point value bound points) (witness-of d)]) value))

(define (refuted? d [relations '()])
  (define-values (point value bound points) (witness-of d relations))
  (and point #t))

;; ---------------------------------------------------------------------------

(test-case "integers are tried first, then fractions"
  (check-equal? (map cdr (point '(- x y))) '(1 2))
  (for ([d (in-list '((* (expt x 2) (sqrt (- 1 (expt x 2))))
                      (* x (- x 1) (- x 2) (+ (asin x) (acos y)))
                      (* x (log (- 1 x)))
                      (sqrt (- 1 x x y y))
                      (sqrt (- (* x 1/500) 1))))])
    (define p (point d))
    (check-true (and (pair? p) (andmap (lambda (w) (exact? (cdr w))) p)) (format "~s ~s" d p))
    (define e (datum->expression d))
    (check-= (evaluate-expression e (point-lookup p)) (value d) 1e-12)))

(test-case "points are where all relations certainly hold"
  (define-values (p value bound points)
    (witness-of '(* x (sqrt (- 1 x))) '((> x 0) (< (* x x) 1/100))))
  (check-true (< 0 (cdar p) 1/10)))

(test-case "a value has the digits that are certain, and is exact where it can be"
  (check-eqv? (value '(- (* 3 x) (* 1/2 x))) 5/2)
  (check-eqv? (value '(+ (* 1/2 x) (sin t))) 1/2)
  (check-= (value '(- (sqrt (+ (expt 10 40) x)) (expt 10 20))) 5e-21 1e-33)
  (check-eqv? (value '(- (exp 1) (+ 2 (sqrt 1/2)))) 0.01117504727249771)
  (check-eqv? (value '(- 0.3 (* x 0.3001))) -0.0001))

(test-case "what no flonum can tell from 0 is told by balls"
  (check-true (refuted? '(- (sqrt (+ (expt x 2) (expt 10 -60))) x)))
  (check-true (refuted? '(- (exp (* x (expt 10 -70))) 1)))
  (check-true (refuted? '(sqrt (- (exp (expt 10 -30)) 1))))
  (check-true (refuted? '(+ (expt (sin x) 2) (expt (cos x) 2) -1 (* (expt 10 -40) y))))
  (check-false (refuted? '(+ (expt (sin x) 2) (expt (cos x) 2) -1)))
  (check-false (refuted? '(- (sqrt (+ 5 (* 2 (sqrt 6)))) (sqrt 2) (sqrt 3)))))

(test-case "what is too great to be shown is no witness, another point is"
  (define p (point '(- (expt x 1000000) 1)))
  (check-true (< (cdar p) 1)))

(test-case "each part must have a real value, even if it cancels"
  (check-false (refuted? '(+ x (* 0 (sqrt (- -1 (* x x)))) (* 1/2 (asin (+ 2 (* x x)))))))
  (check-false (refuted? '(- x (expt (expt x 1/3) 3)) '((< x 0))))
  (check-false (refuted? '(+ 1 (log (- (* x x))))))
  (check-false (refuted? '(+ 1 (atan (- x x) (- y y))))))

(test-case "values of literal functions have declared signs, and are equal at equal arguments"
  (define-values (p value bound points) (witness-of '(- (V x) 7) '((< (V x) -2))))
  (check-true (< (cdr (assoc (datum->expression '(V x)) p)) -2))
  (check-false (refuted? '(- (V (sqrt 8)) (V (* 2 (sqrt 2))))))
  (check-false (refuted? '(- ((D V) (up (log (exp x)) 1)) ((D V) (up x 1)))))
  (check-true (refuted? '(- (V (sqrt 8)) (V 2.8284))))
  (check-true (refuted? '(- (V (up x y)) (V (up y x)))))
  (check-true (refuted? '(- ((D V) x) (V x)))))

(test-case "expressions with complex numbers keep complex values"
  (check-eqv? (value '(+ (* +i a) 1)) 1+i)
  (check-pred (lambda (x) (and (number? x) (not (real? x)))) (value '(exp (* +i t)))))

;; ---------------------------------------------------------------------------
;; Identities, and what is false by a millionth of a millionth

(define identities
  (list (lambda (x y) `(+ (expt (sin ,x) 2) (expt (cos ,x) 2) -1))
        (lambda (x y) `(- (sin (+ ,x ,y)) (+ (* (sin ,x) (cos ,y)) (* (cos ,x) (sin ,y)))))
        (lambda (x y) `(- (exp (+ ,x ,y)) (* (exp ,x) (exp ,y))))
        (lambda (x y) `(- (expt (+ ,x ,y) 5)
                          (+ (* ,x (expt (+ ,x ,y) 4)) (* ,y (expt (+ ,x ,y) 4)))))
        (lambda (x y) `(- (expt (cosh ,x) 2) (expt (sinh ,x) 2) 1))
        (lambda (x y) `(- (tan (* 2 ,x)) (/ (* 2 (tan ,x)) (- 1 (expt (tan ,x) 2)))))
        (lambda (x y) `(- (* 2 (atan ,x)) (asin (/ (* 2 ,x) (+ 1 (expt ,x 2)))) (f ,x ,y)
                          (- (* 2 (atan ,x)) (asin (/ (* 2 ,x) (+ 1 (expt ,x 2)))) (f ,x ,y))))))

(define (random-argument)
  (define c (random-integer 1 9))
  (random-choice 'x 'y `(* ,c x) `(+ x (* ,c y)) `(sqrt (+ ,c (* x x))) `(/ x (+ ,c (* y y)))))

(define (random-identity)
  (define make (list-ref identities (random (length identities))))
  (make (random-argument) (random-argument)))

(define (random-term)
  (define c (random-integer 1 9))
  (random-choice 'x '(sin x) `(* ,c (cos y)) `(exp (* -1/10 ,c x)) `(/ ,c (+ 1 (* x x))) '(f x y)))

(test-case "identities are not refuted, what is false by 10^-12 is"
  (with-seeds 100
    (define zero (random-identity))
    (check-false (refuted? zero) (format "~s" zero))
    (define false `(+ ,zero (* ,(expt 10 -12) ,(random-term))))
    (check-true (refuted? false) (format "~s" false))))
