#lang racket/base
;; D and partial: derivatives of functions of any shape.
;;
;; The derivative of a function by a tuple is the tuple, of opposite
;; orientation, of its derivatives by the components: a down tuple for an up
;; argument; a matrix is taken for the tuples it stands for.  Several arguments
;; are taken together as one up tuple (SICM p. 516).

(require "derivative-errors.rkt" "dual.rkt" "infinitesimal-part.rkt" "Taylor-number.rkt"
         "perturbed-value.rkt"
         "../error/failure.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/scalar.rkt" "../generic/up-down.rkt"
         "../value/operator.rkt"
         "../value/matrix/matrix.rkt"
         "../value/series/calculus.rkt" "../value/series/series.rkt")

(provide D partial derivative-at derivatives-at derivative-function value-and-derivative-along
         name-functions)

;; ---------------------------------------------------------------------------
;; At a point

;; The derivative of f, a function of one argument, at x.
(define (derivative-at f x)
  (cond [(scalar? x)
         (define tag (fresh-tag))
         (extract-tangent tag (f (perturb tag x)))]
        [(tuple? x) (derivative-by-components f (adopt x))]
        [(matrix? x) (derivative-by-entries f x)]
        [(series? x) (derivative-at-series f x)]
        [else (raise-not-differentiable-at x 'D)]))

;; A series is moved by moving its term of order 0.
(define (derivative-at-series f s)
  (define tag (fresh-tag))
  (extract-tangent tag (f (g:+ s (perturb tag 0)))))

(define (derivative-by-components f s)
  (define elements (structure-elements s))
  (structure
   (flip-orientation (structure-orientation s))
   (for/vector #:length (vector-length elements) ([x (in-vector elements)] [i (in-naturals)])
     (derivative-at (lambda (y) (f (replace-component s i y))) x))))

;; A matrix is the down tuple of its columns, which are up tuples; so the
;; derivative by one is an up tuple of down tuples, the product of which with an
;; increment, written as such tuples, is the increment of the value.
(define (derivative-by-entries f m)
  (define (by-entry i j)
    (derivative-at (lambda (y) (f (replace-entry m i j y))) (matrix-ref m i j)))
  (structure 'up
             (for/vector #:length (m:num-cols m) ([j (in-range (m:num-cols m))])
               (structure 'down
                          (for/vector #:length (m:num-rows m) ([i (in-range (m:num-rows m))])
                            (by-entry i j))))))

(define (replace-entry m i j y)
  (m:generate (m:num-rows m) (m:num-cols m)
              (lambda (k l) (if (and (= k i) (= l j)) y (matrix-ref m k l)))))

;; The derivative of order n > 1.  By a number it takes one run of f, on a Taylor
;; number; by anything else, and where that finds a singularity, n nested
;; derivatives.
(define (derivative-of-order n f x)
  (if (scalar? x)
      (unless-singular
       (lambda ()
         (define tag (fresh-tag))
         (extract-derivative tag n (f (displaced tag n x))))
       (lambda () (nested-derivative n f x)))
      (nested-derivative n f x)))

(define (nested-derivative n f x)
  (derivative-at (if (eqv? n 2)
                     (lambda (y) (derivative-at f y))
                     (lambda (y) (derivative-of-order (sub1 n) f y)))
                 x))

;; A Taylor number asks at once for all orders of all parts of f.  Some may not exist that nested
;; derivatives do not need; and these find out which.  (with-handlers takes three times as long.)
(define (unless-singular try otherwise)
  (define result
    (let/ec escape
      (call-with-exception-handler
       (lambda (e) (if (no-value? e) (escape unless-singular) e))
       try)))
  (if (eq? result unless-singular) (otherwise) result))

(define (extract-derivative tag n y)
  (extract (list 'expt 'D n) tag (lambda (jet) (jet-derivative jet n)) y))

;; The list of f and its derivatives up to order n at x, by one run of f if x is a
;; number.
(define (derivatives-at f x n)
  (define (each)
    (for/list ([k (in-range (add1 n))])
      (case k
        [(0) (f x)]
        [(1) (derivative-at f x)]
        [else (derivative-of-order k f x)])))
  (cond [(or (eqv? n 0) (not (scalar? x))) (each)]
        [(eqv? n 1)
         (define-values (y slope) (value-and-derivative-along f x 1))
         (if (holds-function? y) (each) (list y slope))]
        [else
         (unless-singular
          (lambda ()
            (define tag (fresh-tag))
            (define y (f (displaced tag n x)))
            (if (holds-function? y)         ; with an ε inside
                (each)
                (cons (map-leaves (lambda (leaf) (jet-value leaf tag)) y)
                      (for/list ([k (in-range 1 (add1 n))]) (extract-derivative tag k y)))))
          each)]))

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

;; (derive f part), f as a function of the part of s that a path of indices leads to.
(define (partial-at derive f s path whole-path)
  (cond [(null? path) (derive f s)]
        [(tuple? s)
         (define t (adopt s))
         (define i (car path))
         (unless (< i (structure-length t))
           (raise-no-such-component whole-path t))
         (partial-at derive
                     (lambda (y) (f (replace-component t i y)))
                     (vector-ref (structure-elements t) i)
                     (cdr path) whole-path)]
        [else (raise-no-such-component whole-path s)]))

;; ---------------------------------------------------------------------------
;; Operators

;; Two derivatives along one path are one of higher order.  So a derivative remembers its function,
;; path and order.
(struct derivative function (base path order) #:authentic)

;; The procedure of the operator `name` that takes the derivative of order n along
;; the path.  Series of functions are differentiated term by term.
(define (differentiator name path n)
  (define (differentiate f)
    (cond [(and (power-series? f) (null? path))
           (for/fold ([s f]) ([_ (in-range n)]) (series:derivative s))]
          [(and (series? f) (not (power-series? f)))
           (map-series (lambda (x) (if (scalar? x) 0 (differentiate x))) f)]
          [(vector? f) (differentiate (vector->up f))]
          [(and (matrix? f) (not (matrix-of-functions? f))) (raise-needs-function name f)]
          [(procedure? f) (derivative-of name path n f)]
          [else (raise-needs-function name f)]))
  (case-lambda
    [(f) (differentiate f)]
    [fs (raise-takes-only-function name fs)]))

;; The derivative of order n along the path, as a function.
(define (derivative-of name path n f)
  (define again? (and (derivative? f) (equal? (derivative-path f) path)))
  (define base (if again? (derivative-base f) f))
  (define order (if again? (+ n (derivative-order f)) n))
  (define derive (if (eqv? order 1) derivative-at (lambda (f x) (derivative-of-order order f x))))
  (derivative-function name f (lambda (f x) (partial-at derive f x path path))
                       #:of base
                       #:make (lambda (procedure mask make-datum)
                                (derivative procedure mask make-datum base path order))))

(define (operator-of name path)
  (make-primitive-operator (differentiator name path 1)
                           (lambda () name)
                           #:iterate (lambda (n) (differentiator (list 'expt name n) path n))))

(define D (operator-of 'D '()))

;; (partial i j ...): the derivative by component j of component i ... of the
;; argument, or of the tuple of the arguments when there are several.
(define (partial . path)
  (check-path path)
  (operator-of (cons 'partial path) path))

;; The function whose value at x is (derivative-at base x), where base is f unless f
;; is said to be a derivative of it; several arguments are taken as one up tuple.
;; Values known to be numbers are not searched for functions to be named.
(define (derivative-function name given-f derivative-at
                             #:of [given-base #f] #:make [make make-function]
                             #:values-are-numbers? [numbers? #f])
  (define f (if (vector? given-f) (vector->up given-f) given-f))
  (unless (procedure? f) (raise-needs-function name f))
  (define base (or given-base f))
  (define mask (bitwise-and (arity-mask f) -2))         ; without arguments there is nothing to vary
  (define (make-datum) (list name (value->datum f)))
  (define (named y xs) (if numbers? y (name-functions y make-datum xs)))
  (make
   (case-lambda
     [(x)
      (unless (bitwise-bit-set? mask 1) (raise-arity-of-differentiated f (list x) name))
      (named (derivative-at base x) (list x))]
     [xs
      (unless (bitwise-bit-set? mask (length xs)) (raise-arity-of-differentiated f xs name))
      (named (derivative-at (spread base) (apply up xs)) xs)])
   mask
   make-datum))

(define (spread f)
  (lambda (s) (apply f (vector->list (structure-elements s)))))

;; A derivative that is a function prints as the expression typed to get it, and one
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
