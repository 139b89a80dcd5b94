#lang racket/base
;; gradient, jacobian and their kin: derivatives in reverse mode.
;;
;; D runs a function once for each scalar of its argument.  Recording one run on a
;; tape and sweeping back over it gives the derivatives of one scalar of the value
;; by all of them; so a gradient costs a few runs, be it in a million variables.
;; The values are those of D.

(require "derivative-errors.rkt" "derivative.rkt" "gradient-errors.rkt"
         (only-in "gradient-tape.rkt" tape-inputs)
         "perturbed-value.rkt" "recorded-number.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/scalar.rkt" "../generic/up-down.rkt"
         "../numeric/vector-map.rkt"
         "../value/operator.rkt" "../value/structure.rkt"
         "../value/matrix/matrix.rkt")

(provide gradient jacobian
         Hessian-vector-product jacobian-vector-product vector-jacobian-product
         ;; for minimisation
         value-and-derivatives-at)

;; ---------------------------------------------------------------------------
;; One run

;; The value of f at x, a structure if it is a tuple, recorded; and the tape.
(define (record-run who f x [all-flonums? (flat? x)])
  (define t
    (if all-flonums?
        (make-recording (fresh-tag) (structure-length x) #t)
        (make-recording (fresh-tag) (count-scalars who x) (of-flonums? x))))
  (values (f (if all-flonums? (record-flat t x 0) (record-scalars t x))) t))

(define (count-scalars who x)
  (cond [(flat? x) (structure-length x)]
        [(tuple? x) (for/sum ([e (in-vector (tuple-elements x))]) (count-scalars who e))]
        [(matrix? x) (for/sum ([row (in-vector (matrix-rows x))]) (count-scalars who row))]
        [(scalar? x) 1]
        [else (raise-not-differentiable-at x who)]))

(define (of-flonums? x)
  (cond [(flonum? x) #t]
        [(tuple? x) (for/and ([e (in-vector (tuple-elements x))]) (of-flonums? e))]
        [else #f]))

(define (orientation-of x) (if (structure? x) (structure-orientation x) 'up))

;; Is x a tuple of flonums alone, as most long tuples are?  These are recorded, and their
;; derivatives shaped, in one go.
(define (flat? x)
  (and (structure? x) (for/and ([e (in-vector (structure-elements x))]) (flonum? e))))

;; x with its scalars recorded as the variables of a tape.
(define (record-scalars t x)
  (define-values (next! skip!) (numbering))
  (let walk ([x x])
    (cond [(flat? x) (record-flat t x (skip! (structure-length x)))]
          [(tuple? x) (structure (orientation-of x) (vector-map walk (tuple-elements x)))]
          [else (map-leaves (lambda (leaf) (record-input t (next!) leaf)) x)])))

;; A tuple of flonums alone, recorded as the variables from `first` on.
(define (record-flat t x first)
  (computed-structure (structure-orientation x) (structure-length x)
                      (flonum-inputs t first (structure-elements x))))

;; -> two procedures that number from 0: the next number, and the first of a count of numbers
(define (numbering)
  (define i 0)
  (define (skip! count) (begin0 i (set! i (+ i count))))
  (values (lambda () (skip! 1)) skip!))

;; The value of `entry` at the number of each scalar of x, shaped as a derivative
;; by x: a tuple of the other orientation; by a matrix, the up tuple of its columns
;; as down tuples.
(define (shape-as-derivative x entry)
  (define-values (next! skip!) (numbering))
  (let walk ([x x])
    (cond [(tuple? x)
           (structure (flip-orientation (orientation-of x)) (vector-map walk (tuple-elements x)))]
          [(matrix? x)
           (define columns (m:num-cols x))
           (define first (skip! (* columns (m:num-rows x))))
           (s:generate columns 'up
                       (lambda (j)
                         (s:generate (m:num-rows x) 'down
                                     (lambda (i) (entry (+ first j (* i columns)))))))]
          [else (entry (next!))])))

;; The operator `name` whose images have the values (derivative-at f x).
(define (derivative-operator name derivative-at numbers?)
  (make-primitive-operator
   (case-lambda
     [(f) (derivative-function name f derivative-at #:values-are-numbers? numbers?)]
     [fs (raise-takes-only-function name fs)])
   (lambda () name)))

;; ---------------------------------------------------------------------------
;; gradient

(define (gradient-at f point)
  (define x (if (vector? point) (adopt point) point))
  (define all-flonums? (flat? x))
  (define-values (y t) (record-run 'gradient f x all-flonums?))
  (unless (or (on-tape? y t) (scalar? y)) (raise-not-scalar 'gradient f y))
  (define ds (derivatives t y))
  ;; in the shape of x
  (if all-flonums?
      (structure (flip-orientation (structure-orientation x)) ds)
      (shape-as-derivative x (lambda (i) (vector-ref ds i)))))

(define gradient (derivative-operator 'gradient gradient-at #t))

;; The value of f at x and its derivatives by the scalars of x, in a vector.
(define (value-and-derivatives-at who f x)
  (define-values (y t) (record-run who f x))
  (unless (scalar? y) (raise-not-scalar who f y))
  (value-and-derivatives t y))

;; ---------------------------------------------------------------------------
;; jacobian

;; In reverse mode there is one sweep for each scalar of the value, in forward
;; mode one run for each of the argument.
(define (jacobian-at f x)
  (cond [(scalar? x) (derivative-at f x)]
        [else
         (define-values (y t) (record-run 'jacobian f x))
         (define outputs (scalars-of y))
         (if (and outputs (<= (length outputs) (tape-inputs t)))
             (assemble x y (for/list ([s (in-list outputs)]) (derivatives t s)))
             (derivative-at f x))]))

;; The scalars of y in order, or #f if it contains functions or the like.
(define (scalars-of y)
  (define found (leaves y))
  (and (andmap scalar? found) found))

;; For each scalar of x, a value shaped like y.
(define (assemble x y columns)
  (shape-as-derivative
   x
   (lambda (i)
     (define left columns)
     (map-leaves (lambda (leaf)
                   (define column (car left))
                   (set! left (cdr left))
                   (vector-ref column i))
                 y))))

(define jacobian (derivative-operator 'jacobian jacobian-at #f))

;; ---------------------------------------------------------------------------
;; Products

;; The function of a point x and a second argument v that `product` computes from
;; f, x and v.
(define (product-function name f product)
  (unless (procedure? f) (raise-needs-function name f))
  (unless (accepts? f 1) (raise-takes-no-point name f))
  (make-function
   (lambda (x v) (product f x v))
   (arithmetic-shift 1 2)
   (lambda () (list name (value->datum f)))))

;; The gradient of the derivative along v, which is the derivative of the gradient
;; along v.  In this order the tape holds flonums where x and v do, and it takes
;; about half of the time that dual numbers on a tape take.
(define (Hessian-vector-product f)
  (product-function
   'Hessian-vector-product f
   (lambda (f x v)
     (check-increment 'Hessian-vector-product x v)
     (define (slope-along-v s)
       (define-values (y slope) (value-and-derivative-along f s v))
       (unless (scalar? y) (raise-not-scalar 'Hessian-vector-product f y))
       slope)
     (gradient-at slope-along-v x))))

;; The derivative of f along v, (* ((D f) x) v): one run in forward mode.
(define (jacobian-vector-product f)
  (product-function
   'jacobian-vector-product f
   (lambda (f x v)
     (check-increment 'jacobian-vector-product x v)
     (define-values (value product) (value-and-derivative-along f x v))
     product)))

;; (* w ((D f) x)), with a w that contracts with the value: the gradient of
;; (* w (f x)), w being constant.
(define (vector-jacobian-product f)
  (product-function
   'vector-jacobian-product f
   (lambda (f x w)
     (define (contraction s)
       (define y (f s))
       (check-covector 'vector-jacobian-product y w)
       (g:* w y))
     (gradient-at contraction x))))
