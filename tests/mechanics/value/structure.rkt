#lang racket/base
;; Structures: access, construction, products.

(require mechanics/generic/arithmetic
         mechanics/value/structure (only-in mechanics/value/shape typical-object)
         mechanics/calculus/literal-function
         (only-in mechanics/scmutils dual-zero)
         "../support/checks.rkt"
         "../support/messages.rkt" "../support/random.rkt" "../support/same.rkt"
         "../support/random/element.rkt")

(define s (up 't (up 'x 'y) (down 1 (up 2 3))))

;; ---------------------------------------------------------------------------
;; Access

(test-case "ref follows a chain of indices, from the end if negative"
  (check-equal? (ref s 0) 't)
  (check-equal? (ref s 1 1) 'y)
  (check-equal? (ref s 2 1 0) 2)
  (check-equal? (ref s -1 -1 -1) 3)
  (check-equal? (ref (vector 1 (vector 2 3)) 1 0) 2)
  (check-equal? (ref s) s))

(test-case "ref and component apply to functions"
  (define path (up (literal-function 'x) (literal-function 'y)))
  (check-equal? ((ref path 1) 't) ((literal-function 'y) 't))
  (define q (lambda (t) (up t (g:* 2 t))))
  (check-equal? ((ref q 1) 'a) (g:* 2 'a))
  (check-equal? ((ref (lambda (t) (up 1 (up 2 t))) 1 1) 'a) 'a)
  (check-equal? ((component 1) s) (up 'x 'y))
  (check-equal? ((component 2 1 1) s) 3)
  (check-equal? ((ref (lambda (x y) (up x y)) 1) 'a 'b) 'b))

(test-case "selectors print as what makes them"
  (check-equal? (format "~a" (component 1 0)) "(component 1 0)")
  (define (q t) (up t t))
  (check-equal? (format "~a" (ref q 1)) "(ref q 1)"))

(test-case "an index out of range is named, with the tuple"
  (check-message "ref: index 5 is outside an up tuple of 2 (indices 0 to 1)\n  in: (up 1 2)"
                 (ref (up 1 2) 5))
  (check-message "ref: index -3 is outside a down tuple of 2 (indices 0 to 1)\n  in: (down a b)"
                 (ref (down 'a 'b) -3))
  (check-message "ref: index 0 is outside an up tuple of 0\n  in: (up)" (ref (up) 0))
  (check-message "ref: an index is an integer\n  index: 'x" (ref (up 1 2) 'x)))

(test-case "ref into what is no tuple says where"
  (check-message "ref: expected a tuple\n  given: the number 3" (ref 3 0))
  (check-message "ref: index 2 is outside a list (indices 0 to 1)\n  in: (1 2)" (ref '(1 2) 2))
  (check-message
   "ref: expected a tuple; index 1 was asked of the symbol t\n  in: (up t (up x y) (down 1 (up 2 3)))"
   (ref s 0 1)))

(test-case "lengths and dimensions"
  (check-equal? (map s:length (list s (up) 'a)) '(3 0 1))
  (check-equal? (map s:dimension (list s (up) 'a)) '(6 0 1))
  (check-equal? (dimension (vector 1 (up 2 3))) 3))

(test-case "to and from lists and vectors"
  (check-equal? (structure->list (up 1 2)) '(1 2))
  (check-equal? (structure->vector (down 1 2)) (vector 1 2))
  (check-equal? (list->up '(1 2)) (up 1 2))
  (check-equal? (list->down '(1 2)) (down 1 2))
  (check-equal? (vector->down (vector 1 2)) (down 1 2))
  (define v (structure->vector s))
  (vector-set! v 0 'changed)
  (check-equal? (ref s 0) 't)
  (check-exn #rx"^structure->list: expected a tuple\n  given: the number 3$"
             (lambda () (structure->list 3))))

;; ---------------------------------------------------------------------------
;; Construction

(test-case "structures from a rule"
  (check-equal? (s:generate 3 'up add1) (up 1 2 3))
  (check-equal? (s:generate 2 'down (lambda (i) (up i))) (down (up 0) (up 1)))
  (check-exn #rx"expected 'up or 'down" (lambda () (s:generate 2 'left add1))))

(test-case "mapping keeps the orientation of the first"
  (check-equal? (s:map g:square (down 1 'a)) (down 1 (g:square 'a)))
  (check-equal? (s:map g:+ (up 1 2) (down 10 20) (up 100 200)) (up 111 222))
  (check-equal? (s:map/r add1 (up 1 (down 2 (up 3)))) (up 2 (down 3 (up 4))))
  (check-equal? (s:map/r add1 1) 2)
  (check-message "s:map: the structures differ in length\n  first: (up 1 2)\n  another: (up 1)"
                 (s:map g:+ (up 1 2) (up 1))))

(test-case "folding goes through all scalars in order"
  (check-equal? (s:fold cons '() (up 1 (down 2 3) 4)) '(4 3 2 1)))

(test-case "flipping reverses every orientation, twice is nothing"
  (check-equal? (flip s) (down 't (down 'x 'y) (up 1 (down 2 3))))
  (check-equal? (flip (vector 1 2)) (down 1 2))
  (check-equal? (flip 'a) 'a)
  (with-seed 301
    (for ([_ 10])
      (define x ((random-nested random-rational)))
      (check-equal? (flip (flip x)) x)))
  (check-equal? (list (s:same s) (s:opposite s)) '(up down)))

(test-case "a compatible shape contracts with the structure to a scalar"
  (check-equal? (compatible-shape s) (down 'x0 (down 'x1 'x2) (up 'x3 (down 'x4 'x5))))
  (check-equal? (compatible-zero s) (down 0 (down 0 0) (up 0 (down 0 0))))
  (check-equal? (dual-zero s) (compatible-zero s))
  (check-equal? (zero-like s) (up 0 (up 0 0) (down 0 (up 0 0))))
  (check-equal? (g:* (compatible-zero s) s) 0)
  (check-equal? (list (compatible-shape 1) (compatible-zero 'a) (zero-like 3)) '(x0 0 0)))

(test-case "a typical object is of symbols that nobody could have written"
  (check-equal? (format "~a" (typical-object (up 1 (down 2 3)))) "(up x0 (down x1 x2))")
  (check-false (equal? (typical-object 'a) (typical-object 'a)))
  (check-false (equal? (typical-object 'a) 'x0)))

;; ---------------------------------------------------------------------------
;; Products

(test-case "the dot product adds up products of corresponding scalars"
  (check-equal? (dot-product (up 1 2 3) (up 4 5 6)) 32)
  (check-equal? (dot-product (up 1 2) (down 3 4)) 11)
  (check-equal? (dot-product (up 1 (up 2 3)) (up 1 (up 2 3))) 14)
  (check-equal? (dot-product (vector 1 'a) (up 'b 2)) (g:+ 'b (g:* 'a 2)))
  (check-equal? (dot-product 3 'a) (g:* 3 'a))
  (check-equal? (inner-product (up 1 2) (up 3 4)) 11)
  (define v (lambda (t) (up t 2)))
  (check-equal? ((dot-product v v) 3) 13))

(test-case "the dot product of unlike things is refused"
  (check-message "dot-product: the tuples differ in length\n  first: (up 1 2)\n  second: (up 1 2 3)"
                 (dot-product (up 1 2) (up 1 2 3)))
  (check-message "dot-product: expected two tuples, or two numbers\n  first: (up 1 2)\n  second: 3"
                 (dot-product (up 1 2) 3))
  (check-message
   "dot-product: expected two tuples, or two numbers\n  first: '(1 2)\n  second: (up 1 2)"
   (dot-product '(1 2) (up 1 2))))

(test-case "the outer product never contracts"
  (check-equal? (outer-product (down 1 2) (up 3 4)) (up (down 3 6) (down 4 8)))
  (check-equal? (outer-product (up 1 2) (up 3 4)) (up (up 3 6) (up 4 8))))

(test-case "the cross product is perpendicular to its factors, and |a×b|² = |a|²|b|² - (a·b)²"
  (check-equal? (cross-product (up 1 0 0) (up 0 1 0)) (up 0 0 1))
  (with-seed 302
    (for ([_ 20])
      (define a ((random-up random-expression)))
      (define b ((random-up random-rational)))
      (define c (cross-product a b))
      (check-true (same? (dot-product a c) 0))
      (check-true (same? (dot-product b c) 0))
      (check-true (same? c (g:negate (cross-product b a))))
      (check-true (same? (g:square c)
                         (g:- (g:* (g:square a) (g:square b)) (g:square (dot-product a b)))))))
  (check-message "cross-product: expected two tuples of 3\n  first: (up 1 2 3)\n  second: (up 1 2)"
                 (cross-product (up 1 2 3) (up 1 2))))

(test-case "the Euclidean norm is the root of the square"
  (check-equal? (euclidean-norm (up 3 4)) 5)
  (check-equal? (euclidean-norm (down 1 2 2)) 3))

(test-case "products of functions that return tuples are functions"
  (define (e t) (up 1 t 0))
  (define (f t) (up 0 1 t))
  (check-equal? ((cross-product e f) 2) (cross-product (e 2) (f 2)))
  (check-equal? ((outer-product e f) 2) (outer-product (e 2) (f 2)))
  (check-equal? (format "~a" (cross-product e f)) "(cross-product e f)")
  (check-exn #rx"^cross-product: expected a tuple\n  given: the number 1"
             (lambda () (cross-product 1 e))))
