#lang racket/base
;; Quotients by tuples of tuples, which stand for linear maps.
;;
;; (/ b A) is the x with (* A x) = b, and (/ A) or (invert A) the structure of the inverse
;; map, so that (* (invert A) b) is the same x.  All else is the quotient of the floor below,
;; which knows of no linear algebra.

(require "linear-algebra.rkt"
         "../shape.rkt" "../structure.rkt"
         "../../algebra/expression/expression.rkt"
         "../../generic/arithmetic.rkt" "../../generic/function.rkt"
         "../../generic/kind.rkt" "../../generic/naming.rkt" "../../generic/scalar.rkt"
         "../../generic/up-down.rkt")

(provide quotient-of inverse-of)

(define (divide a b)
  (cond [(and (number? a) (number? b)) (/ a b)]
        [(or (carrier? b) (expression? b)) (g:/ a b)]
        [(tuple? b) (divide-by-structure a (adopt b))]
        [(and (pointwise? b) (or (scalar? a) (tuple? a) (pointwise? a)))
         (combine-functions generic:quotient a b)]
        [else (g:/ a b)]))

(define-named quotient-of /
  (case-lambda
    [(a b) (divide a b)]
    [(a) (divide 1 a)]
    [(a b . more) (for/fold ([q (divide a b)]) ([x (in-list more)]) (divide q x))]))

(define-named inverse-of invert (lambda (a) (divide 1 a)))

;; As functions are divided: by their values
(define generic:quotient (struct-copy generic-op generic:/ [procedure divide]))

(define (divide-by-structure a A)
  (cond [(not (square-map? A)) (g:/ a A)]
        [(pointwise? a) (combine-functions generic:quotient a A)]
        [(scalar? a) (g:* a (inverse A))]
        [(not (tuple? a)) (g:/ a A)]
        [(same-shape? a (image A)) (solve-linear-left A a)]
        [(divisible? (adopt a) A) (structure-map (lambda (x) (divide x A)) (adopt a))]
        [else (g:/ a A)]))

;; Has A as many components as each of them has scalars, all in one tuple?
(define (square-map? A)
  (define n (structure-length A))
  (and (positive? n)
       (for/and ([column (in-vector (structure-elements A))])
         (and (tuple? column)
              (= (s:length column) n)
              (same-shape? column (s:ref A 0))
              (for/and ([x (in-vector (tuple-elements column))]) (not (tuple? x)))))))

;; A value of the shape of A x.
(define (image A) (s:ref A 0))

;; Is b a tuple of values of this shape, which A multiplies component by component?
(define (divisible? b A)
  (and (for/and ([x (in-vector (structure-elements b))]) (same-shape? x (image A)))
       (same-shape? (g:* A b) b)))

;; Column j is the x with (* A x) = 1 in place j and 0 elsewhere.
(define (inverse A)
  (define like (adopt (image A)))
  (define n (structure-length like))
  (structure (flip-orientation (structure-orientation like))
             (for/vector #:length n ([j (in-range n)])
               (solve-linear-left A (unit-structure like j)))))
