#lang racket/base
;; Normal forms with flonums for frequencies were refuted for what rounding leaves, and took a
;; minute and a half to be judged.

(require mechanics "../support/checks.rkt")

(define plane (up 't (up 'x 'y) (down 'a 'b)))

(define ((oscillators w1 w2) s)
  (define-values (x y) (values (ref s 1 0) (ref s 1 1)))
  (+ (* 1/2 w1 (+ (square x) (square (ref s 2 0))))
     (* 1/2 w2 (+ (square y) (square (ref s 2 1))))
     (* 3/10 x x y) (* -1/10 y y y)))

(define (form w1 w2 degree) (Birkhoff-normal-form (oscillators w1 w2) plane #:degree degree))

(test-case "what rounding leaves is no refutation, and no proof"
  (for ([w (list (list (sqrt 2) 1) (list 1 1.0000001) (list 0.1 0.3) (list 1.1 0.7))]
        [degree '(4 4 5 6)])
    (define v (verify-normal-form (form (car w) (cadr w) degree)))
    (check-equal? (verdict-status v) 'undecided)
    (check-true (pair? (verdict-remarks v)))))

(test-case "with exact numbers there is a proof of the same"
  (for ([w '((1 1) (11/10 7/10))] [degree '(4 5)])
    (check-equal? (verdict-status (verify-normal-form (form (car w) (cadr w) degree))) 'proved)))

;; H(C(z)) - N(z) is of the degree after the last: halved distances divide it by 2^7 or more
(test-case "the forms are right"
  (define N (form 1.1 0.7 6))
  (define H (oscillators 1.1 0.7))
  (define C (normal-form-transformation N))
  (define (off r)
    (define z (up 0 (up (* 0.6 r) (* -0.3 r)) (down (* 0.5 r) (* 0.7 r))))
    (- (H (C z))
       (for/sum ([k 5]) ((series:ref (normal-form-Hamiltonian N) k) z))))
  (check-true (> (/ (off 0.2) (off 0.1)) 110)))
