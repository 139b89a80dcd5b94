#lang racket/base
;; From a path to the residual, every step in sight (SICM exercise 1.12).

(require "../generic/elementary.rkt"
         "../calculus/derivative.rkt"
         "../value/function.rkt" "../value/simplify.rkt"
         "../lagrangian/local-tuple.rkt" "../lagrangian/Lagrange-equations.rkt"
         "../display/print-expression.rkt")

(provide derivation-steps show-derivation)

;; A list of (label . value): the local tuple, the Lagrangian along the path, its
;; partial derivatives there, the time derivatives of the momenta, the force and
;; the residual; all simplified.
(define (derivation-steps equations q [t 't])
  (unless (equations? equations)
    (raise-argument-error 'derivation-steps "(Lagrange-equations L)" equations))
  (define L (equations-Lagrangian equations))
  (define n (equations-order equations))
  (define force (equations-force equations))
  (define path (Gamma q (+ n 2)))
  (define (step label f) (cons label (simplify (f t))))
  (define (partial-along k) (compose ((partial k) L) path))
  (append
   (list (step '(Gamma q) path)
         (step '(compose L (Gamma q)) (compose L path)))
   (for/list ([k (in-range 1 (+ n 2))])
     (step `(compose ((partial ,k) L) (Gamma q)) (partial-along k)))
   (for/list ([k (in-range 1 (add1 n))])
     (step `(,(if (= k 1) 'D `(expt D ,k)) (compose ((partial ,(add1 k)) L) (Gamma q)))
           ((g:expt D k) (partial-along (add1 k)))))
   (if force (list (step '(compose force (Gamma q)) (compose force path))) '())
   (list (step '((Lagrange-equations L) q) (equations q)))))

;; Prints the steps, each as `label at t`, then its value.
(define (show-derivation equations q [t 't])
  (for ([s (in-list (derivation-steps equations q t))])
    (print-labelled (list (car s) t) (cdr s))))
