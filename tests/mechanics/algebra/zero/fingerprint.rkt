#lang racket/base
;; Fingerprints: what vanishes is 'zero, what does not is 'nonzero; and they cost
;; the graph.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation
         mechanics/algebra/zero/fingerprint
         mechanics/algebra/zero/zero-test
         mechanics/algebra/expression/read
         "../../support/checks.rkt" "../../support/random.rkt"
         "../../support/random/expression.rkt")

(define (judge d) (fingerprint (datum->expression d)))

(define-syntax-rule (check-all verdict d ...)
  (begin (check-eq? (judge 'd) 'verdict (format "~s" 'd)) ...))

;; ---------------------------------------------------------------------------
;; By name

(test-case "rational identities have the fingerprint zero"
  (check-all zero
    0
    (- (expt (+ a b) 2) (+ (* a a) (* 2 a b) (* b b)))
    (- (/ 1 (- a b)) (/ (+ a b) (- (expt a 2) (expt b 2))))
    (- (expt (+ a b) -3) (/ 1 (* (+ a b) (expt (+ a b) 2))))
    (- (* 0.5 a) (/ a 2))))

(test-case "sums and rational multiples of angles obey the addition formulas"
  (check-all zero
    (- 1 (expt (sin (x t)) 2) (expt (cos (x t)) 2))
    (- (sin (+ a b)) (* (sin a) (cos b)) (* (cos a) (sin b)))
    (- (sin a) (* 2 (sin (/ a 2)) (cos (/ a 2))))
    (- (cos (* 1/3 a)) (* 4 (expt (cos (* 1/9 a)) 3)) (* -3 (cos (* 1/9 a))))
    (- (tan (+ a b)) (/ (+ (tan a) (tan b)) (- 1 (* (tan a) (tan b)))))
    (+ (sin (- a b)) (sin (- b a)))
    (sin (- (* a b) (* b a)))))

(test-case "angles are compared as functions"
  (check-all zero
    (- (sin (* (+ a b) c)) (sin (+ (* a c) (* b c))))
    (- (cos (/ (- (* a a) (* b b)) (+ a b))) (cos (- a b)))
    (- (cos (sin (+ a b))) (cos (+ (* (sin a) (cos b)) (* (cos a) (sin b)))))
    (- (exp (sin (* 2 a))) (expt (exp (* (sin a) (cos a))) 2))))

(test-case "exponentials and hyperbolic functions obey their laws"
  (check-all zero
    (- (exp (+ a b)) (* (exp a) (exp b)))
    (- (exp a) (expt (exp (* 1/3 a)) 3))
    (- (* (exp a) (exp (- b a))) (exp b))
    (- (expt (cosh a) 2) (expt (sinh a) 2) 1)
    (- (+ (sinh a) (cosh a)) (exp a))
    (- (tanh a) (/ (sinh a) (cosh a)))))

(test-case "roots and powers obey their laws"
  (check-all zero
    (- (sqrt (* a b)) (* (sqrt a) (sqrt b)))
    (- (sqrt 6) (* (sqrt 2) (sqrt 3)))
    (- (expt (sqrt (+ a b)) 2) a b)
    (- (sqrt (expt a 2)) a)
    (- (expt (expt (+ a b) 1/3) 2) (expt (+ a b) 2/3))
    (- (expt (expt (- a b) 1/3) 3) (- a b))
    (- (* (expt (- b c) 1/5) (expt (- b c) 4/5)) (- b c))
    (- (expt (expt a 1/4) 2) (sqrt a))
    (- (expt (abs (- a b)) 2) (expt (- b a) 2))
    (- (expt a (+ n 1)) (* a (expt a n)))
    (- (expt (* a b) n) (* (expt a n) (expt b n)))))

(test-case "unknown functions of equal arguments are equal"
  (check-all zero
    (- (V (+ a a) 1) (V (* 2 a) 1))
    (- (((partial 0) V) (up (+ a a) b)) (((partial 0) V) (up (* 2 a) b)))
    (- (log (+ a a)) (log (* 2 a)))
    (- (atan (+ a a) b) (atan (* 2 a) b))))

(test-case "unknown functions, their derivatives and their arguments are told apart"
  (check-all nonzero
    (- (V (x t)) (V (y t)))
    (- (V a b) (V b a))
    (- ((D V) t) (V t))
    (- ((D V) t) (((expt D 2) V) t))
    (- (V (+ a 1)) (U a))
    (- (V (up a b)) (V (down a b))))
  (check-all nonzero? (- (asin a) (acos a)) (- (log a) a)))

(test-case "what does not vanish is told for certain, but not with roots and logarithms"
  (check-all nonzero
    a (sin 1) (- (exp 1) 1) (- (sin (* 2 a)) (* 2 (sin a)))
    (- (cos a) (cos (* 2 a))) (- (expt (sin a) 2) (expt (cos a) 2)) (- (exp a) (exp (* -1 a))))
  (check-all nonzero?
    (- (sqrt (+ a b)) (sqrt a) (sqrt b))
    (- (log (* a b)) (+ (log a) (log b)))
    (- (sin (sin (sin (sin (* 2 a))))) (sin a))))

(test-case "a point at which it is divided by zero is replaced; where there is none, that is said"
  (define squares                       ; some of a - 2, a - 3, ... have no root
    '(- (+ (sqrt (- a 2)) (sqrt (- a 3)) (sqrt (- a 5)))
        (+ (sqrt (- a 5)) (sqrt (- a 3)) (sqrt (- a 2)))))
  (check-equal? (judge squares) 'zero)
  (check-all unknown
    (/ 1 (- 1 (expt (sin a) 2) (expt (cos a) 2)))
    (expt (- (expt (+ a b) 2) (* a a) (* 2 a b) (* b b)) -2)
    (expt (- (expt (+ a b) 2) (* a a) (* 2 a b) (* b b)) -1/3)
    (+ a +i)
    (* a +inf.0)))

;; ---------------------------------------------------------------------------
;; At random

(define kinds '(rational trigonometric exponential))

;; The difference of an expression and a rewritten one, for every rule.
(define (for-each-difference rules kinds try)
  (with-seeds 30
    (for ([rule (in-list rules)])
      (define e (random-expression 4 kinds))
      (define other (with-handlers ([exn:fail:contract:divide-by-zero? (lambda (x) e)])
                      (rewrite e rule)))
      (try (car rule) (e:- e other)))))

(test-case "sound rewrites leave the fingerprint zero"
  (for-each-difference sound-rewrites kinds
    (lambda (name difference)
      (check-not-false (memq (fingerprint difference) '(zero unknown))
                       (format "~a: ~a" name difference)))))

(test-case "unsound rewrites show, exactly where the values differ"
  (define shown 0)
  (for-each-difference unsound-rewrites kinds
    (lambda (name difference)
      (define v (fingerprint difference))
      (define proved? (eq? 'proved (zero-test-status (zero-test difference))))
      (when (eq? v 'nonzero) (set! shown (+ shown 1)))
      (unless (eq? v 'unknown)
        (check-eq? v (if proved? 'zero 'nonzero) (format "~a: ~a" name difference)))))
  (check-true (> shown 20)))

(test-case "a perturbed identity is not zero"
  (with-seeds 30
    (define e (random-expression 4 kinds))
    (define perturbation (e:* 1/1000 (random-expression 1 kinds)))
    (unless (eq? 'proved (zero-test-status (zero-test perturbation)))
      (check-not-eq? (fingerprint (e:- (e:+ e perturbation) e)) 'zero))))

;; ---------------------------------------------------------------------------
;; Large graphs

;; x (x + k) + sin(k a): the tree doubles with every step.
(define (tower n x)
  (for/fold ([x x]) ([k (in-range n)])
    (e:+ (e:* x (e:+ x k)) (make-node op:sin (list (e:* k 'a))))))

(test-case "a tower of 100 000 nodes costs its nodes"
  (define e (tower 20000 'b))
  (check-eq? (fingerprint e) 'nonzero)
  (check-eq? (fingerprint (make-node op:- (list e (tower 20000 'b)))) 'zero)
  (check-eq? (fingerprint (make-node op:- (list e (tower 20000 'c)))) 'nonzero))

(test-case "a large residual is refuted by a point, or left undecided, without growing"
  (define (chain n sign)
    (for/fold ([sum 0] [x 'x] #:result (e:+ sum x)) ([k (in-range n)])
      (values (e:+ sum (e:* x (make-node op:sin (list (e:* k 'a)))))
              (e:/ (e:+ x k) (e:+ x (+ k sign))))))
  (define v (zero-test (e:- (chain 1000 1) (chain 1000 2))))
  (check-eq? (zero-test-status v) 'refuted)
  (check-not-false (assq 'x (zero-test-witness v))))

(test-case "the fingerprint is the same every time and in every thread"
  (define expressions
    (for/list ([d (in-list '((- (sin (+ a b)) (* (sin a) (cos b)) (* (cos a) (sin b)))
                             (- (V (x t)) (V (y t)))
                             (- (sqrt (+ a b)) (sqrt a))
                             (/ 1 (- 1 (expt (sin a) 2) (expt (cos a) 2)))))])
      (datum->expression d)))
  (define expected (map fingerprint expressions))
  (define results (make-vector 4 #f))
  (define threads
    (for/list ([i (in-range 4)])
      (thread (lambda ()
                (vector-set! results i
                             (for/last ([_ (in-range 20)]) (map fingerprint expressions)))))))
  (for-each thread-wait threads)
  (for ([r (in-vector results)]) (check-equal? r expected)))

;; Where one of the roots has no residue another point is tried: one in eight will do.
(test-case "the roots of an angle are looked at once, at the level of the angle"
  (define roots '((sqrt (- a 2)) (sqrt (- a 3)) (sqrt (- a 5))))
  (check-eq? (judge `(- (sin (+ ,@roots b)) (* (sin (+ ,@roots)) (cos b))
                        (* (cos (+ ,@roots)) (sin b))))
             'zero))

;; Half of the residues are no squares: of each there is a cube root all the same.
(test-case "odd roots, however many, have residues"
  (define roots
    (for/list ([i (in-range 16)])
      (define u `(+ y ,(string->symbol (format "x~a" i))))
      `(- (* (expt ,u 1/3) (expt ,u 2/3)) ,u)))
  (check-eq? (judge `(+ ,@roots)) 'zero)
  (check-eq? (judge `(+ z ,@roots)) 'nonzero?))
