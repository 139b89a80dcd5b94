#lang racket/base
;; SICM 3.9, The Standard Map (pp. 277-281).

(require mechanics
         mechanics/book
         "../support/checks.rkt" "../support/close.rkt")

(define (fail) 'no-image)
(define (after n K) ((iterated-map (standard-map K) n) 1 1 list fail))

(test-case "p. 278: from (1, 1), once and ten times"
  (check-close (after 1 0.6) '(2.50488259088474 1.50488259088474) 1e-14)
  (check-close (after 10 0.6) '(2.02201816481268 1.33373402711283) 2e-14)
  (check-close (after 1 1.4) '(3.17805937873106 2.17805937873106) 1e-14)
  (check-close (after 10 1.4) '(5.41581380396213 1.7744615690744) 2e-13))

(test-case "there and back"
  (for* ([K '(0.6 1.4)] [x '(0.1 3 6)] [y '(0.2 2 5)])
    (check-close ((standard-map K) x y
                  (lambda (x y) ((standard-map-inverse K) x y list fail)) fail)
                 (list x y) 1e-14)
    (check-close ((Henon-map K) x y
                  (lambda (x y) ((Henon-map-inverse K) x y list fail)) fail)
                 (list x y) 1e-12)))

(define (multipliers T x y) (fixed-point-eigen T x y 1e-10 (lambda (a dx dy b ex ey) (list a b))))

(test-case "multipliers at (0, 0), and the angle of rotation at (pi, 0)"
  (for ([K '(0.6 1.4)]
        [expected '((2.13066238629181 .469337613708193) (3.07477270848675 .325227291513248))]
        [angle '(.795398830184 1.26610367278)])
    (check-close (multipliers (standard-map K) 0 0) expected 1e-14)
    (define complex (car (multipliers (standard-map K) :pi 0)))
    (check-close (list (magnitude complex) (abs (atan (imag-part complex) (real-part complex))))
                 (list 1 angle) 1e-11)))

(test-case "both maps keep areas: a proof"
  (define ((image T) p) (T (ref p 0) (ref p 1) up fail))
  (define (area T)
    (define slopes ((D (image T)) (up 'x 'y)))
    (- (* (ref slopes 0 0) (ref slopes 1 1)) (* (ref slopes 0 1) (ref slopes 1 0))))
  (define ((kick K) x y return fail) (return (+ x y (* K (sin x))) (+ y (* K (sin x)))))
  (check-true (proved? (verify-equal (area (kick 'K)) 1)))
  (check-true (proved? (verify-equal (area (Henon-map 'alpha)) 1))))

(test-case "Hénon's map has the origin at rest, turned by alpha"
  (for ([alpha '(1.2 1.32)])
    (check-equal? ((Henon-map alpha) 0 0 list fail) '(0 0))
    (define complex (car (multipliers (Henon-map alpha) 0 0)))
    (check-close (atan (imag-part complex) (real-part complex)) alpha 1e-13)))
