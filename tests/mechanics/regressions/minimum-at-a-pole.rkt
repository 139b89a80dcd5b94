#lang racket/base
;; Minima "found" at poles, where a function falls without bound: 1/x gave −1e10 without a word.

(require mechanics
         mechanics/scmutils
         "../support/checks.rkt" "../support/close.rkt")

(define poles
  (list (lambda (x) (/ 1 x))
        (lambda (x) (/ -1 (abs (- x 0.3))))
        (lambda (x) (/ -1 (sqrt (abs (- x 0.3)))))
        (lambda (x) (log (abs (- x 0.3))))
        (lambda (x) (+ 5 (/ -1e-3 (square (+ x 0.25)))))))

(test-case "they are told, by each search between two numbers"
  (for* ([f poles] [search (list minimize brent-min golden-section-min find-minimum)])
    (check-exn #rx"no minimum found: the function falls without bound, at a pole"
               (lambda () (search f -1.0 1.0)))))

(test-case "minima that are sharp, narrow or high up are none"
  (for ([f (list (lambda (x) (abs (- x 0.3)))
                 (lambda (x) (sqrt (abs (- x 0.3))))
                 (lambda (x) (expt (abs (- x 0.3)) 1/10))
                 (lambda (x) (+ 1e10 (square (- x 0.3))))
                 (lambda (x) (/ -1 (+ 1e-6 (square (- x 0.3)))))
                 (lambda (x) (* 1e12 (square (- x 0.3))))
                 (lambda (x) (expt (- x 0.3) 4))
                 (lambda (x) (if (< x 0.3) (- 1 x) x)))])
    (check-close (car (minimize f -1.0 1.0)) 0.3 2e-2)))

(test-case "of all minima, poles are left out"
  (define all (minima (lambda (x) (+ (square (- x 2)) (/ -1e-3 (square (+ x 0.25)))))
                      -1.0 3.0))
  (check-equal? (length all) 1)
  (check-close (minimum-argument (car all)) 2 1e-3))
