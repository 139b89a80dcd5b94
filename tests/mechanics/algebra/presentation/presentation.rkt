#lang racket/base
;; How results are written: each form by sight and by value, the same again when
;; simplified again, and in whatever order operands were written.

(require racket/list
         mechanics/algebra/expression/expression
         mechanics/algebra/expression/nodes mechanics/algebra/expression/operation
         mechanics/algebra/simplify/simplify-expression
         mechanics/algebra/expression/read
         "../../support/checks.rkt" "../../support/close.rkt" "../../support/random.rkt"
         "../../support/random/expression.rkt")

(define (simplified e) (expression->datum (simplify-expression e)))

;; Operands of sums and products in random order, at every level.
(define (shuffled e)
  (node-fold e values
             (lambda (n args)
               (make-node (node-head n)
                          (if (memq (node-head n) (list op:+ op:*)) (shuffle args) args)))))

(define (check-form before after)
  (define e (datum->expression before))
  (define s (simplify-expression e))
  (check-equal? (expression->datum s) after)
  (check-equal? (simplified s) after "simplified again")
  (with-seeds 4
    (check-equal? (simplified (shuffled e)) after "operands in another order")
    (let* ([lookup (random-lookup)] [u (value-at e lookup)] [v (value-at s lookup)])
      (when (and u v) (check-true (close? u v 1e-7) (format "~a is not ~a" u v))))))

(define-syntax-rule (check-forms [before after] ...)
  (begin (check-form 'before 'after) ...))

(test-case "multiple angles stay where that is shorter"
  (check-forms
   [(+ (cos (* 5 t)) (cos t)) (+ (cos t) (cos (* 5 t)))]
   [(+ (* A (cos (* 3 t))) (* B (sin (* 2 t))) (cos t))
    (+ (* A (cos (* 3 t))) (* B (sin (* 2 t))) (cos t))]
   [(- (expt (cos t) 2) (expt (sin t) 2)) (cos (* 2 t))]
   [(- 1 (* 2 (expt (sin t) 2))) (cos (* 2 t))]
   [(* 2 (sin t) (cos t)) (* 2 (cos t) (sin t))]
   [(expt (cos t) 3) (expt (cos t) 3)]
   [(* (cos a) (cos b)) (* (cos a) (cos b))]))

(test-case "a product of waves is a sum of waves where that is much shorter"
  (check-forms
   [(- (cos a) (* (cos c) (sin c))) (- (cos a) (* (cos c) (sin c)))]
   [(- (cos a) (* (cos (+ b c)) (sin (+ b c)))) (- (cos a) (* 1/2 (sin (* 2 (+ b c)))))]
   [(+ (* 2 (sin a)) (* (cos (* 3 c)) (sin (* 3 c))))
    (+ (* (cos (* 3 c)) (sin (* 3 c))) (* 2 (sin a)))]))

