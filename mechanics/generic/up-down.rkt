#lang racket/base
;; Structures: up tuples and down tuples, nested to any depth (SICM p. 513).
;;
;; One struct with an orientation.  A Racket vector is read as an up tuple
;; wherever a structure is expected.  This file knows the data and the meaning of tensor
;; arithmetic; the scalar `+` and `*` it needs are passed in, so that it
;; stands below the generic arithmetic that uses it.

(require racket/flonum
         (submod racket/performance-hint begin-encourage-inline)
         "describe.rkt" "kind.rkt" "notation.rkt" "scalar.rkt" "value-struct.rkt"
         "wrong-argument.rkt"
         (only-in "../algebra/expression/write.rkt" datum->brief-text)
         "../error/complain.rkt"
         "../numeric/vector-map.rkt")

(provide
 ;; data
 structure structure? structure-orientation structure-elements
 computed-structure structure-ref
 up down up? down? tuple? adopt tuple-elements vector->up vector->down up-of down-of
 same-orientation flip-orientation structure-length
 structure-map structure-map2 compatible? same-shape?
 ;; arithmetic over a given ring
 structure-add structure-multiply unequal-contraction)

;; ---------------------------------------------------------------------------
;; Data

(define kind:structure
  (make-kind
   #:rank rank:structure
   #:describe (lambda (s)
                (format "~a ~a tuple of ~a"
                        (if (eq? (structure-orientation s) 'up) "an" "a")
                        (structure-orientation s) (structure-length s)))
   #:datum (lambda (s)
             (cons (structure-orientation s)
                   (for/list ([x (in-vector (structure-elements s))])
                     (value->datum x))))
   #:notation (lambda (s see)
                ((if (up? s) tree:column tree:across)
                 (for/list ([x (in-vector (structure-elements s))]) (see x))))
   #:map (lambda (f s)
           (structure (structure-orientation s)
                      (vector-map (lambda (x) (map-leaves f x))
                                  (structure-elements s))))))

