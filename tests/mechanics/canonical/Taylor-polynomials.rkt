#lang racket/base
;; Taylor polynomials in two variables, against the derivatives along rays.

(require mechanics
         mechanics/calculus/derivative
         mechanics/canonical/perturbation/Taylor-polynomial
         mechanics/canonical/perturbation/complex-polynomial
         "../support/checks.rkt" "../support/close.rkt")

(define degree 6)

;; f near (a, b), of variables in which q is x + y and p is −i (x − y) by halves
(define (parts f a b)
  (define m (make-modes '(1) '((0))))
  (define series
    (Taylor-parts (f 'q 'p)
                  (list (list* 'q a (real-variable m 0)) (list* 'p b (real-variable m 1)))
                  degree
                  (lambda (part) (error 'parts "no number: ~a" part))))
  (lambda (q p) (for/list ([s series]) (polynomial->expression m s (list q p)))))

(define (along-ray f a b q p)
  (for/list ([d (derivatives-at (lambda (s) (f (+ a (* s q)) (+ b (* s p)))) 0 degree)] [k 7])
    (/ d (for/product ([i (in-range 1 (+ k 1))]) i))))

(define functions
  (list (lambda (q p) (+ 3 (* 2 q) (- p) (* q p p)))
        (lambda (q p) (/ 1 (+ 2 q (square p))))
        (lambda (q p) (sqrt (+ (square q) (square p))))
        (lambda (q p) (* (sin (+ q p)) (exp (- q))))
        (lambda (q p) (expt (+ 1 q) p))
        (lambda (q p) (expt (+ 1 (square q)) -3/2))
        (lambda (q p) (atan p q))
        (lambda (q p) (- (log q) (/ p q) (cos (* 2 p))))))

(test-case "all operations, at three places"
  (for* ([f functions] [place '((1.0 0.5) (0.3 -0.8) (2.0 1.0))] [ray '((0.3 -0.2) (0.1 0.4))])
    (check-close (apply (apply parts f place) ray) (apply along-ray f (append place ray)) 1e-10)))

(test-case "exact numbers stay exact"
  (check-equal? ((parts (lambda (q p) (cos q)) 0 0) 2 5) '(1 0 -2 0 2/3 0 -4/45))
  (check-equal? ((parts (lambda (q p) (/ 1 (- 1 q p))) 0 0) 1 1) '(1 2 4 8 16 32 64)))
