#lang racket/base
;; A function to be made least, as the searches see it: of a point, an flvector.
;;
;; The user's function takes a number, a tuple, or a list, as the book gives coordinates at
;; several times; a list is a tuple meanwhile.  Values may depend on something that is being
;; differentiated: a search goes by their real parts.

(require racket/flonum
         "../calculus/gradient.rkt"
         "../calculus/perturbed-value.rkt"
         "../error/refusal.rkt"
         "../generic/number-argument.rkt" "../generic/up-down.rkt" "../generic/wrong-argument.rkt"
         "../value/shape.rkt")

(provide make-objective objective-who
         objective-start objective-argument objective-value objective-value-and-gradient
         objective-gradient objective-second-derivatives objective-curvature-along
         objective-tuple-function objective-structure tuple-like)

;; given : where the search starts, as the user has it; shape : the same as a tuple or a number
(struct objective (who f given shape) #:authentic)

(define (make-objective who f start) (objective who f start (list->tuple who start)))

(define (objective-start t)
  (define who (objective-who t))
  (structure->flvector (objective-shape t) (lambda (x) (number-beneath who x))))

;; The user's form of a point, and its form as a tuple or a number.
(define (objective-argument t x) (tuple-like (objective-given t) (objective-structure t x)))
(define (objective-structure t x) (flvector->structure (objective-shape t) x))

;; The user's function, of a tuple or a number
(define ((objective-tuple-function t) s) ((objective-f t) (tuple-like (objective-given t) s)))

(define (objective-value t x)
  (value-or-nan (objective-who t) ((objective-f t) (objective-argument t x))))

;; -> value, flvector
(define (objective-value-and-gradient t x)
  (define who (objective-who t))
  (define-values (y slopes)
    (value-and-derivatives-at who (objective-tuple-function t) (objective-structure t x)))
  (values (value-or-nan who y)
          (for/flvector #:length (flvector-length x) ([slope (in-vector slopes)])
            (value-or-nan who slope))))

;; The gradient at x, or #f where the function refuses to be differentiated
(define (objective-gradient t x)
  (if-raised refusal? #f
    (define-values (y slope) (objective-value-and-gradient t x))
    slope))

;; The n² second derivatives row by row, exact; #f where the function refuses them.  A column
;; is the derivative of the gradient along an axis.
(define (objective-second-derivatives t x)
  (define n (flvector-length x))
  (define along (Hessian-vector-product (objective-tuple-function t)))
  (define s (objective-structure t x))
  (define all (make-flvector (* n n)))
  (define (fill-column! j)
    (define axis (scalars->structure s (lambda (k) (if (= k j) 1.0 0.0))))
    (for ([y (in-list (scalars (along s axis)))] [i (in-naturals)])
      (flvector-set! all (+ (* i n) j) (value-or-nan (objective-who t) y))))
  (if-raised refusal? #f
    (for ([j (in-range n)]) (fill-column! j))
    all))

;; v·Hv at x, by one product of the second derivatives with v; #f where these are refused.
(define (objective-curvature-along t x v)
  (define s (objective-structure t x))
  (if-raised refusal? #f
    (define product
      ((Hessian-vector-product (objective-tuple-function t)) s (flvector->structure s v)))
    (for/fold ([sum 0.0]) ([y (in-list (scalars product))] [a (in-flvector v)])
      (fl+ sum (fl* a (value-or-nan (objective-who t) y))))))

;; Outside of its domain a function may be complex.
(define (value-or-nan who y)
  (define x (innermost y))
  (if (and (number? x) (not (real? x))) +nan.0 (real->double-flonum (number who x))))

(define (list->tuple who x)
  (cond [(list? x) (apply up (for/list ([y (in-list x)]) (list->tuple who y)))]
        [(or (tuple? x) (real? (innermost x))) x]
        [else
         (complain-of-argument who "real numbers to start from, in a list or a tuple" x)]))

(define (tuple-like given s)
  (if (list? given)
      (for/list ([x (in-list given)] [y (in-vector (structure-elements s))]) (tuple-like x y))
      s))
