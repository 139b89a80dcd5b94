#lang racket/base
;; A residual with flonums was shown as -3.55e-15 l m times a core of whole numbers of
;; 15 digits, what is left of flonums that are written as fractions.  The numbers of
;; the core are those of the residual.

(require mechanics
         (only-in mechanics/book L-harmonic L-pendulum)
         "../support/checks.rkt")

(define (factored v) (car (verdict-factored v)))

;; Every number that is written in e.
(define (numbers e)
  (cond [(number? e) (list e)]
        [(list? e) (apply append (map numbers e))]
        [else '()]))

(test-case "the pendulum with g = 9.8"
  (define f (factored (verify-solution (L-pendulum 9.8 'm 'l) (lambda (t) (* 'a (cos t))))))
  (check-equal? (expression (car f)) '(* -1 l m))
  (check-equal? (expression (cdr f)) '(- (* a l (cos t)) (* 9.8 (sin (* a (cos t)))))))

(test-case "factor times core is the residual, with numbers of its size"
  (for ([L (list (L-harmonic 'm 2.5) (L-harmonic 2.5 'k) (L-harmonic 'm 'k)
                 (L-pendulum 9.81 0.3 'l))])
    (define v (verify-solution L (lambda (t) (* 'a (cos (* 3.1 t))))))
    (define f (factored v))
    (define (at e) (substitute e 'a 1.3 'm 0.7 'k 2.9 'l 0.6 't 0.4))
    (check-= (at (* (car f) (cdr f))) (at (verdict-residual v)) 1e-9)
    (for ([x (append (numbers (expression (car f))) (numbers (expression (cdr f))))])
      (check-true (<= 1e-3 (magnitude x) 1e3) (format "~a in ~a" x f)))))
