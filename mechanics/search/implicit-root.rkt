#lang racket/base
;; Roots of functions that depend on something being differentiated.
;;
;; Where f(x, a) = 0, the root x is a function of a.  Let x₀ be the root for the value of
;; a without its ε, and J the matrix of derivatives by x there.  Then
;;
;;     x ← x − J⁻¹ f(x, a),
;;
;; in the arithmetic of perturbed values, is right to one more order of ε each time: the
;; first step is the implicit function theorem, dx = −J⁻¹ ∂f/∂a da.  Powers of ε above
;; the sum of the orders of all ε there are vanish, and with them the error.

(require racket/flonum
         "../calculus/Taylor-number.rkt" "../calculus/perturbed-value.rkt"
         "../calculus/recorded-number.rkt"
         "../error/failure.rkt"
         "../generic/arithmetic.rkt"
         "../numeric/linear-algebra/flonum-systems.rkt" "../numeric/linear-algebra/row-matrix.rkt"
         "../value/shape.rkt")

(provide plain varying-root raise-no-derivative total-order columns->rows)

;; y with numbers in place of perturbed values
(define (plain y)
  (vector->structure y (list->vector (map innermost (scalars y)))))

;; x : a root of (compose plain f); (jacobian) -> its derivatives there, a vector of rows
(define (varying-root who f x jacobian #:what [what no-inverse])
  (define order (total-order (scalars (f x))))
  (if (eqv? order 0)
      x
      (let ([inverse (inverse-rows who what (jacobian) x)])
        (for/fold ([x x]) ([_ (in-range order)]) (step f x inverse)))))

(define (step f x inverse)
  (define ys (scalars (f x)))
  (define xs
    (for/vector ([x (in-list (scalars x))] [row (in-vector inverse)])
      (for/fold ([x x]) ([a (in-vector row)] [y (in-list ys)]) (g:- x (g:* a y)))))
  (vector->structure x xs))

(define no-inverse
  "the root has no derivative: those of the function have no inverse there")

(define (inverse-rows who what rows x)
  (define n (vector-length rows))
  (define inverse
    (and (all-entries? rational? rows) (floating-solutions rows (unit-rows n 1.0 0.0))))
  (if (vector? inverse)
      inverse
      (raise-no-derivative who x what)))

(define (raise-no-derivative who x [what no-inverse])
  (raise-singular who what x "at" x))

;; v : the derivatives by the first variable, by the second, ...
(define (columns->rows n v)
  (for/vector #:length n ([i (in-range n)])
    (for/vector #:length n ([j (in-range n)]) (flvector-ref v (+ i (* j n))))))

;; The sum of the orders of all ε in these values.
(define (total-order xs)
  (define orders (make-hasheqv))        ; tag -> order
  (define (visit x)
    (when (perturbed? x)
      (hash-set! orders (perturbed-tag x) (if (jet? x) (jet-order x) 1))
      (if (recorded? x)
          (visit (recorded-value x))
          ((parts-map (parts-of x)) (lambda (part) (visit part) part) x))))
  (for-each visit xs)
  (for/sum ([order (in-hash-values orders)]) order))
