#lang racket/base
;; Roots of an equation in which the unknown stands under a square root: P + Q = 0, where Q
;; changes with the sign of the root, is P² = Q² where P and Q have opposite signs.

(require racket/list
         "factors.rkt" "root.rkt"
         (only-in "../assumption/assumption-set.rkt" with-automatic-assumptions)
         "../expression/conjugate.rkt" "../expression/expression.rkt" "../expression/symbols.rkt"
         "../simplify/simplify-expression.rkt")

(provide radical-roots)

;; solve : factor -> its roots, or #f
;; -> roots, or #f
(define (radical-roots f x automatic solve)
  (define A (with-automatic-assumptions automatic #f))
  (define (roots-of-x e) (filter (lambda (r) (occurs? x r)) (roots-in e)))
  (define roots (roots-of-x f))
  (define (norm P Q) (simplify-expression (e:- (e:expt P 2) (e:expt Q 2)) A))
  ;; a root within a logarithm stays: then it would never end
  (define (solve-simpler g) (and (< (length (roots-of-x g)) (length roots)) (solve g)))
  (and (pair? roots)
       (let*-values ([(P Q) (parts-by-root f (car roots))]
                     [(found) (map solve-simpler
                                   (filter (lambda (g) (occurs? x g))
                                           (vanishing-factors (norm P Q) A)))])
         (and (andmap values found)
              (append-map (lambda (root) (of-opposite-signs root P Q A)) (append* found))))))

;; The root in a list, with a condition if need be; none where P and Q have one sign
(define (of-opposite-signs candidate P Q A)
  (define product (value-at (e:* P Q) (root-x candidate) (root-value candidate) A))
  (define-values (sign rest) (if product (sign-and-rest product A) (values 1 1)))
  (cond [(and (not (number? rest)) (not (eqv? sign 0)))
         (define opposite (simplify-expression (e:* (- sign) rest) A))
         (list (struct-copy root candidate
                            [conditions (append (root-conditions candidate)
                                                (list (list '>= opposite 0)))]))]
        [(eqv? sign 1) '()]
        [else (list candidate)]))
