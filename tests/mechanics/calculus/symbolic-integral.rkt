#lang racket/base
;; Definite integrals as formulas: against closed forms, and against numbers.

(require rackunit
         mechanics)

(define-check (check-integral f low high expected)
  (define found (definite-integral f low high))
  (unless (proved? (prove-zero (- found expected)))
    (with-check-info (['found found]) (fail-check))))

(test-case "polynomials, waves, exponentials and products of them, between symbols"
  (check-integral (lambda (x) (expt x 3)) 'a 'b (* 1/4 (- (expt 'b 4) (expt 'a 4))))
  (check-integral (lambda (x) (* 'k x)) 0 1 (* 1/2 'k))
  (check-integral (lambda (x) (cos (* 'w x))) 0 'T (/ (sin (* 'w 'T)) 'w))
  (check-integral (lambda (x) (* x (exp (* -1 'k x)))) 0 'T
                  (/ (- 1 (* (exp (* -1 'k 'T)) (+ 1 (* 'k 'T)))) (square 'k)))
  (check-integral (lambda (x) (* (exp x) (sin x))) 0 'b
                  (* 1/2 (+ 1 (* (exp 'b) (- (sin 'b) (cos 'b))))))
  (check-integral (lambda (x) 'c) 'a 'b (* 'c (- 'b 'a)))
  (check-integral (lambda (x) 1) 'a 'b (- 'b 'a)))

(test-case "formulas agree with numbers"
  (for ([f (list (lambda (x k) (* (square x) (sin (* k x))))
                 (lambda (x k) (* (exp (* k x)) (square (cos x))))
                 (lambda (x k) (/ 1 (expt (+ x k) 2))))])
    (define formula (definite-integral (lambda (x) (f x 'k)) 'a 'b))
    (define value (substitute (substitute (substitute formula 'k 0.7) 'a 0.2) 'b 1.3))
    (check-= value (definite-integral (lambda (x) (f x 0.7)) 0.2 1.3) 1e-9)))

(test-case "the action of the free particle is m (q2 - q1)^2 / (2 (t2 - t1))"
  (define ((L-free m) (up t q v)) (* 1/2 m (square v)))
  (define (line t) (+ 'q1 (* (/ (- 'q2 'q1) (- 't2 't1)) (- t 't1))))
  (check-pred proved?
              (prove-zero (- (Lagrangian-action (L-free 'm) line 't1 't2)
                             (/ (* 'm (square (- 'q2 'q1))) (* 2 (- 't2 't1)))))))

(test-case "what has no formula is refused, and says so"
  (check-exn #rx"^definite-integral: no formula was found for the integral of "
             (lambda () (definite-integral (lambda (x) (exp (* 'k (square x)))) 0 'b)))
  (check-exn #rx"^definite-integral: an integral with symbols goes from one expression to another"
             (lambda () (definite-integral (lambda (x) (exp (* -1 'k x))) 0 +inf.0))))

(test-case "a formula can be differentiated, and comes with the bound 0"
  (define (F b) (definite-integral (lambda (x) (* 'k (sin x))) 0 b))
  (check-pred proved? (prove-zero (- ((D F) 'b) (* 'k (sin 'b)))))
  (check-pred proved? (prove-zero (- (((square D) F) 'b) (* 'k (cos 'b)))))
  (check-equal? (definite-integral (lambda (x) x) 0 'a #:report (lambda (v bound n) bound)) 0))
