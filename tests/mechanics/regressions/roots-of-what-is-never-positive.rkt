#lang racket/base
;; (sqrt (- (square 'x))) was (* +i x) without an assumption: the root was asked about where it
;; has a real value, at x = 0, and there x is not negative.

(require mechanics "../support/checks.rkt" "../support/session.rkt")

(define-check (check-root radicand expected)
  (define-values (shown assumed)
    (let ([x (simplify (sqrt radicand))]) (values (expression x) (assumptions 'used))))
  (unless (and (equal? shown expected) (null? assumed))
    (with-check-info (['shown shown] ['assumed assumed]) (fail-check))))

(test-case "it has the sign of no unknown"
  (check-root (- (square 'x)) '(* 0+1i (abs x)))
  (check-root (* -4 (square 'x)) '(* 0+2i (abs x)))
  (check-root (- (square (- 'x 'y))) '(* 0+1i (abs (- x y))))
  (check-root (- (square (sin 'x))) '(* 0+1i (abs (sin x)))))

(test-case "with a sign declared it is that of the other side, too"
  (check-prints (assuming ('(< x 0)) (sqrt (- (square 'x)))) '(* 0-1i x))
  (check-prints (assuming ('(> x 0)) (sqrt (- (square 'x)))) '(* 0+1i x)))
