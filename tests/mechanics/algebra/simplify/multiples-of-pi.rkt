#lang racket/base
;; π exactly, the symbol :pi: sines and cosines at its multiples, its sign and its digits.

(require racket/math
         mechanics/algebra/assumption/assumption-set
         mechanics/algebra/expression/constant-value
         mechanics/algebra/expression/expression
         mechanics/algebra/expression/read
         mechanics/algebra/expression/symbols
         mechanics/algebra/simplify/declare-relations
         mechanics/algebra/simplify/simplify-expression
         mechanics/algebra/zero/fingerprint
         mechanics/algebra/zero/vanishing
         mechanics/algebra/zero/zero-test
         "../../support/checks.rkt" "../../support/evaluate.rkt")

(define (simple d) (expression->datum (simplify-expression (datum->expression d))))

(define-syntax-rule (check-simple [d form] ...)
  (begin (check-equal? (simple 'd) 'form) ...))

(define (test d) (zero-test (datum->expression d)))
(define (status d) (zero-test-status (test d)))

(test-case "sines, cosines and tangents at multiples of a right angle"
  (check-simple
   [(sin :pi) 0] [(cos :pi) -1] [(tan :pi) 0]
   [(sin (* 1/2 :pi)) 1] [(cos (* 1/2 :pi)) 0] [(sin (* -1/2 :pi)) -1]
   [(sin (* 3/2 :pi)) -1] [(cos (* -5 :pi)) -1] [(cos (* 1000000000000 :pi)) 1]
   [(sin :2pi) 0] [(cos :-pi) -1] [(sin :pi/2) 1] [(cos (+ :pi :pi/2)) 0]))

(test-case "closed forms between them"
  (check-simple
   [(sin (* 1/6 :pi)) 1/2] [(cos (* 1/3 :pi)) 1/2] [(cos (* 2/3 :pi)) -1/2]
   [(sin (* 1/4 :pi)) (* 1/2 (sqrt 2))]
   [(cos (* 1/6 :pi)) (* 1/2 (sqrt 3))] [(tan (* 1/4 :pi)) 1]
   [(tan (* 1/3 :pi)) (sqrt 3)] [(tan (* -1/4 :pi)) -1]))

(test-case "the tangent of a right angle has no value"
  (check-eq? (status '(- (tan :pi/2) 1)) 'undecided)
  (check-eq? (zero-test-reason (test '(- (tan (* 3/2 :pi)) x))) 'nowhere))

(test-case "imaginary multiples in exponents"
  (check-simple
   [(exp (* +i :pi)) -1] [(exp (* +2i :pi)) 1] [(exp (* 1/2 -i :pi)) -i] [(exp (* +i :2pi)) 1]
   [(exp (* +i (+ x :pi))) (* -1 (exp (* +i x)))] [(exp :pi) (exp :pi)]
   [(exp (* +i 1/6 :pi)) (* 1/2 (+ +i (sqrt 3)))] [(exp (* -i 1/6 :pi)) (* 1/2 (- (sqrt 3) +i))])
  (for ([d (in-list '((- (exp (* +i 2/3 :pi)) (* 1/2 (+ -1 (* +i (sqrt 3)))))
                      (- (exp (* +i 8/7 :pi)) (* -1 (exp (* +i 1/7 :pi))))
                      (- (exp (* +i 4/7 :pi)) (* +i (exp (* +i 1/14 :pi))))))])
    (check-eq? (status d) 'proved (format "~s" d))))

;; The value of what has no unknown but pi.
(define (value d) (constant-value (datum->expression d)))

(test-case "every multiple of π by a small fraction keeps its value"
  (for* ([d (in-list '(1 2 3 4 5 6 7 8 9 10 12 15 24))] [n (in-range (* -2 d) (+ 1 (* 2 d)))]
         [f (in-list '(sin cos tan))])
    (define e `(,f (* ,(/ n d) :pi)))
    (unless (and (eq? f 'tan) (eqv? 2 (denominator (/ n d))))
      (check-= (value (simple e)) (value e) 1e-9 (format "~s: ~s" e (simple e))))))

(test-case "angles that differ by quarter turns"
  (check-simple
   [(sin (+ x :pi)) (* -1 (sin x))] [(cos (+ x :pi)) (* -1 (cos x))]
   [(sin (+ x (* 1/2 :pi))) (cos x)] [(cos (+ x (* 1/2 :pi))) (* -1 (sin x))]
   [(cos (- (* 1/2 :pi) x)) (sin x)] [(sin (- :pi x)) (sin x)]
   [(tan (+ x :pi)) (/ (sin x) (cos x))]
   [(tan (+ x :pi/2)) (/ (* -1 (cos x)) (sin x))]
   [(f :2pi) (f (* 2 :pi))] [(cos (+ x :2pi)) (cos x)]
   [(sin (* 3/7 :pi)) (cos (* 1/14 :pi))] [(sin (* 1/7 :pi)) (sin (* 1/7 :pi))]
   [(cos (* 9/7 :pi)) (* -1 (sin (* 3/14 :pi)))]))

(test-case "identities are proved"
  (for ([d (in-list
            '((- (+ (cos x) (cos (+ x (* 2/3 :pi))) (cos (+ x (* 4/3 :pi)))) 0)
              (- (* 4 (sin x) (sin (+ x (* 1/3 :pi))) (sin (+ x (* 2/3 :pi)))) (sin (* 3 x)))
              (- (* (sin (* 1/8 :pi)) (cos (* 1/8 :pi))) (* 1/4 (sqrt 2)))
              (- (cos (* 1/5 :pi)) (cos (* 2/5 :pi)) 1/2)
              (- (* 4 (sin (* 1/5 :pi)) (sin (* 2/5 :pi))) (sqrt 5))
              (- (* 2 (sin (* 1/12 :pi))) (sqrt (- 2 (sqrt 3))))
              (- (sin (* 5/12 :pi)) (cos (* 1/12 :pi)))
              (- (* 2 (sin (* 1/7 :pi)) (cos (* 1/7 :pi))) (sin (* 2/7 :pi)))
              (- (acos -1) :pi) (- (asin 1) :pi/2) (- (* 4 (atan 1)) :pi)
              (- (acos 1/2) (* 1/3 :pi)) (- (asin (* 1/2 (sqrt 3))) (* 1/3 :pi))
              (- (atan (sqrt 3)) (* 1/3 :pi)) (- (atan -1 -1) (* -3/4 :pi))
              (- (sqrt (expt (- :pi 4) 2)) (- 4 :pi)) (- (abs (- 3 :pi)) (- :pi 3))
              (- (sqrt (expt :pi 2)) :pi)))])
    (check-eq? (status d) 'proved (format "~s" d))))

(test-case "and what is false is refuted, at points that leave π what it is"
  (for ([d (in-list '((- :pi 22/7) (- :pi 355/113) (sin (* 22/7 x)) (- (sin (+ x :pi)) (sin x))
                      (- :2pi 6) (cos (* 1/7 :pi)) (- (* :pi x) (* 3 x)) (- (sqrt :pi) 7/4)
                      (- (exp :pi) :pi 20) (- (expt :pi 2) (* 355/113 :pi))
                      (- (asin 1/3) (* 1/9 :pi))))])
    (define z (test d))
    (check-eq? (zero-test-status z) 'refuted (format "~s" d))
    (check-equal? (filter (lambda (entry) (memq (car entry) '(:pi :2pi :pi/2 :-pi)))
                          (zero-test-witness z))
                  '())
    (check-= (evaluate-expression (datum->expression d) (point-lookup (zero-test-witness z)))
             (zero-test-value z) 1e-6)))

(test-case "no condition is put on what is a number"
  (check-equal? (zero-test-conditions (test '(* (- x 1) (- :pi 22/7)))) '((= x 1)))
  (check-equal? (zero-test-conditions (test '(- :pi 22/7))) '())
  (check-equal? (zero-test-conditions (test '(- m (* 2 :pi)))) '((= m (* 2 :pi)))))

(test-case "residues take π for a number that is algebraic in nothing, and are no proof"
  (check-eq? (fingerprint (datum->expression '(- (* 2 :pi/2) :pi))) 'zero)
  (check-eq? (fingerprint (datum->expression '(- (* 2 :pi) :2pi))) 'zero)
  (check-eq? (fingerprint (datum->expression '(+ 1 (cos :pi)))) 'nonzero?)
  (check-true (vanishes? (datum->expression '(+ 1 (cos :pi)))))
  (check-true (vanishes? (datum->expression '(sin :2pi))))
  (check-false (vanishes? ':pi)))

(test-case "π is positive, and no symbol"
  (check-equal? (symbols-in (datum->expression '(* :pi m (f :pi/2)))) '(m))
  (check-false (unknown? ':pi))
  (check-true (unknown? 'pi))
  (define-values (simple grounds)
    (simplify-expression/assumptions (datum->expression '(sqrt (* (expt :pi 2) (expt x 4))))))
  (check-equal? (expression->datum simple) '(* :pi (expt x 2)))
  (check-equal? grounds '())
  (check-exn exn:algebra:contradiction?
             (lambda () (declare-relations no-assumptions '((> :pi 22/7)))))
  (check-exn exn:algebra:contradiction?
             (lambda () (declare-relations no-assumptions '((< :2pi 6)))))
  (check-pred assumptions? (declare-relations no-assumptions '((> x :pi) (> :pi 3)))))

(test-case "the value of what holds no unknown"
  (check-equal? (constant-value ':pi) pi)
  (check-equal? (constant-value ':pi/2) (/ pi 2))
  (check-= (value '(* 2 (sqrt :pi))) (* 2 (sqrt pi)) 1e-15)
  (check-false (value '(* 2 x)))
  (check-false (value '(f :pi)))
  (check-false (value '(sqrt (- 3 :pi)))))
