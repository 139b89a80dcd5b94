#lang racket/base
;; An orbit that comes back just after half of the steps has halves that agree, however wrong
;; both are: the rotation number was given "to about 0" and was off by 2e-7.

(require mechanics "../support/checks.rkt")

;; A rotation of an ellipse, w turns each step
(define ((turning w) x y return fail)
  (define-values (c s) (values (cos (* 2 :pi w)) (sin (* 2 :pi w))))
  (return (- (* c x) (* s 5 y)) (+ (/ (* s x) 5) (* c y))))

(test-case "the number is as right as is said"
  (for* ([n '(1000 5000 10000)] [k '(1 2 3 7 100 499 1234)])
    (define w (/ k 10000.0))
    (define r (rotation-number (turning w) (up 1.0 0.2) n #:about (up 0 0)))
    (when (rotation-regular? r)
      (check-true (<= (abs (- (rotation-value r) w)) (rotation-error r)) (format "~a ~a" n k)))))

(test-case "regular orbits look so"
  (for ([w '(1e-4 0.4999 -0.3 0.1)])
    (check-true (rotation-regular? (rotation-number (turning w) (up 1.0 0.2) #:about (up 0 0))))))

(test-case "around the start itself there is no direction"
  (check-exn #rx"^rotation-number: the orbit starts at the point that it is to go around"
             (lambda () (rotation-number (turning 0.1) (up 1 2) #:about (up 1 2)))))
