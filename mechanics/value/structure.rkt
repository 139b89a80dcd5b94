#lang racket/base
;; Structures, taken apart, rebuilt, multiplied.

(require "complex.rkt" "shape.rkt"
         "../error/complain.rkt" "../error/hint.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/elementary.rkt"
         "../generic/function.rkt" "../generic/kind.rkt"
         "../generic/sums-and-products.rkt" "../generic/up-down.rkt"
         "../generic/wrong-argument.rkt")

(provide
 ;; data, from the floor below
 up down up? down? structure? structure-orientation structure-elements tuple? adopt
 vector->up vector->down
 ;; access
 ref component s:ref s:length s:dimension dimension structure->vector structure->list
 list->up list->down
 ;; construction
 s:generate s:map s:map/r s:fold flip s:same s:opposite
 compatible-shape compatible-zero zero-like
 ;; products
 dot-product inner-product outer-product cross-product euclidean-norm unequal-contraction
 structure-of index-range)

;; ---------------------------------------------------------------------------
;; Access

;; (ref s i j ...): component j of component i ... of a tuple or a list; the row of a
;; matrix; the term of that order of a series; of a function, the function whose value is
;; that component of its value.
(define ref
  (case-lambda
    [(s i) (ref-1 s i s)]
    [(s . path) (for/fold ([part s]) ([i (in-list path)]) (ref-1 part i s))]))

