#lang racket/base
;; The steps from a path to the residual: their labels, their values, and what is
;; said when there is nothing to derive.

(require mechanics rackunit)

(define x (literal-function 'x))
(define (L (up t q v)) (- (* 1/2 'm (square v)) (* 1/2 'k (square q))))
(define (L-acceleration (up t q v a)) (* 1/2 'm (square a)))

(define-check (check-step steps label value)
  (define found (assoc label steps))
  (unless (and found (equal? (expression (cdr found)) value))
    (with-check-info (['label label] ['found (and found (expression (cdr found)))])
      (fail-check))))

(test-case "every step of a first-order Lagrangian has its label and simplified value"
  (define steps (derivation-steps (Lagrange-equations L) x))
  (check-equal? (length steps) 6)
  (check-step steps '(Gamma q) '(up t (x t) ((D x) t)))
  (check-step steps '(compose ((partial 1) L) (Gamma q)) '(* -1 k (x t)))
  (check-step steps '(compose ((partial 2) L) (Gamma q)) '(* m ((D x) t)))
  (check-step steps '(D (compose ((partial 2) L) (Gamma q))) '(* m (((expt D 2) x) t)))
  (check-step steps '((Lagrange-equations L) q)
              '(+ (* k (x t)) (* m (((expt D 2) x) t)))))

(test-case "a Lagrangian of higher order wants longer local tuples, and the labels say so"
  (define steps (derivation-steps (Lagrange-equations L-acceleration #:order 2) x))
  (check-step steps '(Gamma q 4) '(up t (x t) ((D x) t) (((expt D 2) x) t)))
  (check-step steps '((expt D 2) (compose ((partial 3) L) (Gamma q 4)))
              '(* m (((expt D 4) x) t))))

(test-case "a force is a step of its own"
  (define (drag local) (* -1 'b (velocity local)))
  (define steps (derivation-steps (Lagrange-equations L #:force drag) x))
  (check-step steps '(compose force (Gamma q)) '(* -1 b ((D x) t))))

(test-case "the steps may be taken at another time"
  (check-step (derivation-steps (Lagrange-equations L) x 0) '(Gamma q) '(up 0 (x 0) ((D x) 0))))

(define (shown show)
  (define port (open-output-string))
  (parameterize ([current-output-port port])
    (show))
  (get-output-string port))

(test-case "the steps are shown one below the other, then what they assumed, once"
  (define (L-distance (up t (up x y) v)) (* -1 (sqrt (square x))))
  (define text
    (shown (lambda ()
             (show-derivation (Lagrange-equations L-distance) (up x (literal-function 'y))))))
  (check-regexp-match #rx"^\\(\\(Gamma q\\) t\\)\n  \\(up t \\(up \\(x t\\) \\(y t\\)\\)" text)
  (check-regexp-match #rx"\n\\(\\(\\(Lagrange-equations L\\) q\\) t\\)\n  \\(down 1 0\\)\n; assuming" text)
  (check-equal? (length (regexp-match* #rx"assuming \\(>= \\(x t\\) 0\\)\n" text)) 1))

(test-case "mistakes are reported in the name of what was called"
  (for ([derive (in-list (list derivation-steps show-derivation))]
        [name (in-list '("derivation-steps" "show-derivation"))])
    (check-exn (pregexp (string-append "^" name ": contract violation\n  expected: .Lagrange-equations L."))
               (lambda () (derive L x)))
    (check-exn (pregexp (string-append "^" name ": a path is a function of time"))
               (lambda () (derive (Lagrange-equations L) 'x)))))
