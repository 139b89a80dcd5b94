#lang racket/base
;; Integrals of forms over boxes that are mapped to a manifold, and Stokes' theorem.
;;
;; A form of rank k is pulled back by the map to the box, where it is f du₁ ∧ … ∧ duₖ, and f is
;; integrated.  The boundary of the box has two faces for each parameter,
;;
;;     ∫_∂ ω = Σᵢ (−1)ⁱ (∫ ω over uᵢ = end − ∫ ω over uᵢ = start),   i from 0,
;;
;; and that is ∫ dω since d and the pullback commute, which is verified.

(require "component-array.rkt" "exterior-calculus.rkt" "tensor-field.rkt" "manifold-chart.rkt"
         "manifold-function.rkt" "maps-between-manifolds.rkt" "manifold-point.rkt"
         "chart-calculus.rkt" "standard-manifolds.rkt"
         "../compile/definite-integral.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/up-down.rkt" "../generic/wrong-argument.rkt"
         "../verdict/prove-zero.rkt" "../verdict/verdict.rkt")

(provide integrate-form integrate-over-boundary verify-Stokes)

;; map : of k numbers, gives a point;  ranges : a list of start and end for each of them
(define (integrate-form w map . ranges)
  (define who 'integrate-form)
  (cond [(function-of-points? w) (check-ranges who map 0 ranges) (value-of-point who w map)]
        [else
         (check-argument who form-field? w "a form, or a function on the manifold")
         (define k (field-rank w))
         (define all (check-ranges who map k ranges))
         (integral-over all (density w map k))]))

(define (value-of-point who f map)
  (if (procedure? f) (f (map)) f))

;; The ranges, [0, 1] for all if none is given
(define (check-ranges who map k ranges)
  (unless (and (procedure? map) (accepts? map k))
    (complain who "a form of rank ~a is integrated over a map of ~a number~a to points\n  given: ~a"
              k k (if (= k 1) "" "s") (describe-function map)))
  (for ([r (in-list ranges)])
    (check-argument who (lambda (r) (and (list? r) (= (length r) 2))) r
                    "ranges, each a list of start and end"))
  (cond [(null? ranges) (for/list ([_ (in-range k)]) '(0 1))]
        [(= (length ranges) k) ranges]
        [else (complain who "a form of rank ~a is integrated over ~a range~a\n  given: ~a"
                        k k (if (= k 1) "" "s") ranges)]))

;; The box as a manifold, and the map from it
(define (box-chart k) (coordinate-system-at 'rectangular 'origin (make-manifold R^n k)))

(define (on-points map)
  (define (f m)
    (define x (point-coordinates m))
    (apply map (if (tuple? x) (vector->list (tuple-elements x)) (list x))))
  (procedure-rename f (procedure-datum map)))

;; numbers -> the value of the form on the images of ∂/∂u₁ …
(define (density w map k)
  (define C (box-chart k))
  (define all (components-in ((pullback-form (on-points map)) w) C))
  (define f (vector (component all k (for/list ([i (in-range k)]) i))))
  (lambda us (vector-ref (evaluate-components f C (coordinate-tuple (list->vector us))) 0)))

(define (integral-over ranges f)
  (if (null? ranges)
      (f)
      (definite-integral (lambda (u) (integral-over (cdr ranges) (lambda us (apply f u us))))
                         (caar ranges) (cadar ranges))))

;; ---------------------------------------------------------------------------

;; w : of a rank less than the map has parameters
(define (integrate-over-boundary w map . ranges)
  (define who 'integrate-over-boundary)
  (define k (add1 (if (form-field? w) (field-rank w) 0)))
  (define all (check-ranges who map k ranges))
  (for/fold ([sum 0]) ([range (in-list all)] [i (in-naturals)])
    (define others (append (head all i) (list-tail all (add1 i))))
    (define (face u)
      (apply integrate-form w
             (procedure-reduce-arity
              (lambda us (apply map (append (head us i) (list u) (list-tail us i))))
              (sub1 k))
             others))
    (define difference (g:- (face (cadr range)) (face (car range))))
    ((if (even? i) g:+ g:-) sum difference)))

(define (head xs i) (for/list ([x (in-list xs)] [_ (in-range i)]) x))

;; Is the integral of dw that of w over the boundary?
(define (verify-Stokes w map)
  (define who 'verify-Stokes)
  (check-argument who (lambda (w) (or (form-field? w) (function-of-points? w))) w
                  "a form, or a function on the manifold")
  (define k (add1 (if (form-field? w) (field-rank w) 0)))
  (check-ranges who map k '())
  (define back (pullback (on-points map)))
  (define residual (g:- (back (exterior-derivative w)) (exterior-derivative (back w))))
  (with-remark (prove-zero (up-of (components-in residual (box-chart k))))
               "Stokes' theorem holds on boxes where the form is smooth along the map"))