;; Component i of s, which was reached within `whole`.
(define (ref-1 s i whole)
  (cond [(tuple? s) (tuple-ref s i)]
        [(and (has-kind? s) (kind-component (kind-of s))) => (lambda (component) (component s i))]
        [(procedure? s) (ref-of-function s i)]
        [(pair? s) (tuple-ref (list->vector s) i s)]
        [(eq? s whole) (raise-not-a-tuple 'ref s)]
        [else
         (complain 'ref "expected a tuple; index ~a was asked of ~a\n  in: ~a" i
                   (describe-with-value s) (value->text whole))]))

(define (tuple-ref s i [given s])
  (define n (if (structure? s) (structure-length s) (vector-length s)))
  (unless (exact-integer? i)
    (complain-showing 'ref "an index is an integer" "index" i))
  (define k (if (negative? i) (+ n i) i))
  (unless (< -1 k n)
    (complain 'ref "index ~a is outside ~a~a\n  in: ~a" i (describe given) (index-range n)
              (value->text given)))
  (if (structure? s) (structure-ref s k) (vector-ref s k)))

;; Of n components, in words
(define (index-range n) (if (zero? n) "" (format " (indices 0 to ~a)" (sub1 n))))

(define (ref-of-function f i)
  (make-function (lambda args (ref (apply f args) i))
                 (arity-mask f)
                 (lambda () (list 'ref (value->datum f) i))))

;; (component i j ...): the selector of that component.
(define (component . path)
  (for ([i (in-list path)] #:unless (exact-integer? i)) (raise-no-index path i))
  (define name (cons 'component path))
  (unary-function (lambda () name) (s) (apply ref s path)))

(define (raise-no-index path i)
  (complain 'component "an index is an integer; given ~a~a" (describe-with-value i)
            (if (tuple? i)
                (let ([indices (value->text (cons 'component (remq i path)))])
                  (format "\n  a selector is applied to a tuple: (~a s)" indices))
                "")))

(define (s:ref s i) (ref s i))

(define (s:length x)
  (cond [(structure? x) (structure-length x)]
        [(vector? x) (vector-length x)]
        [else 1]))

;; The number of scalars in x.
(define (s:dimension x) (shape-length x))
(define (dimension x) (s:dimension x))

(define (structure->vector s)
  (vector-copy-of (structure-elements (structure-of 'structure->vector s))))
(define (vector-copy-of v) (structure-elements (vector->up v)))

(define (structure->list s)
  (vector->list (structure-elements (structure-of 'structure->list s))))
(define (list->up xs) (apply up xs))
(define (list->down xs) (apply down xs))

;; ---------------------------------------------------------------------------
;; Construction

;; (s:generate n 'up f): the tuple of f(0) ... f(n - 1).
(define (s:generate n orientation f)
  (unless (memq orientation '(up down))
    (complain-of-argument 's:generate "'up or 'down" orientation))
  (check-argument 's:generate exact-nonnegative-integer? n "a number of components, at least 0")
  (structure orientation (build-vector n f)))

;; f applied to each component; with several structures, to corresponding ones.
(define (s:map f s . more)
  (unless (procedure? f) (raise-other-function 's:map "a function of the components" f))
  (define first (structure-of 's:map s))
  (define others (for/list ([t (in-list more)]) (structure-of 's:map t)))
  (for ([t (in-list others)])
    (unless (= (structure-length first) (structure-length t))
      (complain-showing 's:map "the structures differ in length"
                        "first" first "another" t)))
  (if (null? others)
      (structure-map f first)
      (same-orientation
       first
       (apply build-from f (structure-elements first) (map structure-elements others)))))

(define (build-from f v . ws)
  (for/vector #:length (vector-length v) ([x (in-vector v)] [i (in-naturals)])
    (apply f x (for/list ([w (in-list ws)]) (vector-ref w i)))))

;; (f scalar accumulator) over all scalars, from the first to the last.
(define (s:fold f start s)
  (if (tuple? s)
      (for/fold ([a start]) ([e (in-vector (tuple-elements s))]) (s:fold f a e))
      (f s start)))

(define (s:same s) (structure-orientation (structure-of 's:same s)))
(define (s:opposite s) (flip-orientation (s:same s)))

;; The same components, every orientation reversed.
(define (flip s)
  (if (tuple? s)
      (let ([t (adopt s)])
        (structure (flip-orientation (structure-orientation t))
                   (structure-elements (structure-map flip t))))
      s))

;; A structure of zeros that contracts with s to a scalar, and one of fresh
;; names, as the book uses to probe bilinear forms (SICM p. 351).
(define (compatible-zero s) (s:map/r (lambda (x) 0) (flip s)))

;; The zero of the kind and shape of s: a tuple, a matrix, a function, an operator.
(define (zero-like s)
  (s:map/r (lambda (x) (map-leaves zero-like-leaf x)) s))

(define (zero-like-leaf x)
  (cond [(pointwise? x) (compose-unary generic:zero-like x)]
        [(procedure? x) (g:* 0 x)]
        [else 0]))

(define generic:zero-like (operation-by-values 'zero-like zero-like))

(define (compatible-shape s)
  (scalars->structure (flip s) (lambda (n) (string->symbol (format "x~a" n)))))

;; ---------------------------------------------------------------------------
;; Products

;; The sum of products of corresponding components of two tuples of one shape.
(define (dot-product a b)
  (cond [(and (tuple? a) (tuple? b))
         (define s (adopt a))
         (define t (adopt b))
         (unless (= (structure-length s) (structure-length t))
           (complain-showing 'dot-product "the tuples differ in length"
                             "first" s "second" t))
         (g:for/sum ([x (in-vector (structure-elements s))]
                     [y (in-vector (structure-elements t))])
           (dot-product x y))]
        [(and (procedure? a) (procedure? b) (not (tuple? a)) (not (tuple? b)))
         (product-of-functions 'dot-product dot-product a b)]
        [(or (tuple? a) (tuple? b))
         (complain-showing 'dot-product "expected two tuples, or two numbers"
                           "first" a "second" b)]
        [else (g:* a b)]))

;; The product of the values of two functions; a may be no function.
(define (product-of-functions name product a b)
  (make-function (lambda args (product (value-at a args) (value-at b args)))
                 (bitwise-and (arity-mask a) (arity-mask b))
                 (lambda () (list name (value->datum a) (value->datum b)))))

;; The dot product of the conjugate of a with b.
(define (inner-product a b) (dot-product (conjugate a) b))

;; The tuple like b of tuples like a: each scalar of a times each of b, none contracted.
(define (outer-product a b)
  (define (products)
    (s:map/r (lambda (y) (s:map/r (lambda (x) (g:* x y)) a)) (structure-of 'outer-product b)))
  (if (or (pointwise? a) (pointwise? b))
      (product-of-functions 'outer-product outer-product a b)
      (products)))

(define (cross-product a b)
  (if (and (pointwise? a) (pointwise? b))
      (product-of-functions 'cross-product cross-product a b)
      (cross-product-of-tuples a b)))

(define (cross-product-of-tuples a b)
  (define s (structure-of 'cross-product a))
  (define t (structure-of 'cross-product b))
  (unless (= 3 (structure-length s) (structure-length t))
    (complain-showing 'cross-product "expected two tuples of 3"
                      "first" s "second" t))
  (define (minor i j)
    (g:- (g:* (s:ref s i) (s:ref t j)) (g:* (s:ref s j) (s:ref t i))))
  (same-orientation s (vector (minor 1 2) (minor 2 0) (minor 0 1))))

(define (euclidean-norm s) (g:sqrt (g:square s)))

;; ---------------------------------------------------------------------------
;; Errors

(define (structure-of who s)
  (if (tuple? s) (adopt s) (raise-not-a-tuple who s)))

(define (raise-not-a-tuple who s)
  (complain-of-argument who "a tuple" s (list-hint s)))
