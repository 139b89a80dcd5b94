#lang racket/base
;; Angles brought back to one turn.

(require (prefix-in m: mechanics)
         mechanics/numeric/constants
         mechanics/value/principal-value
         "../support/checks.rkt" "../support/random.rkt")

(test-case "an angle within the turn stays exactly as it is; the cut itself belongs to the next"
  (define principal (principal-value :pi))
  (for ([x (list 0 1 -3 :-pi 3.141592653589793e-300 (- :pi 1e-15))])
    (check-equal? (principal x) x))
  (check-equal? (principal :pi) :-pi)
  (check-equal? ((principal-value :2pi) 0) 0)
  (check-equal? ((principal-value :2pi) :2pi) 0.0))

(test-case "the value is in [cut - 2π, cut) and differs from the angle by whole turns"
  (for ([seed (in-range 300)])
    (with-seed seed
      (define cut (* 40 (- (random) 0.5)))
      (define x (* 1e4 (- (random) 0.5)))
      (define y ((principal-value cut) x))
      (define turns (/ (- x y) :2pi))
      (check-true (and (<= (- cut :2pi) y) (< y cut)))
      (check-= turns (round turns) 1e-11))))

(test-case "rounding does not lead out of the turn"
  (for ([x (list -1e-300 -1e-17 (- -1e-15 :2pi) 1e15 -1e15)])
    (define y ((principal-value :2pi) x))
    (check-true (and (<= 0 y) (< y :2pi)) (format "~a" x))))

(test-case "tuples of angles; derivatives; printing"
  (check-equal? ((principal-value :pi) (m:up 4 (m:up -4 0)))
                (m:up (- 4 :2pi) (m:up (+ -4 :2pi) 0)))
  (for ([x (list 4 :pi (- :pi))]) (check-equal? ((m:D (principal-value :pi)) x) 1))
  (check-= ((m:D (m:compose m:square (principal-value :pi))) 4) (* 2 (- 4 :2pi)) 1e-14)
  (check-equal? (format "~a" (principal-value 3)) "(principal-value 3)"))

(test-case "what is no angle is said to be none"
  (check-exn #rx"principal-value: expected a cut that is a real number\n  given: the symbol c"
             (lambda () (principal-value 'c)))
  (check-exn #rx"principal-value: expected an angle that is a real number\n  given: the symbol q"
             (lambda () ((principal-value :pi) 'q))))
