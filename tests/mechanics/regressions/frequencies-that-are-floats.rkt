#lang racket/base
;; Angles in no simple ratio, such as 2.1 t and 2.2 t, once were written as
;; multiples, by millions of millions, of a common one.

(require mechanics "../support/checks.rkt")

(test-case "sines and cosines of float multiples stay as they are"
  (check-equal? (expression (simplify (+ (cos (* 2.1 't)) (cos (* 2.2 't)))))
                '(+ (cos (* 2.1 t)) (cos (* 2.2 t))))
  (check-equal? (expression (simplify (* (cos (* 60 't)) (sin 't))))
                '(* (cos (* 60 t)) (sin t))))

(test-case "simple ratios are still related, beside others"
  (check-eq? (verdict-status
              (verify-equal (+ (sin (* 2.1 't)) (sin (* 2 't)))
                            (+ (sin (* 2.1 't)) (* 2 (sin 't) (cos 't)))))
             'proved)
  (check-eq? (verdict-status
              (verify-equal (+ (cos (* 60 't)) (sin (* 2 't)))
                            (+ (cos (* 60 't)) (* 2 (sin 't) (cos 't)))))
             'proved))

(test-case "normal modes with a float frequency are proved, the float being read as a root"
  (define ((L-coupled m k) (up t (up x y) (up vx vy)))
    (- (* 1/2 m (+ (square vx) (square vy)))
       (* 1/2 k (+ (square x) (square y) (square (- x y))))))
  (define (modes t)
    (let ([slow (* 'a (cos t))] [fast (* 'b (cos (* (sqrt 3) t)))])
      (up (+ slow fast) (- slow fast))))
  (check-eq? (verdict-status (verify-solution (L-coupled 1 1) modes)) 'proved))

(test-case "exponents in no simple ratio give a verdict"
  (check-eq? (verdict-status
              (verify-equal (exp (* (exp 2) (sqrt 3) (+ 'x 1)))
                            (exp (* (exp 2) 2 (+ 'x 1)))))
             'refuted))
