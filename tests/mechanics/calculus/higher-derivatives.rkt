#lang racket/base
;; Derivatives of higher order in one run: they agree with repeated derivatives.

(require mechanics/algebra/expression/expression
         mechanics/algebra/simplify/simplify-expression
         mechanics/generic/arithmetic
         mechanics/generic/compare
         mechanics/generic/elementary
         mechanics/generic/kind
         mechanics/generic/rounding
         mechanics/generic/up-down
         (only-in mechanics/compile/definite-integral definite-integral)
         mechanics/calculus/derivative
         mechanics/calculus/literal-function
         mechanics/value/compose
         mechanics/value/matrix/matrix
         mechanics/value/signature
         "../support/checks.rkt" "../support/random.rkt" "../support/same.rkt"
         "../support/laws/derivation.rkt" "../support/laws/law.rkt")

;; D repeated, which nests dual numbers: a plain function does not say that it is a
;; derivative.
(define (repeated n f)
  (for/fold ([f f]) ([_ (in-range n)])
    (define slope (D f))
    (lambda args (apply slope args))))
(define (check-orders f x [orders '(0 1 2 3 4 5)] [tolerance 1e-9])
  (for ([n (in-list orders)])
    (with-check-info (['order n] ['at x])
      (check-true (same? (((g:expt D n) f) x) ((repeated n f) x) tolerance)))))

(define-syntax-rule (check-same a b) (check-true (same? a b)))

;; ---------------------------------------------------------------------------
;; Every operation

(define (through op . others)
  (lambda (x) (apply (generic-op-procedure op) (g:+ 1/3 (g:/ (g:square x) 4)) others)))

(test-case "every operation of one argument"
  (for ([op (in-list elementary-operations)] #:when (= 1 (length (generic-op-partials op))))
    (with-check-info (['operation (generic-op-name op)])
      (define low (if (eq? (generic-op-name op) 'acosh) 2 0))
      (define (f x) ((through op) (g:+ low x)))
      (check-orders f 'a)
      (check-orders f 0.4 '(0 1 2 3 4 5 6) 1e-8))))

(test-case "every operation of two arguments, one of them constant or none"
  (for* ([op (in-list (append elementary-operations arithmetic-operations))]
         #:when (= 2 (length (generic-op-partials op)))
         [at (in-list (list 'a 0.7))])
    (with-check-info (['operation (generic-op-name op)])
      (define run (generic-op-procedure op))
      (check-orders (lambda (x) (run (g:sin x) (g:exp x))) at '(2 3 4))
      (check-orders (lambda (x) (run (g:exp x) 3/2)) at)
      (check-orders (lambda (x) (run (g:exp x) 'b)) at)
      (check-orders (lambda (x) (run 3/2 (g:exp x))) at)
      (check-orders (lambda (x) (run 'b (g:exp x))) at))))

(test-case "whole and broken powers, also where the base vanishes"
  (for* ([n (in-list '(1 2 3 4 7 1/2 3/2 -1 -2 0))] [x (in-list (list 'a 2 0.3))])
    (check-orders (lambda (x) (g:expt x n)) x))
  (check-equal? (for/list ([k 6]) (((g:expt D k) (lambda (x) (g:expt x 4))) 0)) '(0 0 0 0 24 0))
  (check-equal? (((g:expt D 2) (lambda (x) (g:expt x 7/2))) 0) 0)
  (check-equal? (((g:expt D 3) (lambda (x) (g:* x x x))) 'a) 6))

(test-case "roundings are constant"
  (check-equal? (((g:expt D 2) (lambda (x) (g:* (g:floor x) (g:square x)))) 2.5) 4.0)
  (check-equal? (((g:expt D 3) g:exact->inexact) 2) 0))

;; ---------------------------------------------------------------------------
;; Programs

(test-case "random functions, at every kind of scalar"
  (with-seed 501
    (for ([_ 30])
      (define f (random-function))
      (for ([x (list 'a (random-rational) (random-flonum))])
        (check-orders f x '(2 3 4) 1e-7)))))

(test-case "unknown functions, of functions of x"
  (define f (literal-function 'f))
  (define F (literal-function 'F (-> (X Real (UP Real Real)) Real)))
  (check-equal? (format "~a" (((g:expt D 12) f) 'x)) "(((expt D 12) f) x)")
  (for ([g (list f (lambda (x) (f (g:sin x))) (lambda (x) (f (f x)))
                 (lambda (x) (F x (up (g:square x) 'c))) (lambda (x) (F (f x) (up x (g:exp x)))))])
    (check-orders g 'x '(2 3 4))))

(test-case "the values may have any shape"
  (define (curve t) (up (g:cos t) (down (g:* t t) 1)))
  (check-same (((g:expt D 3) curve) 't) (up (g:sin 't) (down 0 0)))
  (check-same (((g:expt D 2) (lambda (t) (matrix-by-rows (list t (g:cube t)) (list 1 (g:exp t)))))
               't)
              (matrix-by-rows (list 0 (g:* 6 't)) (list 0 (g:exp 't))))
  (check-same ((((g:expt D 2) (lambda (x) (lambda (y) (g:* (g:cube x) y)))) 'x) 'y) (g:* 6 'x 'y))
  (check-same ((((g:expt D 3) (lambda (x) (up (lambda (y) (g:expt x y)) g:sin))) 'x) 3) (up 6 0)))

(test-case "by a structure, derivatives are repeated"
  (define (f s) (g:* (g:expt (s:ref s 0) 3) (g:square (s:ref s 1))))
  (define (s:ref s i) (vector-ref (structure-elements s) i))
  (check-same (((g:expt D 3) f) (up 'x 'y)) ((repeated 3 f) (up 'x 'y)))
  (check-same (((g:expt (partial 0) 3) f) (up 'x 'y)) (g:* 6 (g:square 'y)))
  (check-same (((g:expt (partial 1) 2) (lambda (x y) (g:* x (g:expt y 3)))) 'x 'y) (g:* 6 'x 'y))
  (check-same (((g:expt D 2) (lambda (x y) (g:* x (g:expt y 3)))) 'x 'y)
              ((repeated 2 (lambda (x y) (g:* x (g:expt y 3)))) 'x 'y)))

(test-case "loops and conditions see the value"
  (define (power x n) (if (g:= n 0) 1 (g:* x (power x (- n 1)))))
  (check-equal? (((g:expt D 3) (lambda (x) (power x 7))) 2) (* 7 6 5 16))
  (check-equal? (((g:expt D 2) (lambda (x) (if (g:< x 1) x (g:cube x)))) 2) 12)
  (check-equal? (((g:expt D 2) (lambda (x) (g:max x (g:cube x)))) 2) 12))

(test-case "integrals, of what is differentiated and up to it"
  (define (f x) (definite-integral (lambda (t) (g:* x x x t)) 0 2))
  (check-= (((g:expt D 2) f) 1.5) 18.0 1e-9)
  (define (F x) (definite-integral g:exp 0 (g:square x)))
  (check-= (((g:expt D 2) F) 0.5) (* 3 (exp 0.25)) 1e-9)
  (define (G x) (definite-integral (lambda (t) (g:* x t)) (g:* 2 x) (g:* 3 x)))
  (check-= (((g:expt D 3) G) 0.5) 15.0 1e-9))

;; ---------------------------------------------------------------------------
;; One run, small results

(test-case "the function is run once for a derivative of any order"
  (define runs 0)
  (define (f x) (set! runs (add1 runs)) (g:exp (g:sin x)))
  (((g:expt D 20) f) 0.3)
  (check-equal? runs 1)
  ((D (D (D f))) 0.3)
  (((g:expt D 2) ((g:expt D 3) f)) 0.3)
  (check-equal? runs 3))

(test-case "derivatives of derivatives are of higher order, whatever they print as"
  (define f (literal-function 'f))
  (define F (literal-function 'F (-> (X Real Real) Real)))
  (check-equal? (format "~a" (D (D f))) "(D (D f))")
  (check-equal? (format "~a" ((g:expt D 2) (D f))) "((expt D 2) (D f))")
  (check-same ((D (D (D f))) 'x) (((g:expt D 3) f) 'x))
  (check-same (((partial 0) ((partial 0) F)) 'x 'y) (((g:expt (partial 0) 2) F) 'x 'y))
  (check-same (((partial 0) ((partial 1) F)) 'x 'y) (((partial 1) ((partial 0) F)) 'x 'y))
  (check-same ((D (D F)) 'x 'y) (((g:expt D 2) F) 'x 'y)))

(test-case "a list of derivatives is that of each, of values of any shape"
  (define (orders f x) (for/list ([k 4]) (((g:expt D k) f) x)))
  (for ([f (list g:sin (lambda (t) (up (g:cube t) (down t 1))) (lambda (t) 3))] [x '(t 2 0.5)])
    (check-true (andmap same? (derivatives-at f x 3) (orders f x))))
  (check-true (andmap (lambda (f g) (same? (f 'y) (g 'y)))
                      (derivatives-at (lambda (x) (lambda (y) (g:* x x y))) 'x 2)
                      (list (lambda (y) (g:* 'x 'x y))
                            (lambda (y) (g:* 2 'x y))
                            (lambda (y) (g:* 2 y)))))
  (check-equal? ((car (derivatives-at (lambda (x) (lambda (y) (g:* x y))) 2 1)) 3) 6)
  (define s (up 'x 'y))
  (check-same (caddr (derivatives-at g:square s 2)) (((g:expt D 2) g:square) s)))

(define (node-count e)
  (define seen (make-hasheq))
  (let walk ([e e])
    (when (and (node? e) (not (hash-ref seen e #f)))
      (hash-set! seen e #t)
      (for-each walk (node-args e))))
  (hash-count seen))

(test-case "symbolic results grow with the square of the order"
  (define (f x) (g:/ (g:exp (g:sin x)) (g:+ 1 (g:square x))))
  (for ([n (in-list '(5 10 20))])
    (check-true (< (node-count (((g:expt D n) f) 'x)) (* 30 n n)))))

(test-case "simplified they are what repeated derivatives are"
  (for ([f (list g:tan (lambda (x) (g:/ (g:sin x) x)) (lambda (x) (g:sqrt (g:+ 1 (g:square x))))
                 (lambda (x) (g:expt x 'n)) (lambda (x) (g:exp (g:/ -1 x)))
                 (lambda (x) (g:* (g:log x) ((literal-function 'f) x))))])
    (for ([n '(2 3)])
      (check-equal? (simplify-expression (((g:expt D n) f) 'x))
                    (simplify-expression ((repeated n f) 'x))))))

;; ---------------------------------------------------------------------------
;; Nesting

(test-case "derivatives nest with derivatives of any order, and are not confused"
  (define D2 (g:expt D 2))
  (define D3 (g:expt D 3))
  (check-same (D (D2 g:sin)) (g:negate g:cos))
  (check-same (D2 (D3 g:sin)) g:cos)
  (check-same (D2 (lambda (x) (g:* x ((D2 (lambda (y) (g:* x (g:cube y)))) 2)))) 24)
  (check-same (D3 (lambda (x) (g:* (g:square x) ((D (lambda (y) (g:* x y))) 1)))) 6)
  (check-same (D (lambda (x) ((D2 (lambda (y) (g:* x x y y))) x))) (g:* 4 identity))
  (check-equal? (((D2 (lambda (x) (lambda (y) ((D2 (lambda (z) (g:* x x y y z z))) 1)))) 3) 5) 100))

(define (shift x) (lambda (f) (lambda (y) (f (g:+ x y)))))

(test-case "the derivative of a shift, applied to itself, for orders two and three"
  ;; Manzyuk et al., arXiv:1211.4892, section 3, with higher derivatives
  (define second-derivative (((g:expt D 2) shift) 0))
  (define third-derivative (((g:expt D 3) shift) 0))
  (define (f x) (g:expt x 8))
  (check-equal? ((second-derivative f) 1) 56)
  (check-equal? ((second-derivative (second-derivative f)) 1) (* 8 7 6 5))
  (check-equal? ((third-derivative (second-derivative f)) 1) (* 8 7 6 5 4)))

(test-case "singular points are refused as they are by D"
  (for ([f (list g:sqrt g:log (lambda (x) (g:/ 1 x)) g:abs
                 (lambda (x) (g:sqrt (g:* x x x x))) (lambda (x) (g:expt x 3/2)))]
        [message '(#rx"^sqrt: has no derivative at 0$" #rx"^log: the logarithm of 0 has no value$"
                   #rx"^/: division by zero$" #rx"^abs: has no derivative at 0$"
                   #rx"^sqrt: has no derivative at 0$" #rx"^expt: has no derivative at 0, 1/2$")])
    (check-exn message (lambda () (((g:expt D 2) f) 0)))))

;; ---------------------------------------------------------------------------
;; Laws

(define (D-by-Taylor f)                 ; the derivative, read off a second one
  (lambda (x) (((g:expt D 2) (lambda (y) (g:* y (f (g:+ x (g:/ y 2)))))) 0)))

(check-laws "derivatives read off second derivatives" derivation-laws
            (derivation D-by-Taylor (lambda (i f) ((partial i) f)))
            (draw-functions random-flonum (lambda () (random-function 2))) (close-to 1e-6)
              #:seed 502)
