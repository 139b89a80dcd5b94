#lang racket/base
;; Definite integrals as formulas: against closed forms, and against numbers.

(require mechanics "../support/checks.rkt")

(define-check (check-integral f low high expected)
  (define found (definite-integral f low high))
  (unless (proved? (prove-zero (- found expected)))
    (with-check-info (['found found]) (fail-check))))

(test-case "polynomials, waves, exponentials and products of them, between symbols"
  (check-integral (lambda (x) (expt x 3)) 'a 'b (* 1/4 (- (expt 'b 4) (expt 'a 4))))
  (check-integral (lambda (x) (* 'k x)) 0 1 (* 1/2 'k))
  (check-integral (lambda (x) (cos (* 'w x))) 0 'T (/ (sin (* 'w 'T)) 'w))
  (check-integral (lambda (x) (* x (exp (* -1 'k x)))) 0 'T
                  (/ (- 1 (* (exp (* -1 'k 'T)) (+ 1 (* 'k 'T)))) (square 'k)))
  (check-integral (lambda (x) (* (exp x) (sin x))) 0 'b
                  (* 1/2 (+ 1 (* (exp 'b) (- (sin 'b) (cos 'b))))))
  (check-integral (lambda (x) 'c) 'a 'b (* 'c (- 'b 'a)))
  (check-integral (lambda (x) 1) 'a 'b (- 'b 'a)))

(test-case "no sign of the integrand's argument is taken for granted"
  (check-integral (lambda (x) (* 'k (sqrt (square x)))) -1 1 'k)
  (check-integral (lambda (x) (sqrt (square x))) -1 'b (* 1/2 (+ 1 (* 'b (abs 'b))))))

(test-case "formulas agree with numbers"
  (for ([f (list (lambda (x k) (* (square x) (sin (* k x))))
                 (lambda (x k) (* (exp (* k x)) (square (cos x))))
                 (lambda (x k) (/ 1 (expt (+ x k) 2))))])
    (define formula (definite-integral (lambda (x) (f x 'k)) 'a 'b))
    (define value (substitute (substitute (substitute formula 'k 0.7) 'a 0.2) 'b 1.3))
    (check-= value (definite-integral (lambda (x) (f x 0.7)) 0.2 1.3) 1e-9)))

(test-case "the action of the free particle is m (q2 - q1)^2 / (2 (t2 - t1))"
  (define ((L-free m) (up t q v)) (* 1/2 m (square v)))
  (define (line t) (+ 'q1 (* (/ (- 'q2 'q1) (- 't2 't1)) (- t 't1))))
  (check-pred proved?
              (prove-zero (- (Lagrangian-action (L-free 'm) line 't1 't2)
                             (/ (* 'm (square (- 'q2 'q1))) (* 2 (- 't2 't1)))))))

(test-case "what has no formula is refused, and says so"
  (check-exn #rx"^definite-integral: no formula was found for the integral of "
             (lambda () (definite-integral (lambda (x) (exp (* 'k (square x)))) 0 'b)))
  (check-exn #rx"^definite-integral: an integral with symbols goes from one expression to another"
             (lambda () (definite-integral (lambda (x) (exp (* -1 'k x))) 0 +inf.0))))

(test-case "a formula can be differentiated, and comes with the bound 0"
  (define (F b) (definite-integral (lambda (x) (* 'k (sin x))) 0 b))
  (check-pred proved? (prove-zero (- ((D F) 'b) (* 'k (sin 'b)))))
  (check-pred proved? (prove-zero (- (((square D) F) 'b) (* 'k (cos 'b)))))
  (check-equal? (definite-integral (lambda (x) x) 0 'a #:report (lambda (v bound n) bound)) 0))

(define-syntax-rule (conditions f low high) (integral-conditions f low high))

(test-case "powers, quadratic polynomials and their roots"
  (define (check-formula f low high expected)
    (check-pred proved? (verify-integral f low high expected)))
  (check-formula (lambda (x) (expt x 'n)) 'a 'b
                 (/ (- (expt 'b (+ 'n 1)) (expt 'a (+ 'n 1))) (+ 'n 1)))
  (check-formula (lambda (x) (/ 1 (+ (square 'a) (square x)))) 0 'b (/ (atan (/ 'b 'a)) 'a))
  (check-formula (lambda (x) (/ 1 (sqrt (- (square 'a) (square x))))) 0 'b (asin (/ 'b 'a)))
  (check-formula (lambda (x) (/ x (+ 1 (square x)))) 0 'b (* 1/2 (log (+ 1 (square 'b)))))
  (for ([f (list (lambda (x k) (/ (+ 1 (* 2 x)) (+ (square k) 1 (* x x))))
                 (lambda (x k) (sqrt (+ 2 (* k k) (* x x))))
                 (lambda (x k) (/ (- x 3) (sqrt (- 9 (* x x) (* 0 k)))))
                 (lambda (x k) (/ k (- 9 (* x x)))))])
    (define formula (definite-integral (lambda (x) (f x 'k)) 'a 'b))
    (define value (substitute (substitute (substitute formula 'k 0.7) 'a 0.2) 'b 1.3))
    (check-= value (definite-integral (lambda (x) (f x 0.7)) 0.2 1.3) 1e-9)))

(test-case "conditions are values, and are gone where they are declared or known"
  (check-equal? (conditions (lambda (x) (exp (* 'k x))) 0 'T) '((> (abs k) 0)))
  (check-equal? (conditions (lambda (x) (expt x 'n)) 'a 'b)
                '((> a 0) (> b 0) (> (abs (+ 1 n)) 0)))
  (check-equal? (conditions (lambda (x) (expt x 'n)) 0 1) '((> (+ 1 n) 0) (> (abs (+ 1 n)) 0)))
  (check-equal? (conditions (lambda (x) (* (sin (* 'a x)) (sin (* 'b x)))) 0 'T)
                '((> (abs (- a b)) 0) (> (abs (+ a b)) 0)))
  (check-equal? (conditions (lambda (x) (/ 1 x)) 'a 'b) '((> (* a b) 0)))
  (check-equal? (conditions (lambda (x) (* 'k (square x))) 'a 'b) '())
  (check-equal? (assuming ('(> a 0) '(> b 0)) (conditions (lambda (x) (/ 1 x)) 'a 'b)) '())
  (check-equal? (assuming ('(< k 0)) (conditions (lambda (x) (exp (* 'k x))) 0 'T)) '())
  (check-equal? (assuming ('(> (abs k) 0)) (conditions (lambda (x) (exp (* 'k x))) 0 'T)) '())
  (check-exn #rx"^definite-integral: the integrand has no integral between these ends, or none "
             (lambda ()
               (assuming ('(> a 0) '(< b 0)) (definite-integral (lambda (x) (/ 1 x)) 'a 'b)))))

;; The roots of x² + 5x + 5 are (−5 ± √5)/2, about -3.6 and -1.4; x² + 4x + 5 has none.
(test-case "no root of a quadratic polynomial lies between the ends"
  (define (over-roots x) (/ (+ 5 (* 2 x)) (+ 5 (* 5 x) (* x x))))
  (check-equal? (conditions over-roots -1 'b)
                '((> (+ 5/2 b (* -1/2 (sqrt 5))) 0) (> (+ 5/2 b (* 1/2 (sqrt 5))) 0)))
  (check-equal? (conditions over-roots -3 -2) '())
  (for ([ends '((-2 0) (-4 -3) (-4 0))])
    (check-exn #rx"^integral-conditions: the integrand has no integral between these ends"
               (lambda () (apply integral-conditions over-roots ends))))
  (check-equal? (conditions (lambda (x) (/ (+ 4 (* 2 x)) (+ 5 (* 4 x) (* x x)))) 'a 'b) '()))

(test-case "waves below a fraction, and in a cosine below"
  (check-equal? (conditions (lambda (x) (/ (sin x) (+ 'a (* 'b (cos x))))) 0 'T)
                '((> (- (expt a 2) (expt b 2)) 0) (> (abs b) 0)))
  (check-equal? (conditions (lambda (x) (/ 1 (cos x))) 'a 'b)
                '((> (- :pi (abs (- a b))) 0) (> (* (cos a) (cos b)) 0)))
  (check-exn #rx"^integral-conditions: the integrand has no integral between these ends"
             (lambda () (conditions (lambda (x) (/ (- (* 5 (expt x 4)) 1) (+ 'a (expt x 5) (- x))))
                                    0 'T))))

(test-case "a verdict on an integral rests on its conditions, and they are among those used"
  (define v (verify-integral (lambda (x) (exp (* 'k x))) 0 'T (/ (- (exp (* 'k 'T)) 1) 'k)))
  (check-pred proved? v)
  (check-equal? (verdict-assumptions v) '((> (abs k) 0)))
  (check-not-false (member '(> (abs k) 0) (assumptions 'used)))
  (check-pred refuted?
              (verify-integral (lambda (x) (exp (* 'k x))) 0 'T (/ (exp (* 'k 'T)) 'k))))

(test-case "what is no integrand and no claim is refused in these words"
  (check-exn #rx"^verify-integral: expected a function of one variable\n  given: .*x"
             (lambda () (verify-integral (* 'a 'x) 0 'b 'c)))
  (check-exn #rx"^verify-integral: expected an expression or a number as the claim"
             (lambda () (verify-integral sin 0 'b cos)))
  (check-exn #rx"^verify-integral: expected an expression or a number as the claim"
             (lambda () (verify-integral sin 0 'b "1 - cos b")))
  (check-exn #rx"\n  integrand: [(]/ 1 x[)]$"
             (lambda () (verify-integral (lambda (x) (/ 1 x)) -1 1 0))))

(test-case "the action of the oscillator between two points"
  (define (L local) (* 1/2 'm (- (square (velocity local)) (square (* 'w (coordinate local))))))
  (define (motion t)
    (/ (+ (* 'q1 (sin (* 'w (- 'T t)))) (* 'q2 (sin (* 'w t)))) (sin (* 'w 'T))))
  (define claim
    (/ (* 'm 'w (- (* (+ (square 'q1) (square 'q2)) (cos (* 'w 'T))) (* 2 'q1 'q2)))
       (* 2 (sin (* 'w 'T)))))
  (check-pred proved? (verify-integral (compose L (Gamma motion)) 0 'T claim))
  (check-pred proved? (prove-zero (- (Lagrangian-action L motion 0 'T) claim))))

(test-case "an end may be a multiple of π by its name"
  (check-equal? (expression (definite-integral (lambda (x) (* 'a (sin x))) 0 ':pi)) '(* 2 a))
  (check-equal? (expression (definite-integral (lambda (x) (* 'a (cos x))) ':-pi (/ ':pi 2))) 'a)
  (check-= (definite-integral sin 0 ':pi) 2 1e-12))

(test-case "from the greater end to the less a kink between them counts as the other way"
  (define (f x) (* 'a (abs (- x 3/2))))
  (check-equal? (expression (definite-integral f 1 2)) '(* 1/4 a))
  (check-equal? (expression (definite-integral f 2 1)) '(* -1/4 a)))

(test-case "an end that is a number makes a decimal, within a claim an exact number"
  (check-equal? (definite-integral (lambda (x) (* 'a (cos x))) 0 1) (* (sin 1.0) 'a))
  (check-pred proved? (verify-integral cos 0 1 (read-expression '(sin 1)))))
