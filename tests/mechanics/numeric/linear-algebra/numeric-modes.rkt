#lang racket/base
;; Modes whose frequencies differ by many orders of magnitude: the slow ones were 0.

(require (only-in racket/math conjugate)
         mechanics/numeric/linear-algebra/numeric-modes
         mechanics/numeric/linear-algebra/row-matrix
         "../../support/checks.rkt")

(define (rows . lists) (list->vector (map list->vector lists)))
(define I (unit-rows 2 1.0 0.0))
(define (turning g) (rows (list 0.0 g) (list (- g) 0.0)))

(define (check-frequencies modes . expected)
  (check-equal? (length modes) (length expected))
  (for ([mode (in-list modes)] [omega (in-list expected)])
    (check-true (<= (magnitude (- (car mode) omega)) (* 1e-14 omega)) (format "~a ~a" mode omega))))

(test-case "1 and 10⁹, coupled or not"
  (check-frequencies (symmetric-modes I (rows '(1.0 0.0) '(0.0 1e18))) 1.0 1e9)
  (check-frequencies (symmetric-modes I (rows '(3.0 -1e9) '(-1e9 1e18))) (sqrt 2.0) 1e9)
  (check-frequencies (symmetric-modes (rows '(1.0 0.0) '(0.0 1e-18)) (rows '(2.0 -1.0) '(-1.0 2.0)))
                     (sqrt 1.5) (sqrt 2e18)))

(test-case "a drift beside a fast turning, and what turning leaves alone"
  (check-frequencies (gyroscopic-modes I I (turning 1e10)) 1e-10 1e10)
  (check-frequencies (gyroscopic-modes I (rows '(1.0 0.0) '(0.0 1e18)) (turning 1e-3)) 1.0 1e9))

(test-case "frequencies 0 are 0"
  (define chain (rows '(1.0 -1.0 0.0) '(-1.0 2.0 -1.0) '(0.0 -1.0 1.0)))
  (for ([stiff '(1.0 1e-20 1e18)])
    (define K (rows-map (lambda (k) (* stiff k)) chain))
    (check-equal? (car (car (symmetric-modes (unit-rows 3 1.0 0.0) K))) 0.0))
  (check-frequencies (gyroscopic-modes I (rows '(0.0 0.0) '(0.0 0.0)) (turning 2.0)) 0.0 2.0)
  (check-equal? (car (car (gyroscopic-modes I (rows '(1.0 -1.0) '(-1.0 1.0)) (turning 1e3)))) 0.0))

;; Two turning particles, in frames of their own: 2 and 1/2 are frequencies of both, ω² ± 3ω/2 = 1.
(test-case "of two modes with one frequency the shapes are two"
  (define unit (unit-rows 4 1.0 0.0))
  (define G (rows '(0.0 1.5 0.0 0.0) '(-1.5 0.0 0.0 0.0) '(0.0 0.0 0.0 1.5) '(0.0 0.0 -1.5 0.0)))
  (define modes (gyroscopic-modes unit unit G))
  (check-frequencies modes 0.5 0.5 2.0 2.0)
  (define (product u v) (for/sum ([x (in-list u)] [y (in-list v)]) (* x (conjugate y))))
  (define (check-independent u v)
    (check-true (> (magnitude (- (* (product u u) (product v v)) (* (product u v) (product v u))))
                   0.1)
                (format "~a ~a" u v)))
  (define shapes (map cdr modes))
  (check-independent (car shapes) (cadr shapes))
  (check-independent (caddr shapes) (cadddr shapes)))
