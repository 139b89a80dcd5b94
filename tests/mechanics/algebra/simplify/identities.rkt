#lang racket/base
;; Identities by name.  Each is proved, by simplification and by the zero test;
;; each with one thing changed is refuted, at a point where the two sides differ.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation
         mechanics/algebra/simplify/simplify-expression
         mechanics/algebra/zero/zero-test
         mechanics/algebra/expression/read
         "../../support/checks.rkt" "../../support/evaluate.rkt")

(define (difference u v)
  (make-node op:- (list (datum->expression u) (datum->expression v))))

;; left = right, but not = wrong
(define (check-identity name left right wrong)
  (test-case name
    (define zero (difference left right))
    (check-equal? (simplify-expression zero) 0)
    (check-eq? (zero-test-status (zero-test zero)) 'proved)
    (define other (difference left wrong))
    (define z (zero-test other))
    (check-eq? (zero-test-status z) 'refuted)
    (check-not-equal? (simplify-expression other) 0)
    (define (cancelled leaf arguments) 2/7)
    (define value (evaluate-expression other (point-lookup (zero-test-witness z) cancelled)))
    (check-true (> (magnitude value) 1e-9))
    (check-= value (zero-test-value z) (+ 1e-9 (* 4 (zero-test-bound z))))))

(define-syntax-rule (check-identities [name left right wrong] ...)
  (begin (check-identity name 'left 'right 'wrong) ...))

;; ---------------------------------------------------------------------------
;; Sums of squares and determinants

(check-identities
 ["Brahmagupta"
  (* (+ (* a a) (* n b b)) (+ (* c c) (* n d d)))
  (+ (expt (- (* a c) (* n b d)) 2) (* n (expt (+ (* a d) (* b c)) 2)))
  (+ (expt (+ (* a c) (* n b d)) 2) (* n (expt (+ (* a d) (* b c)) 2)))]
 ["Lagrange"
  (- (* (+ (* a a) (* b b) (* c c)) (+ (* x x) (* y y) (* z z)))
     (expt (+ (* a x) (* b y) (* c z)) 2))
  (+ (expt (- (* a y) (* b x)) 2) (expt (- (* a z) (* c x)) 2) (expt (- (* b z) (* c y)) 2))
  (+ (expt (- (* a y) (* b x)) 2) (expt (- (* a z) (* c x)) 2) (expt (- (* b z) (* a y)) 2))]
 ["Binet and Cauchy"
  (- (* (+ (* a c) (* b d)) (+ (* p r) (* q s))) (* (+ (* a r) (* b s)) (+ (* p c) (* q d))))
  (* (- (* a q) (* b p)) (- (* c s) (* d r)))
  (* (- (* a q) (* b p)) (- (* c r) (* d s)))]
 ["Euler's four squares"
  (* (+ (* a a) (* b b) (* c c) (* d d)) (+ (* p p) (* q q) (* r r) (* s s)))
  (+ (expt (- (* a p) (* b q) (* c r) (* d s)) 2)
     (expt (+ (* a q) (* b p) (* c s) (* -1 d r)) 2)
     (expt (+ (* a r) (* -1 b s) (* c p) (* d q)) 2)
     (expt (+ (* a s) (* b r) (* -1 c q) (* d p)) 2))
  (+ (expt (- (* a p) (* b q) (* c r) (* d s)) 2)
     (expt (+ (* a q) (* b p) (* c s) (* d r)) 2)
     (expt (+ (* a r) (* -1 b s) (* c p) (* d q)) 2)
     (expt (+ (* a s) (* b r) (* -1 c q) (* d p)) 2))]
 ["Vandermonde of three"
  (+ (* y z z) (* z x x) (* x y y) (* -1 y y z) (* -1 z z x) (* -1 x x y))
  (* (- y x) (- z x) (- z y))
  (* (- y x) (- z x) (- y z))]
 ["Heron"
  (expt (* 1/4 (sqrt (* (+ a b c) (+ a b (* -1 c)) (+ a (* -1 b) c) (+ (* -1 a) b c)))) 2)
  (/ (- (* 4 a a b b) (expt (- (+ (* a a) (* b b)) (* c c)) 2)) 16)
  (/ (- (* 4 a a b b) (expt (+ (* a a) (* b b) (* c c)) 2)) 16)]
 ["Sophie Germain"
  (+ (expt a 4) (* 4 (expt b 4)))
  (* (+ (* a a) (* 2 b b) (* 2 a b)) (+ (* a a) (* 2 b b) (* -2 a b)))
  (* (+ (* a a) (* 2 b b) (* 2 a b)) (+ (* a a) (* 2 b b) (* 2 a b)))])

;; ---------------------------------------------------------------------------
;; Angles

(check-identities
 ["the sine of a sum" (sin (+ a b)) (+ (* (sin a) (cos b)) (* (cos a) (sin b)))
  (- (* (sin a) (cos b)) (* (cos a) (sin b)))]
 ["the tangent of a sum" (tan (+ a b)) (/ (+ (tan a) (tan b)) (- 1 (* (tan a) (tan b))))
  (/ (+ (tan a) (tan b)) (+ 1 (* (tan a) (tan b))))]
 ["a half angle" (expt (sin (/ x 2)) 2) (/ (- 1 (cos x)) 2) (/ (+ 1 (cos x)) 2)]
 ["the tangent of a half angle" (tan (/ x 2)) (/ (sin x) (+ 1 (cos x))) (/ (sin x) (- 1 (cos x)))]
 ["a triple angle" (cos (* 3 x)) (- (* 4 (expt (cos x) 3)) (* 3 (cos x)))
  (- (* 3 (cos x)) (* 4 (expt (cos x) 3)))]
 ["a fifth angle" (sin (* 5 x))
  (+ (* 16 (expt (sin x) 5)) (* -20 (expt (sin x) 3)) (* 5 (sin x)))
  (+ (* 16 (expt (sin x) 5)) (* -20 (expt (sin x) 3)) (* -5 (sin x)))]
 ["a product of sines" (* (sin a) (sin b)) (/ (- (cos (- a b)) (cos (+ a b))) 2)
  (/ (+ (cos (- a b)) (cos (+ a b))) 2)]
 ["a sum of cosines" (+ (cos a) (cos b)) (* 2 (cos (/ (+ a b) 2)) (cos (/ (- a b) 2)))
  (* 2 (sin (/ (+ a b) 2)) (cos (/ (- a b) 2)))]
 ["Morrie's product" (* 8 (cos x) (cos (* 2 x)) (cos (* 4 x)) (sin x)) (sin (* 8 x)) (sin (* 4 x))]
 ["sines of three angles"
  (+ (sin a) (sin b) (sin c) (* -1 (sin (+ a b c))))
  (* 4 (sin (/ (+ a b) 2)) (sin (/ (+ b c) 2)) (sin (/ (+ c a) 2)))
  (* 4 (sin (/ (+ a b) 2)) (sin (/ (+ b c) 2)) (cos (/ (+ c a) 2)))]
 ["the sum of a geometric series of angles"
  (* 2 (sin (/ x 2)) (+ (cos x) (cos (* 2 x)) (cos (* 3 x))))
  (- (sin (* 7/2 x)) (sin (/ x 2)))
  (- (sin (* 5/2 x)) (sin (/ x 2)))]
 ["angles that are functions" (sin (- (theta t) (phi t)))
  (- (* (sin (theta t)) (cos (phi t))) (* (cos (theta t)) (sin (phi t))))
  (+ (* (sin (theta t)) (cos (phi t))) (* (cos (theta t)) (sin (phi t))))]
 ["Machin's tangent, two steps"
  (tan (- (* 2 (atan 1/5)) (atan 1/239))) (/ (- 5/12 1/239) (+ 1 (* 5/12 1/239)))
  (/ (+ 5/12 1/239) (- 1 (* 5/12 1/239)))]
 ["Machin" (tan (- (* 4 (atan 1/5)) (atan 1/239))) 1 -1]
 ["polar coordinates" (* r (cos (atan y x)) (sqrt (+ (* x x) (* y y)))) (* r x) (* r y)])

;; ---------------------------------------------------------------------------
;; Exponentials, logarithms, roots

(check-identities
 ["cosh² - sinh²" (- (expt (cosh x) 2) (expt (sinh x) 2)) 1 -1]
 ["a hyperbolic sum" (cosh (+ a b)) (+ (* (cosh a) (cosh b)) (* (sinh a) (sinh b)))
  (- (* (cosh a) (cosh b)) (* (sinh a) (sinh b)))]
 ["tanh by exponentials" (tanh x) (/ (- (exp (* 2 x)) 1) (+ (exp (* 2 x)) 1))
  (/ (+ (exp (* 2 x)) 1) (- (exp (* 2 x)) 1))]
 ["exponents add" (* (exp a) (expt (exp b) 2)) (exp (+ a (* 2 b))) (exp (+ a b))]
 ["a logarithm of a product" (log (* a (expt b 3))) (+ (log a) (* 3 (log b))) (+ (log a) (log b))]
 ["a power by logarithms" (exp (* n (log x))) (expt x n) (* n x)]
 ["conjugate roots" (/ 1 (- (sqrt 3) (sqrt 2))) (+ (sqrt 3) (sqrt 2)) (- (sqrt 3) (sqrt 2))]
 ["the golden ratio"
  (expt (/ (+ 1 (sqrt 5)) 2) 2)
  (+ 1 (/ (+ 1 (sqrt 5)) 2))
  (+ 2 (/ (+ 1 (sqrt 5)) 2))]
 ["the cosine of a fifth of a turn satisfies its equation"
  (- (* 4 (expt (/ (- (sqrt 5) 1) 4) 2)) 1) (* -2 (/ (- (sqrt 5) 1) 4)) (* 2 (/ (- (sqrt 5) 1) 4))]
 ["a cube root below" (/ 1 (- (expt a 1/3) 1)) (/ (+ (expt a 2/3) (expt a 1/3) 1) (- a 1))
  (/ (+ (expt a 2/3) (expt a 1/3) 1) (+ a 1))])

(test-case "nested radicals outside the class are undecided, not wrong"
  (define (status right)
    (zero-test-status (zero-test (difference '(expt (- (expt 2 1/3) 1) 1/3) right))))
  (check-eq? (status '(+ (expt 1/9 1/3) (* -1 (expt 2/9 1/3)) (expt 4/9 1/3))) 'undecided)
  (check-eq? (status '(+ (expt 1/9 1/3) (* -1 (expt 2/9 1/3)) (expt 5/9 1/3))) 'refuted)
  (check-eq? (zero-test-status (zero-test (difference '(expt (+ 7 (* 5 (sqrt 2))) 1/3)
                                                      '(+ 1 (sqrt 2)))))
             'proved))

(test-case "roots of roots are roots"
  (check-equal? (simplify-expression (difference '(sqrt (sqrt (* 4 a))) '(* (sqrt 2) (expt a 1/4))))
                0))
