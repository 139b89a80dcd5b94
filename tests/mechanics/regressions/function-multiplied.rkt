#lang racket/base
;; (* 'A cos 'omega t) is a product of functions, and whoever wanted a number of it spoke of
;; derivatives and parameters.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt")

(define (L (up t q v)) (- (* 1/2 'm (square v)) (* 1/2 'k (square q))))

;; The end of the message.
(define-syntax-rule (ends [expression text] ...)
  (begin
    (test-case (format "~s" 'expression)
      (define said (message-of expression))
      (check-true (regexp-match? (string-append (regexp-quote text) "$") said) said))
    ...))

(ends
 [(verify-solution L (lambda (t) (* 'A cos (* 'omega t))))
  "\n  cos is a factor there; to apply it, write (cos (* omega t))"]
 [(((Lagrange-equations L) (lambda (t) (* 'A sin 'phi))) 't)
  "\n  sin is a factor there; to apply it, write (sin 'phi)"]
 [(Lagrangian-action L (lambda (t) (* 2 cos t)) 0 1)
  "\n  cos is a factor there; to apply it, write (cos 5/13)"]
 [((Lagrangian->energy (lambda (s) (* 'm (coordinate s) cos))) (up 't 'x 'v))
  "\n  cos is a factor there; to apply it, write (cos ...)"]
 [(definite-integral (lambda (x) (* 2 exp x)) 0 1)
  "\n  exp is a factor there; to apply it, write (exp 0.5)"]
 [(find-root (lambda (x) (- (* cos x) 1)) 0)
  "\n  cos is a factor there; to apply it, write (cos 0.0)"]
 ;; Another function is not known to have been meant so.
 [((Lagrangian->energy (lambda (s) (* 'm (literal-function 'V)))) (up 't 'x 'v))
  "\n  was a parameter left out, as the mass in (L-free-particle 'm)?"])
