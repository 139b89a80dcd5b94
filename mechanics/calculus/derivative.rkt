#lang racket/base
;; D and partial: derivatives of functions of any shape.
;;
;; The derivative of a function by a tuple is the tuple, of opposite
;; orientation, of its derivatives by the components: a down tuple for an up
;; argument.  Several arguments are taken together as one up tuple
;; (SICM p. 516).

(require "dual.rkt" "derivative-errors.rkt"
         "../generic/structure.rkt" "../generic/function.rkt" "../generic/describe.rkt"
         "../value/operator.rkt" "../algebra/expression.rkt")

(provide D partial derivative-at value-and-derivative-along)

;; ---------------------------------------------------------------------------
;; At a point

;; The derivative of f, a function of one argument, at x.
(define (derivative-at f x)
  (cond [(or (expression? x) (dual? x))
         (define tag (fresh-tag))
         (extract-tangent tag (f (perturb tag x)))]
        [(tuple? x) (derivative-by-components f (adopt x))]
        [else (raise-not-differentiable-at x)]))

(define (derivative-by-components f s)
  (define elements (structure-elements s))
  (structure
   (flip-orientation (structure-orientation s))
   (for/vector #:length (vector-length elements) ([x (in-vector elements)] [i (in-naturals)])
     (derivative-at (lambda (y) (f (replace-component s i y))) x))))

;; f at x and its derivative there in the direction dx, a value of the shape of
;; x, by one run of f.
(define (value-and-derivative-along f x dx)
  (define tag (fresh-tag))
  (define y (f (displace tag x dx)))
  (values (map-leaves (lambda (leaf) (primal-part leaf tag)) y)
          (extract-tangent tag y)))

(define (displace tag x dx)
  (if (tuple? x)
      (structure-map2 (lambda (a b) (displace tag a b)) (adopt x) (adopt dx))
      (make-dual tag x dx)))

(define (replace-component s i y)
  (define old (structure-elements s))
  (define new (make-vector (vector-length old)))
  (vector-copy! new 0 old)
  (vector-set! new i y)
  (same-orientation s new))

;; The derivative of f by the part of s that a path of indices leads to.
(define (partial-at f s path whole-path)
  (cond [(null? path) (derivative-at f s)]
        [(tuple? s)
         (define t (adopt s))
         (define i (car path))
         (unless (< i (structure-length t))
           (raise-no-such-component whole-path t))
         (partial-at (lambda (y) (f (replace-component t i y)))
                     (vector-ref (structure-elements t) i)
                     (cdr path) whole-path)]
        [else (raise-no-such-component whole-path s)]))

;; ---------------------------------------------------------------------------
;; Operators

(define (spread f)
  (lambda (s) (apply f (vector->list (structure-elements s)))))

(define (differentiate f)
  (unless (procedure? f) (raise-needs-function 'D f))
  (case-lambda
    [(x)
     (unless (accepts? f 1) (raise-arity-of-differentiated f (list x) 'D))
     (derivative-at f x)]
    [xs
     (unless (accepts? f (length xs)) (raise-arity-of-differentiated f xs 'D))
     (derivative-by-components (spread f) (apply up xs))]))

(define D
  (make-operator (lambda (f) (with-arity-of f (differentiate f) (lambda () (list 'D (value->datum f)))))
                 'D))

(define (with-arity-of f derivative make-datum)
  (make-function derivative (arity-mask f) make-datum))

;; (partial i j ...): the derivative by component j of component i ... of the
;; argument, or of the tuple of the arguments when there are several.
(define (partial . path)
  (check-path path)
  (define name (cons 'partial path))
  (make-operator
   (lambda (f)
     (unless (procedure? f) (raise-needs-function name f))
     (with-arity-of
      f
      (case-lambda
        [(x)
         (unless (accepts? f 1) (raise-arity-of-differentiated f (list x) name))
         (partial-at f x path path)]
        [xs
         (unless (accepts? f (length xs)) (raise-arity-of-differentiated f xs name))
         (partial-at (spread f) (apply up xs) path path)])
      (lambda () (list name (value->datum f)))))
   name))