;; orientation : 'up or 'down.  stored : the components, in a vector nobody else may
;; change or, until it is asked for, computed.
(value-struct structure (orientation [stored #:mutable])
  #:kind kind:structure
  #:equality same-structure? hash-structure
  #:property prop:procedure
  (case-lambda
    [(s x) (structure-map (lambda (f) ((applicable f s) x)) s)]
    [(s . xs) (structure-map (lambda (f) (apply (applicable f s) xs)) s)])
  #:property prop:sequence (lambda (s) (in-components (structure-stored s))))

;; Components that are computed each time they are asked for: a long tuple that a function
;; walks along once takes no memory.
;; at : index -> component, always an equal one
(struct computed (length at)
  #:authentic
  #:sealed)

(define (computed-structure orientation n at)
  (structure orientation (if (< n 4096) (all-components n at) (computed n at))))

;; `build-vector` spends longer on asking whether `at` takes an argument.
(define (all-components n at)
  (for/vector #:length n ([i (in-range n)]) (at i)))

(begin-encourage-inline
  (define (structure-elements s)
    (let ([c (structure-stored s)]) (if (computed? c) (store-elements! s c) c)))

  (define (structure-length s)
    (let ([c (structure-stored s)]) (if (computed? c) (computed-length c) (vector-length c)))))

;; Two threads that come here at once store equal vectors.
(define (store-elements! s c)
  (define elements (all-components (computed-length c) (computed-at c)))
  (set-structure-stored! s elements)
  elements)

;; Component i, or Racket's complaint of vector-ref.
(define-syntax-rule (structure-ref s i)
  (let ([c (structure-stored s)])
    (if (computed? c) (computed-component s c i) (vector-ref c i))))

(define (computed-component s c i)
  (if (and (fixnum? i) (< -1 i (computed-length c)))
      ((computed-at c) i)
      (vector-ref (structure-elements s) i)))

(define (in-components c)
  (cond [(computed? c)
         (define n (computed-length c))
         (make-do-sequence
          (lambda () (values (computed-at c) add1 0 (lambda (i) (< i n)) #f #f)))]
        [else (in-vector c)]))

(define (same-structure? a b recur)
  (and (eq? (structure-orientation a) (structure-orientation b))
       (recur (structure-elements a) (structure-elements b))))

(define (hash-structure s recur)
  (+ (if (eq? (structure-orientation s) 'up) 1 2)
     (recur (structure-elements s))))

(define (applicable f s)
  (cond [(procedure? f) f]
        [(vector? f) (vector->up f)]
        [else
         (complain 'application
                   (string-append "a tuple applies its components to the arguments, "
                                  "but the component ~a of ~a is not a function~a")
                   (brief-text f) (brief-text s)
                   (cond [(symbol? f)
                          (format "; (literal-function '~a) makes a function of it" f)]
                         [(number? f)
                          (format (string-append "; (constant-function ~a) makes a function of it"
                                                 "\n  a component is (ref s 0)")
                                  f)]
                         [else ""]))]))

(define (brief-text x) (datum->brief-text (value->datum x)))

(define-syntax-rule (define-constructor make)
  (define make
    (case-lambda
      [(a b) (structure 'make (vector a b))]
      [(a b c) (structure 'make (vector a b c))]
      [xs (structure 'make (list->vector xs))])))
(define-constructor up)
(define-constructor down)

(define (tuple? x) (or (structure? x) (vector? x)))
(define (up? x)
  (or (vector? x) (and (structure? x) (eq? (structure-orientation x) 'up))))
(define (down? x)
  (and (structure? x) (eq? (structure-orientation x) 'down)))

(define (vector->up v) (structure 'up (vector-copy v)))
(define (vector->down v) (structure 'down (vector-copy v)))

;; Of a vector that nobody else changes.
(define (up-of elements) (structure 'up elements))
(define (down-of elements) (structure 'down elements))

;; A structure from a structure or a Racket vector.
(define (adopt x) (if (structure? x) x (vector->up x)))

;; The components, to be looked at only: `adopt` copies a Racket vector.
(define (tuple-elements x) (if (structure? x) (structure-elements x) x))

(define (flip-orientation o) (if (eq? o 'up) 'down 'up))
(define (same-orientation s elements) (structure (structure-orientation s) elements))

(define (vector-copy v)
  (define n (vector-length v))
  (define new (make-vector n))
  (vector-copy! new 0 v)
  new)

(define (structure-map f s)
  (same-orientation s (vector-map f (structure-elements s))))

(define (structure-map2 f s t)
  (same-orientation s (vector-map2 f (structure-elements s) (structure-elements t))))

;; May a and b be added componentwise, looking at their outer shape only?
(define (compatible? a b)
  (and (eq? (structure-orientation a) (structure-orientation b))
       (= (structure-length a) (structure-length b))))

;; Are a and b alike in every orientation and length, at all depths?
(define (same-shape? a b)
  (if (and (tuple? a) (tuple? b))
      (let ([s (adopt a)] [t (adopt b)])
        (and (compatible? s t)
             (for/and ([x (in-vector (structure-elements s))]
                       [y (in-vector (structure-elements t))])
               (same-shape? x y))))
      (not (or (tuple? a) (tuple? b)))))

;; ---------------------------------------------------------------------------
;; Arithmetic

;; The componentwise sum or difference; (refuse a b) where shapes differ.
(define (structure-add add a b refuse)
  (cond [(and (structure? a) (structure? b))
         (if (compatible? a b) (structure-map2 add a b) (refuse a b))]
        [(and (tuple? a) (tuple? b)) (structure-add add (adopt a) (adopt b) refuse)]
        [else (refuse a b)]))

;; Two tuples contract when they are of opposite orientation and equal length
;; and each pair of components contracts too or has a component that is no
;; tuple; the product is then the sum of the products of components.
;; Otherwise each component of the right one is multiplied by the left one
;; (SICM p. 515).  (refuse-sum a b) where the products cannot be added.
(define (structure-multiply add multiply a b refuse refuse-sum)
  (cond [(not (tuple? a)) (structure-map (lambda (y) (multiply a y)) (adopt b))]
        [(not (tuple? b)) (structure-map (lambda (x) (multiply x b)) (adopt a))]
        [else
         (define s (adopt a))
         (define t (adopt b))
         (cond [(contract-flonums s t)]
               [(contractible? s t)
                (contract (adding add (lambda () (refuse-sum s t))) multiply s t)]
               [(and (almost-contractible? s t) (eq? (unequal-contraction) 'error)) (refuse s t)]
               [else (structure-map (lambda (y) (multiply s y)) t)])]))

;; The product of an up and a down tuple of scalars whose lengths differ:
;; 'outer-product, as in the book, or 'error, for it is rarely meant.
(define unequal-contraction
  (make-parameter 'outer-product
                  (lambda (choice)
                    (unless (memq choice '(outer-product error))
                      (complain-of-argument 'unequal-contraction
                                            "'outer-product or 'error" choice))
                    choice)))

(define (opposite? s t) (not (eq? (structure-orientation s) (structure-orientation t))))

(define (almost-contractible? s t)
  (and (opposite? s t)
       (not (= (structure-length s) (structure-length t)))
       (for/and ([x (in-vector (structure-elements s))]) (not (tuple? x)))
       (for/and ([y (in-vector (structure-elements t))]) (not (tuple? y)))))

(define (contractible? s t)
  (and (opposite? s t)
       (= (structure-length s) (structure-length t))
       (for/and ([x (in-vector (structure-elements s))]
                 [y (in-vector (structure-elements t))])
         (or (not (tuple? x)) (not (tuple? y))
             (contractible? (adopt x) (adopt y))))))

;; Addition of products of components, which fails where one is a tuple and the
;; other not, or they are tuples of different shapes.
(define (adding add fail)
  (define (plus a b)
    (cond [(and (structure? a) (structure? b))
           (if (compatible? a b) (structure-map2 plus a b) (fail))]
          [(and (structure? a) (nonzero-scalar? b)) (fail)]
          [(and (nonzero-scalar? a) (structure? b)) (fail)]
          [else (add a b)]))
  plus)

(define (nonzero-scalar? x) (and (not (eqv? x 0)) (scalar? x)))

;; The commonest contraction, that of two tuples of flonums, without a test of each
;; number for each thing it might be; #f for any other.
(define (contract-flonums s t)
  (define v (structure-elements s))
  (define w (structure-elements t))
  (define n (vector-length v))
  (and (eqv? n (vector-length w))
       (opposite? s t)
       (let loop ([i 0] [sum 0.0])
         (cond [(eqv? i n) (and (not (eqv? n 0)) sum)]
               [else
                (define x (vector-ref v i))
                (define y (vector-ref w i))
                (and (flonum? x) (flonum? y)
                     (loop (add1 i) (if (eqv? i 0) (fl* x y) (fl+ sum (fl* x y)))))]))))

(define (contract add multiply s t)
  (define v (structure-elements s))
  (define w (structure-elements t))
  (define n (vector-length v))
  (if (eqv? n 0)
      0
      (let loop ([i 1] [sum (multiply (vector-ref v 0) (vector-ref w 0))])
        (if (= i n)
            sum
            (loop (add1 i)
                  (add sum (multiply (vector-ref v i) (vector-ref w i))))))))
