#lang racket/base
;; A claim false between two kinks only, on one side of 0, or just within an assumed bound, was
;; "zero at 12 points".

(require mechanics
         (only-in "../support/systems.rkt" L-on-a-line)
         "../support/checks.rkt")

(define x 'x)
(define (square-less-1 x) (- (square x) 1))
(define (check-refuted a b) (check-pred refuted? (verify-equal a b)))

(test-case "between kinks"
  (check-refuted (abs (square-less-1 x)) (square-less-1 x))
  (check-refuted (abs (+ (square x) (* -3 x) 2)) (+ (square x) (* -3 x) 2))
  (check-refuted (abs (* (- x 7/5) (- x 3/2))) (* (- x 7/5) (- x 3/2)))
  (check-refuted (abs (* (- x 97/10) (- x 98/10))) (* (- x 97/10) (- x 98/10))))

(test-case "beyond a kink that is far away"
  (check-refuted (abs (- x 1000000)) (- 1000000 x))
  (check-refuted (abs (- x 123456789)) (- 123456789 x)))

(test-case "near an assumed bound"
  (assuming ('(> x 0))
    (check-refuted (abs (- x 1)) (- x 1))
    (check-refuted (abs (- x 1/2)) (- x 1/2))
    (check-refuted (abs (log x)) (log x))
    (check-refuted (abs (- (exp x) 2)) (- (exp x) 2)))
  (assuming ('(> x -1)) (check-refuted (abs x) x))
  (assuming ('(< x 3)) (check-refuted (abs (- x 5/2)) (- 5/2 x)))
  (assuming ('(> (+ x y) 0)) (check-refuted (abs (+ x 'y)) (+ (abs x) (abs 'y)))))

(test-case "for negative numbers"
  (check-refuted (acos x) (asin (sqrt (- 1 (square x)))))
  (check-refuted (asin x) (acos (sqrt (- 1 (square x)))))
  (check-refuted (acos x) (atan (/ (sqrt (- 1 (square x))) x)))
  (check-refuted (expt (square x) 'n) (expt x (* 2 'n))))

(test-case "a motion that is none for a negative spring"
  (define (V x) (* 1/2 'k (square x)))
  (check-pred refuted?
              (verify-solution (L-on-a-line 'm V)
                               (lambda (t) (* 'A (cos (* (sqrt (abs (/ 'k 'm))) t)))))))

(test-case "what is true there stays so"
  (assuming ('(> x 1))
    (check-pred proved? (verify-equal (abs (square-less-1 x)) (square-less-1 x))))
  (check-false (refuted? (verify-equal (abs (+ (square x) (* -1 x) 1)) (+ (square x) (* -1 x) 1)))))
