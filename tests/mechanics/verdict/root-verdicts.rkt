#lang mechanics
;; Verdicts on numbers made of roots, as they are read from what was typed, and as values.

(require (except-in "../support/checks.rkt" check) "../support/root-pairs.rkt")

(define (status a b) (verdict-status (verify-equal a b)))
(define (read-status pair)
  (status (read-expression (car pair)) (read-expression (cadr pair))))

(test-case "what is equal is proved, also as it is read"
  (for ([pair (in-list equal-pairs)])
    (check-eq? (read-status pair) 'proved (format "~s" pair))))

(test-case "what lies beside it is refuted"
  (for ([pair (in-list false-neighbours)] [k (in-naturals)] #:when (zero? (modulo k 3)))
    (check-eq? (read-status pair) 'refuted (format "~s" pair))))

(test-case "values, with a decimal beside them and with symbols"
  (check-eq? (status (sqrt 12) (* 2 (sqrt 3))) 'proved)
  (check-eq? (status (sqrt 12) (* 3 (sqrt 2))) 'refuted)
  (check-eq? (status (sqrt 2) 1.4142135623730951) 'undecided)
  (check-eq? (status (* 'x (sqrt 2)) (* 1.4142135623730951 'x)) 'proved)
  (check-eq? (status (sqrt 2) 1.41421356) 'refuted)
  (check-eq? (status (up (sqrt 12) (* 'x (sqrt 8))) (up (* 2 (sqrt 3)) (* 2 'x (sqrt 2)))) 'proved)
  (check-eq? (verdict-status (prove-zero (sqrt 2))) 'refuted))

(test-case "normal modes typed by hand"
  (define ((L m k) (up t (up x y) (up vx vy)))
    (- (* 1/2 m (+ (square vx) (square vy))) (* 1/2 k (+ (square x) (square (- x y))))))
  (define (mode omega ratio)
    (verdict-status (verify-solution (L 1 1) (lambda (t) (up (cos (* omega t))
                                                             (* ratio (cos (* omega t))))))))
  (check-eq? (mode (/ (- (sqrt 5) 1) 2) (/ (+ 1 (sqrt 5)) 2)) 'proved)
  (check-eq? (mode (sqrt (/ (+ 3 (sqrt 5)) 2)) (/ (- 1 (sqrt 5)) 2)) 'proved)
  (check-eq? (mode (sqrt 3) 1) 'refuted))
