#lang racket/base
;; Where a function passes from a sign to the other, and whether its Taylor polynomial can tell.

(require racket/flonum
         racket/math
         mechanics/motion/event/certain-zeros
         mechanics/motion/event/sign-change
         "../../support/checks.rkt")

(test-case "a crossing goes from a sign to the other, or to zero, in the direction asked for"
  (for* ([ga '(-2 -0.5 0 0.5 2)] [gb '(-2 -0.5 0 0.5 2)] [direction '(rising falling either)])
    (define rises? (and (< ga 0) (>= gb 0)))
    (define falls? (and (> ga 0) (<= gb 0)))
    (check-equal? (crosses? ga gb direction)
                  (case direction [(rising) rises?] [(falling) falls?] [else (or rises? falls?)]))))

(define (zero g from to) (zero-between g from (g from) to (g to)))

(test-case "the place of a zero, also between places as far on either side of 0"
  (check-= (zero cos 1.0 2.0) (/ pi 2) 1e-15)
  (check-= (zero (lambda (x) (- x 0.3)) -1.0 1.0) 0.3 1e-15)
  (check-= (zero (lambda (x) (- 0.3 x)) -1.0 1.0) 0.3 1e-15)
  (check-= (zero (lambda (x) (- (* x x x) 0.001)) -1.0 1.0) 0.1 1e-14)
  (check-false (zero (lambda (x) (/ 1 (- x 0.3))) -1.0 1.0)))

(test-case "it is found by a few values of the function"
  (for ([f (list cos (lambda (x) (- (exp x) 4)) (lambda (x) (- (* x x x) 2)))])
    (define count 0)
    (zero (lambda (x) (set! count (+ count 1)) (f x)) 1.0 2.0)
    (check-true (< count 20))))

(test-case "of a stretch of zeros the first place; a zero at the end is there"
  (for ([sign '(1 -1)])
    (define (flat x) (* sign (min 0.0 (- x 0.5))))
    (check-= (zero flat 0.0 1.0) 0.5 1e-12)
    (check-= (zero (lambda (x) (flat (- 1.0 x))) 1.0 0.0) 0.5 1e-12)
    (check-equal? (zero (lambda (x) (* sign (- x 1.0))) 0.0 1.0) 1.0)))

(define (polynomial . c) (apply flvector (map real->double-flonum c)))
(define (certain? c [uncertainty 0.0]) (tells-zeros? c 1e-10 (lambda () uncertainty)))

(test-case "a polynomial tells zeros where its last two terms are small, whatever their signs"
  (check-true (certain? (polynomial 1 0.5 0.1 1e-12 1e-13)))
  (check-true (certain? (polynomial -1 0.5 0.1 -1e-12 1e-13)))
  (for* ([a '(1 -1)] [b '(1 -1)])
    (check-false (certain? (polynomial 3 0.5 0.1 (* 0.4 a) (* 0.4 b))))
    (define c (polynomial 3 0.5 0.1 (* 1e-3 a) (* 1e-3 b)))
    (check-false (certain? c 1e-3))
    (check-true (certain? c 0.1))))

;; Two of twenty that are alike have a tenth.
(test-case "the last two terms have less than a twentieth of what varies"
  (check-false (tells-zeros? (polynomial 3 1 0.03 0.04) 1.0 (lambda () 0.0)))
  (check-true (tells-zeros? (polynomial 3 1 0.02 0.02) 1.0 (lambda () 0.0))))

;; n terms of e^(kx)
(define (exponential k n)
  (for/fold ([c '(1.0)] #:result (apply polynomial (reverse c))) ([j (in-range 1 n)])
    (cons (/ (* k (car c)) j) c)))

(test-case "and where the function is more than the rounding of its terms, as e^-7 and not e^-20"
  (check-true (certain? (exponential -7 50)))
  (check-false (certain? (exponential -20 90)))
  (check-true (certain? (polynomial 1 1e-12 0 0))))

(test-case "sums of sizes, scaled terms, and places for a radius of convergence"
  (check-equal? (total (polynomial 1 -2 3)) 6.0)
  (check-equal? (total (polynomial 1 -2 3) 1) 5.0)
  (check-equal? (scaled (polynomial 1 2 3 4) 2 0.5) (flvector 1.0 1.0 0.75))
  (check-equal? (scaled (polynomial 1 0) 1 +inf.0) (flvector 1.0 0.0))
  ;; six for each, of which there are two
  (for ([sign '(1 -1)])
    (check-equal? (places-for (polynomial sign 0 0 0 0 0 0 0 0 0 1024)) 12)
    (check-equal? (places-for (polynomial sign 0 0 0 0 0 0 0 0 512 0)) 12))
  (check-equal? (places-for (polynomial 1 0.5 0.25)) usual-places))
