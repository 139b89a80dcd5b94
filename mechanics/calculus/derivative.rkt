#lang racket/base
;; D and partial: derivatives of functions of any shape.
;;
;; The derivative of a function by a tuple is the tuple, of opposite
;; orientation, of its derivatives by the components: a down tuple for an up
;; argument.  Several arguments are taken together as one up tuple
;; (SICM p. 516).

(require "perturbed.rkt" "dual.rkt" "extract.rkt" "derivative-errors.rkt"
         "../generic/structure.rkt" "../generic/function.rkt" "../generic/describe.rkt"
         "../value/operator.rkt" "../algebra/expression.rkt")

(provide D partial derivative-at value-and-derivative-along name-functions)

;; ---------------------------------------------------------------------------
;; At a point

;; The derivative of f, a function of one argument, at x.
(define (derivative-at f x)
  (cond [(or (expression? x) (perturbed? x))
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

(define D
  (make-primitive-operator
   (case-lambda
     [(f) (derivative-function 'D f derivative-at)]
     [fs (raise-takes-only-function 'D fs)])
   (lambda () 'D)))

;; (partial i j ...): the derivative by component j of component i ... of the
;; argument, or of the tuple of the arguments when there are several.
(define (partial . path)
  (check-path path)
  (define name (cons 'partial path))
  (define (at f x) (partial-at f x path path))
  (make-primitive-operator
   (case-lambda
     [(f) (derivative-function name f at)]
     [fs (raise-takes-only-function name fs)])
   (lambda () name)))

;; The function whose value at x is (derivative-at f x); several arguments are
;; taken as one up tuple.
(define (derivative-function name given-f derivative-at)
  (define f (if (vector? given-f) (vector->up given-f) given-f))
  (unless (procedure? f) (raise-needs-function name f))
  (define mask (bitwise-and (arity-mask f) -2))         ; without arguments there is nothing to vary
  (define (make-datum) (list name (value->datum f)))
  (make-function
   (case-lambda
     [(x)
      (unless (bitwise-bit-set? mask 1) (raise-arity-of-differentiated f (list x) name))
      (name-functions (derivative-at f x) make-datum (list x))]
     [xs
      (unless (bitwise-bit-set? mask (length xs)) (raise-arity-of-differentiated f xs name))
      (name-functions (derivative-at (spread f) (apply up xs)) make-datum xs)])
   mask
   make-datum))

(define (spread f)
  (lambda (s) (apply f (vector->list (structure-elements s)))))

;; A derivative that is a function prints as what was typed to get it, and one
;; within a tuple as a component of that.
(define (name-functions y make-datum args)
  (define (name y path)
    (cond [(structure? y)
           (define i -1)
           (structure-map (lambda (e) (set! i (add1 i)) (name e (cons i path))) y)]
          [(pointwise? y)
           (make-function y (arity-mask y)
                          (lambda ()
                            (define whole (cons (make-datum) (map value->datum args)))
                            (if (null? path) whole (list* 'ref whole (reverse path)))))]
          [else y]))
  (if (and (procedure? y) (holds-function? y)) (name y '()) y))

(define (holds-function? y)
  (cond [(structure? y) (for/or ([e (in-vector (structure-elements y))]) (holds-function? e))]
        [else (pointwise? y)]))
