#lang racket/base
;; Paths made to measure: through given points, or varied between fixed ends
;; (SICM 1.4, pp. 18–21).

(require racket/list
         "action.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/define-plain.rkt" "../generic/describe.rkt"
         "../generic/function.rkt" "../generic/printed-function.rkt"
         "../generic/sums-and-products.rkt"
         "../generic/wrong-argument.rkt")

(provide make-path make-eta parametric-path-action
         linear-interpolants Lagrange-interpolation-function)

;; The polynomial in time through q0 at t0, then the coordinates qs, a list,
;; evenly spaced, and q1 at t1.
(define (make-path t0 q0 t1 q1 qs)
  (check-argument 'make-path list? qs "a list of intermediate coordinates")
  (interpolation 'make-path 'path
                 (append (list q0) qs (list q1))
                 (append (list t0) (linear-interpolants t0 t1 (length qs)) (list t1))))

;; t ↦ ν(t) (t - t1) (t - t2), a variation that leaves the ends where they are.
(define-printed (make-eta nu t1 t2)
  (check-argument 'make-eta procedure? nu "a function of time, or a tuple of them")
  (lambda (t)
    (g:* (g:- t t1) (g:- t t2) (nu t))))

;; ((parametric-path-action L t0 q0 t1 q1) qs): the action of the path of
;; make-path, as a function of the intermediate coordinates.
;; observe : called with each path and its action
(define-plain (parametric-path-action L t0 q0 t1 q1 #:order [n 1] #:observe [observe void])
  (lambda (qs)
    (define path (make-path t0 q0 t1 q1 qs))
    (define action (Lagrangian-action L path t0 t1 #:order n))
    (observe path action)
    action))

;; n values evenly spaced between x0 and x1, ends excluded, as a list.
(define (linear-interpolants x0 x1 n)
  (check-argument 'linear-interpolants exact-nonnegative-integer? n "a number of points")
  (define step (g:/ (g:- x1 x0) (add1 n)))
  (for/list ([i (in-range 1 (add1 n))])
    (g:+ x0 (g:* i step))))

;; The polynomial of least degree that takes the values ys at the points xs:
;; Σᵢ yᵢ/Πⱼ≠ᵢ (xᵢ − xⱼ) · Πⱼ≠ᵢ (x − xⱼ).  The divisors are known beforehand, and the products
;; are those of the factors before i and of the factors after it.
(define (Lagrange-interpolation-function ys xs)
  (unless (and (list? ys) (list? xs) (= (length ys) (length xs)) (pair? xs))
    (complain-showing 'Lagrange-interpolation-function
                      "expected as many values as points, and at least one"
                      "values" ys "points" xs))
  (define who 'Lagrange-interpolation-function)
  (interpolation who who ys xs))

;; name : it prints as (name from first-point to last-point)
(define (interpolation who name ys xs)
  (define twice (check-duplicates xs))
  (when twice (complain-showing who "two points are the same" "point" twice))
  (define coefficients
    (for/list ([y (in-list ys)] [xi (in-list xs)] [i (in-naturals)])
      (g:/ y (product-of-distances xi i xs))))
  (unary-function
   (lambda () `(,name from ,(value->datum (car xs)) to ,(value->datum (last xs))))
   (x)
   (let ([distances (for/list ([xj (in-list xs)]) (g:- x xj))])
     (for/fold ([sum 0] [before 1] #:result sum)
               ([c (in-list coefficients)] [distance (in-list distances)]
                [after (in-list (products-after distances))])
       (values (g:+ sum (g:* before after c)) (g:* before distance))))))

(define (product-of-distances xi i xs)
  (g:for/product ([xj (in-list xs)] [j (in-naturals)] #:unless (= i j))
    (g:- xi xj)))

;; (a b c d) -> (bcd cd d 1)
(define (products-after xs)
  (for/fold ([products '(1)]) ([x (in-list (reverse (cdr xs)))])
    (cons (g:* x (car products)) products)))
