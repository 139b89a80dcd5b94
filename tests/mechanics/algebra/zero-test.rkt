#lang racket/base
;; Verdicts: what is proved, refuted, left undecided, and what they carry.

(require rackunit "reading.rkt"
         mechanics/algebra/assumptions mechanics/algebra/declare mechanics/algebra/evaluate
         mechanics/algebra/expression mechanics/algebra/operation mechanics/algebra/relation
         mechanics/algebra/zero-test)

(define (verdict d) (zero-test (datum->expression d)))
(define (status d) (zero-test-status (verdict d)))

(test-case "an identity is proved"
  (check-equal? (status '(- (expt (+ a b) 2) (+ (* a a) (* 2 a b) (* b b)))) 'proved)
  (check-equal? (status '(- 1 (expt (sin (x t)) 2) (expt (cos (x t)) 2))) 'proved)
  (check-equal? (status 0) 'proved))

(test-case "a refutation carries a point that a person can check"
  (for ([d (in-list '((+ (* m (((expt D 2) x) t)) (* k (x t)))
                      (- (* a k (cos (+ (* omega t) phi)))
                         (* a m omega omega (cos (+ phi (* t omega)))))
                      (- (V (x t)) (V (y t)))
                      x))])
    (define e (datum->expression d))
    (define v (zero-test e))
    (check-equal? (zero-test-status v) 'refuted)
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

(test-case "flonum input is never proved, and never refuted within rounding"
  (check-equal? (status '(- (* 9.8 (+ a 1)) (* 9.8 a) 9.8)) 'undecided)
  (check-equal? (status '(+ (* 0.1 a) (* 0.2 a) (* -0.3 a))) 'undecided)
  (check-equal? (status '(+ (* 0.1 a) (* 0.2 a) (* -0.3001 a))) 'refuted))

(test-case "outside the decidable class a numerical zero is undecided, with its bound"
  (define v (verdict '(- (sqrt (+ 5 (* 2 (sqrt 6)))) (sqrt 2) (sqrt 3))))
  (check-equal? (zero-test-status v) 'undecided)
  (check-true (< 0 (zero-test-bound v) 1e-12))
  (check-true (> (zero-test-points v) 5)))

(test-case "the core of a residual gives the condition on its parameters"
  (define v (verdict '(- (* a k (cos (+ (* omega t) phi)))
                         (* a m omega omega (cos (+ phi (* t omega)))))))
  (check-equal? (zero-test-core v) (datum->expression '(- k (* m (expt omega 2)))))
  (check-equal? (zero-test-factor v) (datum->expression '(* a (cos (+ (* omega t) phi)))))
  (check-equal? (zero-test-condition v) '(= k (* m (expt omega 2)))))

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

(test-case "a root and an absolute value agree where the root is real"
  (define v (verdict '(- (sqrt (expt x 2)) (abs x))))
  (check-equal? (zero-test-status v) 'proved)
  (check-equal? (zero-test-assumptions v) '((>= x 0))))

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
  (check-equal? (zero-test-condition (under '((> a b)) '(- a b))) #f)
  (check-equal? (zero-test-condition (under '((> a 0)) '(* (+ 1 a) (- k m)))) '(= k m)))

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
