#lang racket/base
;; Structures as data: construction, application, products, printing.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/generic/up-down
         mechanics/calculus/literal-function
         "../support/checks.rkt")

(define (printed x) (list (format "~s" x) (format "~a" x) (format "~v" x)))

;; ---------------------------------------------------------------------------
;; Data

(test-case "tuples of any length"
  (for ([n 6])
    (define xs (for/list ([i n]) i))
    (check-equal? (vector->list (structure-elements (apply up xs))) xs)
    (check-equal? (vector->list (structure-elements (apply down xs))) xs)
    (check-equal? (structure-length (apply up xs)) n)))

(test-case "orientation, and vectors that count as up"
  (check-true (up? (up 1)))
  (check-true (up? (vector 1)))
  (check-false (up? (down 1)))
  (check-true (down? (down 1)))
  (check-false (down? (vector 1)))
  (for ([x (list 1 'a '(1) sin "s")])
    (check-false (up? x))
    (check-false (down? x))
    (check-false (tuple? x)))
  (check-equal? (adopt (vector 1 2)) (up 1 2)))

(test-case "a tuple made from a vector does not change with it"
  (define v (vector 1 2))
  (define s (vector->up v))
  (define t (vector->down v))
  (vector-set! v 0 'changed)
  (check-equal? s (up 1 2))
  (check-equal? t (down 1 2)))

(test-case "a tuple prints as the expression that makes it, in all three modes"
  (check-equal? (printed (up 't (down 1/2 'x) (vector 1 2.5)))
                '("(up t (down 1/2 x) (up 1 2.5))" "(up t (down 1/2 x) (up 1 2.5))"
                  "(up t (down 1/2 x) (up 1 2.5))"))
  (check-equal? (format "~s" (list (up 'a) (up))) "((up a) (up))")
  (check-equal? (format "~v" (list (up 'a))) "(list (up a))")
  (check-equal? (format "~s" (up sin (lambda (x) x))) "(up sin <function>)"))

;; ---------------------------------------------------------------------------
;; Application

(test-case "a tuple of functions is a function to tuples"
  (check-equal? ((up (literal-function 'x) (literal-function 'y)) 't)
                (up ((literal-function 'x) 't) ((literal-function 'y) 't)))
  (check-equal? ((up g:sin (down g:cos g:exp)) 0) (up 0 (down 1 1)))
  (check-equal? ((up g:+ g:*) 2 3) (up 5 6)))

(test-case "a component that is no function is named when the tuple is applied"
  (check-exn
   #rx"^application: a tuple applies its components to the arguments, but the component 3 of [(]up 3 sin[)] is not a function; [(]constant-function 3[)] makes a function of it\n  a component is [(]ref s 0[)]$"
   (lambda () ((up 3 g:sin) 0)))
  (check-exn
   #rx"but the component x of [(]down x[)] is not a function; [(]literal-function 'x[)] makes a function of it$"
   (lambda () ((down 'x)))))

;; ---------------------------------------------------------------------------
;; Products (SICM p. 515)

(test-case "opposite orientations of one shape contract"
  (check-equal? (g:* (up 1 2 3) (down 4 5 6)) 32)
  (check-equal? (g:* (down (up 1 2) (up 3 4)) (up (down 5 6) (down 7 8))) 70)
  (check-equal? (g:* (down 'a 'b) (vector 'x 'y)) (g:+ (g:* 'a 'x) (g:* 'b 'y)))
  (check-equal? (g:* (up) (down)) 0))

(test-case "a linear map is a tuple of its columns"
  (define columns (down (up 'a 'c) (up 'b 'd)))
  (check-equal? (g:* columns (up 'x 'y))
                (up (g:+ (g:* 'a 'x) (g:* 'b 'y)) (g:+ (g:* 'c 'x) (g:* 'd 'y)))))

(test-case "otherwise the left factor multiplies each component of the right one"
  (check-equal? (g:* (up 1 2) (up 3 4 5)) (up (up 3 6) (up 4 8) (up 5 10)))
  (check-equal? (g:* (down 1 2) (down 3 4)) (down (down 3 6) (down 4 8)))
  (check-equal? (g:* (up (up 1 2) 3) (down (up 4 5) 6))
                (down (g:* (up (up 1 2) 3) (up 4 5)) (g:* (up (up 1 2) 3) 6))))

(test-case "an up and a down tuple of unequal lengths: the book's product, or on request an error"
  (define (product) (g:* (down 1 2) (up 1 2 3)))
  (check-equal? (product) (up (down 1 2) (down 2 4) (down 3 6)))
  (parameterize ([unequal-contraction 'error])
    (check-exn
     #rx"^[*]: cannot multiply a down tuple of 2 by an up tuple of 3\n.*\n.*\n  their lengths differ$"
     product)
    (check-equal? (g:* (up 1 2) (up 1 2 3)) (up (up 1 2) (up 2 4) (up 3 6)))
    (check-equal? (g:* (down 1 2) (up (up 1 2) (up 1 2) (up 1 2)))
                  (up (g:* (down 1 2) (up 1 2)) 5 5)))
  (check-exn #rx"^unequal-contraction: expected 'outer-product or 'error"
             (lambda () (unequal-contraction 'sometimes))))

;; ---------------------------------------------------------------------------
;; Contraction

(test-case "tuples of flonums contract as tuples of other numbers do"
  (for ([n (in-range 1 6)])
    (define xs (for/list ([k n]) (/ (+ 1.0 k) 8)))
    (define ys (for/list ([k n]) (- 2.0 (/ k 4))))
    (define exact (for/sum ([x xs] [y ys]) (* (inexact->exact x) (inexact->exact y))))
    (for ([a (list up down)] [b (list down up)])
      (check-equal? (g:* (apply a xs) (apply b ys)) (exact->inexact exact))
      (check-equal? (g:* (apply a (map inexact->exact xs)) (apply b (map inexact->exact ys))) exact)
      (check-equal? (g:* (apply a xs) (apply b (map inexact->exact ys))) (exact->inexact exact)))))

(test-case "one component that is no flonum, wherever it stands"
  (for ([k 3])
    (define mixed (for/list ([i 3]) (if (= i k) 'x 2.0)))
    (check-equal? (format "~a" (g:* (apply up mixed) (down 0 0 0))) "0")
    (check-equal? (g:* (apply down mixed) (apply up (for/list ([i 3]) (if (= i k) 3.0 0))))
                  (g:* 'x 3.0)))
  (check-equal? (g:* (up 1.0 2.0) (down (up 1.0 2.0) (up 3.0 4.0))) (up 7.0 10.0)))

(test-case "no zero is made negative or positive"
  (check-equal? (g:* (up -0.0) (down 1.0)) -0.0)
  (check-equal? (g:* (up) (down)) 0))