;; 4 a² (3 + b² + (s y²/2 + 3 s/2)/a)² has no value at a = 0.
(test-case "a square has no divisor that its terms have not"
  (define e
    (simplify-expression
     (datum->expression '(expt (+ (* s (+ 3 (expt y 2))) (* 2 (+ a y) (+ 3 (expt b 2)))) 2))))
  (check-false (some-node? (lambda (n) (eq? (node-head n) op:/)) e)
               (format "~s" (expression->datum e))))

(test-case "squares and products of angle sums are found again"
  (check-forms
   [(+ m (* M (- 1 (expt (+ (* (cos a) (cos b)) (* (sin a) (sin b))) 2))))
    (+ (* M (expt (sin (- a b)) 2)) m)]
   [(* (- (* (sin a) (cos b)) (* (cos a) (sin b))) (+ (* (cos b) (cos c)) (* (sin b) (sin c))))
    (* (cos (- b c)) (sin (- a b)))]
   [(* -1 m (- (* (sin b) (cos a)) (* (sin a) (cos b)))) (* m (sin (- a b)))]))

(test-case "hyperbolic functions contract as circular ones do"
  (check-forms
   [(+ (* (cosh a) (cosh b)) (* (sinh a) (sinh b))) (cosh (+ a b))]
   [(+ (expt (cosh x) 2) (expt (sinh x) 2)) (cosh (* 2 x))]
   [(+ (* k (sinh a)) (cosh (+ a b)) (* -1 (cosh (- a b)))) (* (+ k (* 2 (sinh b))) (sinh a))]
   [(- (expt (cosh x) 2) (expt (sinh x) 2)) 1]))

(test-case "squares of sums are squares"
  (check-forms
   [(+ x (/ 1 x) -2) (/ (expt (- x 1) 2) x)]
   [(+ (f t) (* m (/ (expt p 2) x)) (* m x (expt q 2)) (* -2 m p q))
    (+ (/ (* m (expt (- p (* q x)) 2)) x) (f t))]
   [(* k (expt (- x y) 2)) (* k (expt (- x y) 2))]
   [(+ (expt x 2) (* -2 x y) (expt y 2) (* m z)) (+ (* m z) (expt (- x y) 2))]
   [(+ (* 1/2 m (expt v 2)) (* 1/2 k (expt (- x l) 2)))
    (+ (* 1/2 k (expt (- l x) 2)) (* 1/2 m (expt v 2)))]
   [(expt (+ x y z) 2) (expt (+ x y z) 2)]
   [(expt (- (* a (cos x)) (* b (sin x))) 2) (expt (- (* a (cos x)) (* b (sin x))) 2)]
   [(/ (expt (- p (* q (A x))) 2) (* 2 m)) (/ (expt (- p (* q (A x))) 2) (* 2 m))]
   [(+ (expt x 2) (* x y) (expt y 2)) (+ (expt x 2) (* x y) (expt y 2))]))

(test-case "terms are grouped by what they share"
  (check-forms
   [(- (+ (* 1/2 m v v) (* 1/2 m w w)) (+ (* 1/2 k x x) (* 1/2 k y y)))
    (- (* 1/2 m (+ (expt v 2) (expt w 2))) (* 1/2 k (+ (expt x 2) (expt y 2))))]
   [(+ (* (- k (* m w w)) A (cos t)) (* (- k (* m w w)) B (sin t)))
    (* (+ (* A (cos t)) (* B (sin t))) (- k (* m (expt w 2))))]
   [(+ (* A (expt (sin x) 2) (((expt D 2) q) t)) (* B (expt (cos x) 2) (((expt D 2) q) t)) (q t))
    (+ (* (+ (* A (expt (sin x) 2)) (* B (expt (cos x) 2))) (((expt D 2) q) t)) (q t))]
   [(+ (* r r phi) (* m r r)) (* (expt r 2) (+ m phi))]
   [(+ (* 2 y) (* g k) (* 4 k z) (* 4 (expt x 2) z))
    (+ (* g k) (* 2 y) (* 4 z (+ k (expt x 2))))]
   [(+ (/ a c) (/ b (* c d))) (+ (/ a c) (/ b (* c d)))]))

(test-case "a divisor that would be mostly negative changes its sign"
  (check-forms
   [(/ x (- a b c)) (/ (* -1 x) (+ b (* -1 a) c))]
   [(/ x (- (* -1 a) b)) (/ (* -1 x) (+ a b))]
   [(/ x (- a b)) (/ x (- a b))]))

(test-case "an exponential that all terms share stands apart"
  (check-forms
   [(+ (* a (exp (* -1 g t))) (* b (exp (* -1 g t)))) (* (+ a b) (exp (* -1 g t)))]
   [(- (* -1 g (cos w) (exp (* -1 g t))) (* w (sin w) (exp (* -1 g t))))
    (* -1 (+ (* g (cos w)) (* w (sin w))) (exp (* -1 g t)))]
   [(+ (exp x) (exp (* -1 x))) (+ (exp (* -1 x)) (exp x))]
   [(+ (* 4 m (exp x)) (exp (* 3/2 x)) (* 3 g)) (+ (* 3 g) (* 4 m (exp x)) (exp (* 3/2 x)))])
  ;; Below a fraction line, too, e^(2x) and e^x share nothing.
  (define sum '(+ (* b (f y) (exp (* 2 x))) c (* (f y) (exp x))))
  (check-form sum sum)
  (check-form `(/ 1 ,sum) `(/ 1 ,sum)))

(test-case "roots gather the factors beside them"
  (check-forms
   [(sqrt (/ (* G M) (expt a 3))) (sqrt (/ (* G M) (expt a 3)))]
   [(/ k (sqrt (* k m))) (sqrt (/ k m))]
   [(* (/ k m) (sqrt (/ k m))) (expt (/ k m) 3/2)]
   [(sqrt (/ (+ 1 v) (* 2 g y))) (sqrt (/ (+ 1 v) (* 2 g y)))]
   [(/ 1 (* y (sqrt (/ (+ 1 v) (* g y))))) (sqrt (/ g (* y (+ 1 v))))]
   [(* h (sqrt (* 2 g h))) (* h (sqrt (* 2 g h)))]
   [(* (+ (* y (expt (+ a b) 2)) (expt x 2)) (sqrt (+ y (expt (/ x (+ a b)) 2))))
    (* (expt (+ a b) 2) (expt (+ (expt (/ x (+ a b)) 2) y) 3/2))]
   [(* 1/2 x (sqrt 3)) (* 1/2 x (sqrt 3))]
   [(sqrt (- (- (* l l) (* x x)) (* y y)))
    (sqrt (+ (expt l 2) (* -1 (expt x 2)) (* -1 (expt y 2))))]))

(test-case "any expression: in whatever order operands were written"
  (with-seeds 60
    (let ([e (random-expression 4 '(rational trigonometric radical exponential))])
      (check-equal? (simplified (shuffled e)) (simplified e)))))
