#lang racket/base
;; Indices up and down: vectors as 1-forms and back, by a metric; contractions and traces.

(require "basis.rkt" "chart-calculus.rkt" "component-array.rkt" "tensor-field.rkt"
         "manifold-chart.rkt" "manifold-function.rkt" "metric.rkt"
         "covariant-derivative.rkt" "curvature-tensor.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt"
         "../generic/up-down.rkt" "../generic/wrong-argument.rkt")

(provide lower raise-form contract
         drop1 drop2 raise1 raise2 trace2down trace2up
         orthonormalize scalar-curvature Einstein-tensor)

;; T with index p moved by the metric: its type becomes `type`.
(define (with-index-moved who g T p type)
  (define over (common-over who (list T)))
  (make-field (common-field-home who (list T g))
              (for/list ([t (in-list (field-types T))] [i (in-naturals)]) (if (= i p) type t))
              (lambda (C)
                (define place (place-over over C))
                (define n (target-dimension place))
                (define M (components-over (if (eq? type 'vector) g (metric:invert g)) over C))
                (apply-to-index (components-over T over C) n (field-rank T) p
                                (lambda (j i) (component M n (list j i)))))
              (lambda () `((,who ,(value->datum g)) ,(value->datum T)))
              #:over over #:form? (and (= (field-rank T) 1) (eq? type 'vector))))

(define (check-types who T types what)
  (check-argument who (lambda (x) (and (field? x) (equal? (field-types x) types))) T what))

;; A function of such fields is a tensor as well.
(define (as-tensor who T types)
  (cond [(function-of-fields? T) (with-argument-types T types)]
        [else (check-types who T types (format "a tensor field of the arguments ~a" types)) T]))

;; ((lower metric) v) is g(v, ·)
(define (lower metric)
  (define g (as-metric 'lower metric))
  (lambda (v)
    (check-argument 'lower vector-field? v "a vector field")
    (with-index-moved 'lower g v 0 'vector)))

;; ((raise metric basis) w); no basis is needed for it
(define (raise-form metric [basis #f])
  (define g (as-metric 'raise metric basis))
  (lambda (w)
    (check-types 'raise w '(vector) "a 1-form")
    (with-index-moved 'raise g w 0 '1form)))

(define ((moving who positions from to) metric [basis #f])
  (define g (as-metric who metric basis))
  (lambda (T)
    (for/fold ([T (as-tensor who T from)]) ([p (in-list positions)])
      (with-index-moved who g T p to))))

(define drop1 (moving 'drop1 '(0) '(1form vector) 'vector))
(define drop2 (moving 'drop2 '(0 1) '(1form 1form) 'vector))
(define raise1 (moving 'raise1 '(0) '(vector vector) '1form))
(define raise2 (moving 'raise2 '(0 1) '(vector vector) '1form))

;; Σᵢ f(eᵢ, ẽⁱ)
(define (contract f basis)
  (check-argument 'contract procedure? f "a function of a vector field and a 1-form")
  (check-basis 'contract basis)
  (apply g:+ (for/list ([e (in-vector (tuple-elements (basis-of-vectors basis)))]
                        [w (in-vector (tuple-elements (basis-of-forms basis)))])
               (f e w))))

(define ((trace-with who types inverse?) metric [basis #f])
  (define g (as-metric who metric basis))
  (lambda (tensor)
    (define T (as-tensor who tensor types))
    (define over (common-over who (list T g)))
    (make-manifold-function
     (common-field-home who (list T g))
     (lambda (C)
       (define gs (components-over (if inverse? (metric:invert g) g) over C))
       (define Ts (components-over T over C))
       (sum-of-products (vector-length gs) (lambda (k) (vector-ref gs k))
                        (lambda (k) (vector-ref Ts k))))
     (lambda () `((,who ,(value->datum g)) ,(value->datum T))))))

(define trace2down (trace-with 'trace2down '(vector vector) #t))
(define trace2up (trace-with 'trace2up '(1form 1form) #f))

;; ---------------------------------------------------------------------------
;; By Gram's and Schmidt's process, a down tuple of vector fields; where g(e, e) is negative, of
;; length −1.

(define (orthonormalize vectors metric C)
  (define who 'orthonormalize)
  (check-argument who tuple? vectors "a tuple of vector fields")
  (define g (as-metric who metric))
  (check-coordinate-system who C)
  (define (unit e i)
    (when (eqv? (tidied (expression-in (g e e) C)) 0)
      (complain who "a vector of length 0 came up, which cannot be made a unit vector\n  it is: ~a"
                (value->text e)))
    (define (find B)
      (define length (root-of-size (expression-in (g e e) B) B))
      (for/vector ([x (in-vector (components-in e B))]) (tidied (g:/ x length))))
    (make-field C '(1form) find
                (lambda () `(ref (orthonormalize ,(value->datum vectors) ,(value->datum g)) ,i))))
  (define found
    (for/fold ([found '()]) ([v (in-vector (tuple-elements vectors))] [i (in-naturals)])
      (define rest
        (for/fold ([v v]) ([e (in-list found)])
          (g:- v (g:* (g:/ (g v e) (g e e)) e))))
      (cons (unit rest i) found)))
  (down-of (list->vector (reverse found))))

;; ---------------------------------------------------------------------------
;; Curvature of a metric

(define (Ricci-of g basis) (Ricci (covariant-derivative (metric->Cartan g basis)) basis))

;; Ricci's tensor, contracted
(define (scalar-curvature metric basis)
  (define g (as-metric 'scalar-curvature metric basis))
  ((trace2down g) (Ricci-of g basis)))

;; Ricci's tensor less half the scalar curvature times the metric
(define (Einstein-tensor metric basis)
  (define g (as-metric 'Einstein-tensor metric basis))
  (g:- (Ricci-of g basis) (g:* (g:* 1/2 (scalar-curvature g basis)) g)))
