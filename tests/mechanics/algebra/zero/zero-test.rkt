#lang racket/base
;; Verdicts: what is proved, refuted, left undecided, and what they carry.

(require mechanics/algebra/assumption/assumption-set
         mechanics/algebra/simplify/declare-relations
         mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation
         mechanics/algebra/assumption/relation
         mechanics/algebra/zero/decimal-readings
         mechanics/algebra/zero/zero-test
         mechanics/algebra/expression/read
         "../../support/checks.rkt" "../../support/evaluate.rkt")

(define (verdict d) (zero-test (datum->expression d)))
(define (status d) (zero-test-status (verdict d)))

(test-case "an identity is proved"
  (check-equal? (status '(- (expt (+ a b) 2) (+ (* a a) (* 2 a b) (* b b)))) 'proved)
  (check-equal? (status '(- 1 (expt (sin (x t)) 2) (expt (cos (x t)) 2))) 'proved)
  (check-equal? (status 0) 'proved))

(test-case "sums of arcs are angles"
  (for ([d (in-list '((- (+ (atan 1/2) (atan 1/3)) (* 1/4 :pi))
                      (- (* 4 (atan 1/5)) (atan 1/239) (* 1/4 :pi))
                      (- (+ (asin x) (acos x)) (* 1/2 :pi))
                      (- (atan x) (asin (/ x (sqrt (+ 1 (* x x))))))))])
    (define v (verdict d))
    (check-equal? (zero-test-status v) 'proved (format "~s" d))
    (check-equal? (zero-test-residual v) 0))
  (check-equal? (status '(- (* 4 (atan 1/5)) (atan 1/240) (* 1/4 :pi))) 'refuted))

;; At y = 0, x < 0 the sum of the last is 2π; with a negative factor a difference is π.
(test-case "angles of points that are alike but for a length are one"
  (define (of y x) (status `(- (atan ,y ,x) (atan y x))))
  (check-equal? (of '(* 2 y) '(* 2 x)) 'proved)
  (check-equal? (of '(* (exp u) y) '(* x (exp u))) 'proved)
  (check-equal? (of '(* r r y) '(* r r x)) 'proved)
  (check-equal? (of '(* x y) '(* x x)) 'refuted)
  (check-equal? (of '(* -2 y) '(* -2 x)) 'refuted)
  (check-false (eq? 'proved (status '(+ (atan y x) (atan (* -1 y) x))))))

(test-case "inverses of hyperbolic functions are logarithms"
  (define (proved? d relations)
    (eq? 'proved (zero-test-status
                  (zero-test (datum->expression d) (declare-relations no-assumptions relations)))))
  (check-true (proved? '(- (atanh x) (* 1/2 (- (log (+ 1 x)) (log (- 1 x)))))
                       '((< x 1) (> x -1))))
  (check-true (proved? '(- (asinh x) (log (+ x (sqrt (+ 1 (expt x 2)))))) '()))
  (check-true (proved? '(- (acosh x) (log (+ x (sqrt (- (expt x 2) 1))))) '((> x 1)))))

(test-case "a refutation carries a point that a person can check"
  (for ([d (in-list '((+ (* m (((expt D 2) x) t)) (* k (x t)))
                      (- (* a k (cos (+ (* omega t) phi)))
                         (* a m omega omega (cos (+ phi (* t omega)))))
                      (- (V (x t)) (V (y t)))
                      x))])
    (define e (datum->expression d))
    (define v (zero-test e))
    (check-equal? (zero-test-status v) 'refuted)
    (check-false (zero-test-reason v))
    (define value (evaluate-expression e (point-lookup (zero-test-witness v))))
    (check-= value (zero-test-value v) 1e-9)
    (check-true (> (abs value) 1e-6))
    (for ([entry (in-list (zero-test-witness v))])
      (check-true (<= -11 (cdr entry) 11)))))

(test-case "a refutation of a trigonometric identity has an exact value"
  (for ([d (in-list '((* a (- k (* m (expt omega 2))) (cos (+ (* omega t) phi)))
                      (- (sin (theta t)) (* 2 (cos (theta t))))
                      (* (exp (* -1 gamma t)) (+ (* b (x t)) (((expt D 2) x) t)))))])
    (define v (verdict d))
    (check-equal? (zero-test-status v) 'refuted)
    (check-true (exact? (zero-test-value v)))
    (check-equal? (evaluate-expression (datum->expression d) (point-lookup (zero-test-witness v)))
                  (zero-test-value v))))

(test-case "complex numbers are refuted as real ones are"
  (check-equal? (status +i) 'refuted)
  (check-equal? (status '(+ (* +i a) b)) 'refuted)
  (check-equal? (status '(+ 1 (* +i +i))) 'proved))

(test-case "what holds for positive numbers only is refuted by a negative one"
  (check-equal? (status '(- (abs x) x)) 'refuted)
  (check-equal? (status '(- (abs (sin x)) (sin x))) 'refuted))

(test-case "a literal function has one value for one argument"
  (check-equal? (status '(- (V (+ a a)) (V (* 2 a)))) 'proved)
  (define v (verdict '(- (V a) (V b))))
  (check-not-equal? (cdr (assq 'a (zero-test-witness v)))
                    (cdr (assq 'b (zero-test-witness v)))))

(test-case "what vanishes for any numbers in place of flonums is proved"
  (check-equal? (status '(- (* 9.8 (+ a 1)) (* 9.8 a) 9.8)) 'proved)
  (check-equal? (status '(- (/ -9.8 l) (* -1 9.8 (/ 1 l)))) 'proved)
  (check-equal? (status '(+ (expt (sin (* 2.1 t)) 2) -1 (expt (cos (* 2.1 t)) 2))) 'proved)
  (check-equal? (status '(- (expt (sqrt (/ 9.8 l)) 2) (/ 9.8 l))) 'proved))

(define (readings d)
  (for/list ([r (in-list (zero-test-decimals (verdict d)))])
    (list (reading-decimal r) (expression->datum (reading-expression r)))))

(test-case "what vanishes for the flonums it has is proved as they are read"
  (check-equal? (status '(- (* 1/2 m) (* 0.5 m))) 'proved)
  (check-equal? (readings '(- (* 1/2 m) (* 0.5 m))) '((0.5 1/2)))
  (check-equal? (status '(- (sqrt (* 0.25 a)) (* 0.5 (sqrt a)))) 'proved)
  (check-equal? (status '(- (* 1.4142135623730951 1.4142135623730951 a) (* 2 a))) 'proved)
  (check-equal? (readings '(- (cos (* 1.4142135623730951 a)) (cos (* (sqrt 2) a))))
                '((1.4142135623730951 (sqrt 2)))))

(test-case "what vanishes for the flonums it has alone is undecided, and they are told"
  (check-equal? (status '(- (cos (* 1.3579246801 a)) (cos (* 1.3579246801000003 a)))) 'undecided)
  (check-equal? (readings '(- (cos (* 1.3579246801 a)) (cos (* 1.3579246801000003 a))))
                '((1.3579246801 #f) (1.3579246801000003 #f)))
  (check-equal? (status '(- (cos (* 1.41421356 a)) (cos (* (sqrt 2) a)))) 'refuted)
  (check-equal? (status '(- (abs (* 9.8 a)) (* 9.8 (abs a)))) 'proved)
  (check-equal? (status (make-node op:- (list 9.8 9.8))) 'undecided))

(test-case "flonums are never refuted within rounding"
  (check-equal? (status '(+ (* 0.1 a) (* 0.2 a) (* -0.3 a))) 'proved)
  (check-equal? (status '(+ (* 0.1 a) (* 0.2 a) (* -0.3001 a))) 'refuted))

(test-case "outside the decidable class a numerical zero is undecided, with its bound"
  (define v (verdict '(- (expt (- (expt 2 1/3) 1) 1/3)
                         (expt 1/9 1/3) (* -1 (expt 2/9 1/3)) (expt 4/9 1/3))))
  (check-equal? (zero-test-status v) 'undecided)
  (check-true (< 0 (zero-test-bound v) 1e-12))
  (check-true (> (zero-test-points v) 5)))

(test-case "the core of a residual gives the condition on its parameters"
  (define v (verdict '(- (* a k (cos (+ (* omega t) phi)))
                         (* a m omega omega (cos (+ phi (* t omega)))))))
  (check-equal? (zero-test-core v) (datum->expression '(- k (* m (expt omega 2)))))
  (check-equal? (zero-test-factor v) (datum->expression '(* a (cos (+ (* omega t) phi)))))
  (check-equal? (zero-test-conditions v) '((= k (* m (expt omega 2))))))

(define (conditions d . variables)
  (zero-test-conditions (zero-test (datum->expression d) no-assumptions variables)))

(test-case "a condition is the equation that is read most easily"
  (check-equal? (conditions '(- (* R R R w w) (* G M))) '((= (* G M) (* (expt R 3) (expt w 2)))))
  (check-equal? (conditions '(- (* m m) (* k k))) '((= (expt k 2) (expt m 2))))
  (check-equal? (conditions '(- (* l l m) 1)) '((= (* (expt l 2) m) 1)))
  (check-equal? (conditions '(- (* k (+ m1 m2)) (* m1 m2 w w)))
                '((= (expt w 2) (+ (/ k m1) (/ k m2)))))
  (check-equal? (conditions '(- g (* R w w (cos theta)))) '((= g (* R (expt w 2) (cos theta))))))

(test-case "an equation that is linear in a symbol is solved for it"
  (check-equal? (conditions '(- (* p (cos beta)) (* W (sin beta))))
                '((= W (/ (* p (cos beta)) (sin beta))))))

(test-case "there is no condition where nothing real could meet it, nor one in circles"
  (check-equal? (conditions '(+ (* a a) (* b b))) '())
  (check-equal? (conditions '(+ (* a a) 1)) '())
  (check-equal? (conditions '(- (sin theta) theta)) '())
  (check-equal? (conditions '(- (sqrt (+ (* a a) (* b b))) a b)) '()))

(test-case "what moves is no parameter: its coefficients have to vanish"
  (check-equal? (conditions '(- g (* 6 c t)) 't) '())
  (check-equal? (conditions '(+ (* (- b (* 2 c)) (sin (* w t)))
                                (* (- k (* m w w)) (cos (* w t)))) 't)
                '((= b (* 2 c)) (= k (* m (expt w 2)))))
  (check-equal? (conditions '(+ (* (- b c) t) (* b t t)) 't) '())
  (check-equal? (conditions '(+ (* k (x t)) (* m (((expt D 2) x) t)))) '()))

(test-case "a product of one-term factors has no core"
  (define v (verdict '(* -5 b (sin (* 3 t)))))
  (check-equal? (zero-test-core v) (zero-test-residual v))
  (check-equal? (zero-test-conditions v) '()))

(test-case "a witness is real and positive where that suffices"
  (for ([d (in-list '((- (sqrt (- (* b b) (* 4 k m))) b)
                      (* (exp (* t (sqrt (- a b)))) (- a b) (+ 1 (sqrt (- a b))))
                      (- (* k (cos (* t (sqrt (/ k m))))) 1)))])
    (define v (verdict d))
    (check-true (real? (zero-test-value v)) (format "~s" d))
    (check-true (andmap (lambda (w) (>= (cdr w) 0)) (zero-test-witness v))
                (format "~s ~s" d (zero-test-witness v)))))

(test-case "what has a real value nowhere is not refuted"
  (define v (verdict '(- (sqrt (- -1 (* a a))) b)))
  (check-equal? (zero-test-status v) 'undecided)
  (check-equal? (zero-test-points v) 0))

(test-case "what a verdict takes for granted is told"
  (define v (verdict '(- (sqrt (expt R 2)) R)))
  (check-equal? (zero-test-status v) 'proved)
  (check-equal? (zero-test-assumptions v) '((>= R 0))))

;; ---------------------------------------------------------------------------
;; Under assumptions

(define (under relations d)
  (define data
    (apply append (for/list ([r (in-list relations)]) (split-relation r))))
  (zero-test (datum->expression d) (declare-relations no-assumptions data)))

(test-case "an identity may be proved by what is declared"
  (define v (under '((< x 0)) '(+ (sqrt (expt x 2)) x)))
  (check-equal? (zero-test-status v) 'proved)
  (check-equal? (zero-test-assumptions v) '((< x 0))))

(test-case "a root and an absolute value agree, whatever the sign"
  (define v (verdict '(- (sqrt (expt x 2)) (abs x))))
  (check-equal? (zero-test-status v) 'proved)
  (check-equal? (zero-test-assumptions v) '()))

(test-case "at a witness all that was declared holds"
  (define (check-witness relations d ok?)
    (define v (under relations d))
    (check-equal? (zero-test-status v) 'refuted (format "~s" d))
    (define e (datum->expression d))
    (check-= (evaluate-expression e (point-lookup (zero-test-witness v))) (zero-test-value v) 1e-9)
    (check-true (ok? (lambda (x) (cdr (assoc x (zero-test-witness v)))))
                (format "~s" (zero-test-witness v))))
  (check-witness '((> x 0)) '(+ (sqrt (expt x 2)) x) (lambda (at) (> (at 'x) 0)))
  (check-witness '((< x 0)) '(- (sqrt (expt x 2)) x) (lambda (at) (< (at 'x) 0)))
  (check-witness '((< 0 e 1)) '(- (expt e 2) e) (lambda (at) (< 0 (at 'e) 1)))
  (check-witness '((< -3 x -2)) '(+ 3/2 (sin x)) (lambda (at) (< -3 (at 'x) -2)))
  (check-witness '((> x 7/2) (< x 9/2)) '(- x 5) (lambda (at) (= (at 'x) 4)))
  (check-witness '((> a b)) '(- (abs (- a b)) (- b a)) (lambda (at) (> (at 'a) (at 'b))))
  (check-witness '((> theta 0)) '(sin theta) (lambda (at) (> (at 'theta) 0)))
  (define q '((D q) t))
  (check-witness (list (list '< q 0)) (list '- (list 'abs q) q)
                 (lambda (at) (< (at (datum->expression q)) 0))))

(test-case "what vanishes where the assumptions hold is not refuted elsewhere"
  (check-not-equal? (zero-test-status (under '((>= x 0) (<= x 0)) 'x)) 'refuted)
  (check-not-equal? (zero-test-status (under '((> x 0)) '(- (abs x) x))) 'refuted))

(test-case "the condition is none that the assumptions exclude"
  (check-equal? (zero-test-conditions (under '((> a b)) '(- a b))) '())
  (check-equal? (zero-test-conditions (under '((> a 0)) '(* (+ 1 a) (- k m)))) '((= k m))))

;; Large enough for the fingerprint, which takes roots of squares to be positive.
(test-case "the fingerprint does not decide what depends on a sign"
  (define terms
    (for/list ([k (in-range 1200)]) (e:* (+ k 1) (make-node op:cos (list (e:+ 'y k))))))
  (define sum (make-node op:+ terms))
  (define (test d relation)
    (zero-test (make-node op:- (list (e:+ (datum->expression d) sum) sum))
               (declare-relations no-assumptions (list relation))))
  (check-equal? (zero-test-status (test '(+ x (sqrt (expt x 2))) '(< x 0))) 'proved)
  (define v (test '(- x (sqrt (expt x 2))) '(< x 0)))
  (check-equal? (zero-test-status v) 'refuted)
  (check-true (< (cdr (assq 'x (zero-test-witness v))) 0)))
