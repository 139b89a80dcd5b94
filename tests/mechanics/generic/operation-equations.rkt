#lang racket/base
;; The equations of operations as truncated Taylor numbers read them: derivatives of
;; all orders, compared with those by nested rules in exact or symbolic form.

(require (prefix-in m: mechanics) "../support/checks.rkt")

;; The k-th coefficient of the series of f about x, and the k-th derivative of the expression
;; of f at a symbol, evaluated there.
(define (check-series name f x)
  (define s ((m:Taylor-series f) x))
  (for/fold ([derivative f]) ([k (in-range 6)])
    (check-= (m:series:ref s k)
             (/ (derivative x) (for/product ([j (in-range 1 (+ k 1))]) j))
             (* 1e-11 (expt 4 k))
             (format "~a, order ~a" name k))
    (m:D derivative)))

(for ([name '(sqrt exp log sin cos tan asin acos atan sinh cosh tanh asinh atanh erf)]
      [f (list m:sqrt m:exp m:log m:sin m:cos m:tan m:asin m:acos m:atan m:sinh m:cosh m:tanh
               m:asinh m:atanh m:erf)])
  (test-case (format "~a" name)
    (check-series name f 0.4)
    (check-series name (lambda (x) (f (m:* 0.3 (m:exp x)))) 0.4)))

(test-case "acosh" (check-series 'acosh m:acosh 1.7))

(test-case "coefficients that are known exactly"
  (define (coefficients f x n)
    (define s ((m:Taylor-series f) x))
    (for/list ([k (in-range n)]) (m:series:ref s k)))
  (check-equal? (coefficients m:tan 0 8) '(0 1 0 1/3 0 2/15 0 17/315))
  (check-equal? (coefficients m:atan 0 8) '(0 1 0 -1/3 0 1/5 0 -1/7))
  (check-equal? (coefficients m:asin 0 8) '(0 1 0 1/6 0 3/40 0 5/112))
  (check-equal? (coefficients m:tanh 0 8) '(0 1 0 -1/3 0 2/15 0 -17/315)))
