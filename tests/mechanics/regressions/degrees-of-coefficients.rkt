#lang racket/base
;; Degrees of quantities that are polynomials in the time, as ωt, were flonums, 1.0, and were
;; compared as if they were indices: their rows never ended, and cos ωt cost as much as the cosine
;; of an unknown.

(require mechanics/compile/jet/jet-degrees mechanics/compile/jet/jet-graph mechanics/compile/trace
         (only-in mechanics/compile/program program-inputs)
         (only-in mechanics cos evolve-trajectory ref sin square up)
         (prefix-in g: (only-in mechanics + - * /))
         "../support/checks.rkt")

(define (degrees-of f state)
  (define-values (p _) (trace 'test f state))
  (define g (program->graph p (program-inputs p)))
  (vector->list (node-degrees g (graph-outputs g))))

(define (driven s) (up 1 (ref s 2) (g:* (cos (g:* 6.0 (ref s 0))) (sin (ref s 1)))))

(test-case "degrees are exact, or infinite"
  (define degrees (degrees-of driven (up 0.0 1.0 0.0)))
  (for ([d (in-list degrees)]) (check-true (or (eqv? d +inf.0) (exact-nonnegative-integer? d))))
  (check-not-false (memv 1 degrees)))

;; x' = f(t, x) from x(0) = 1 -> x(2)
(define (solution f method)
  (define tr
    (evolve-trajectory (lambda (s) (up 1 (f (ref s 0) (ref s 1)))) (up 0.0 1.0) 2
                       #:tolerance 1e-13 #:method method))
  (ref (tr 2) 1))

(test-case "products, quotients and functions of polynomials in the time"
  (for ([f (list (lambda (t x) (g:* t x))
                 (lambda (t x) (g:* (square t) x))
                 (lambda (t x) (g:* (g:- (square t) (g:* 3 t)) x))
                 (lambda (t x) (g:/ x (g:+ 1 t)))
                 (lambda (t x) (g:/ x (g:+ 1 (square t))))
                 (lambda (t x) (g:* (cos (g:* 3 t)) x)))]
        [x (list (exp 2.0) (exp 8/3) (exp (- 8/3 6)) 3.0 (exp (atan 2.0))
                 (exp (/ (sin 6.0) 3)))])
    (check-= (/ (solution f 'Taylor) x) 1.0 1e-12))
  (define (f t x) (g:* (sin (square t)) (square t)))
  (check-= (solution f 'Taylor) (solution f 'Dormand-Prince-853) 1e-11))
