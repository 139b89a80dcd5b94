#lang racket/base
;; Perturbation confusion: every published example we know of, and our own.
;;
;; References: [SP] Siskind and Pearlmutter 2005, "Perturbation confusion and
;; referential transparency"; [M] Manzyuk, Pearlmutter, Radul, Rush and Siskind,
;; arXiv:1211.4892, "Perturbation confusion in forward automatic differentiation
;; of higher-order functions"; [DVL] the examples that go with it; [E] public
;; threads of Emmy on derivatives that return functions.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/value/compose
         mechanics/value/operator
         mechanics/value/structure
         mechanics/value/signature
         mechanics/calculus/derivative
         mechanics/calculus/literal-function
         "../support/checks.rkt" "../support/same.rkt")

(define e (exp 1.0))

;; ---------------------------------------------------------------------------
;; Nested derivatives of functions of numbers

(test-case "[SP] d/dx (x · d/dy (x + y)) at 1, 1 is 1, not 2"
  (check-equal? ((D (lambda (x) (g:* x ((D (lambda (y) (g:+ x y))) 1)))) 1) 1))

(test-case "[SP] variants: the inner derivative is 1, whatever is done with it"
  (define (one x) ((D (lambda (y) (g:+ x y))) 3))
  (check-equal? ((D one) 'x) 0)
  (check-equal? ((D (lambda (x) (g:* x (one x)))) 'x) 1)
  (check-equal? ((D (lambda (x) (g:* x (one (g:* 2 x))))) 'x) 1))

(test-case "[DVL] d/dx of d/dy (y²x) at y = 3x is 12x"
  (check-same ((D (lambda (x) ((D (lambda (y) (g:* y (g:* y x)))) (g:* x 3)))) 'x)
              (g:* 12 'x)))

(test-case "the same variable twice: d/dx (x · d/dx x²) is 4x"
  (check-same ((D (lambda (x) (g:* x ((D g:square) x)))) 'x) (g:* 4 'x)))

(test-case "three and four levels, each variable used at each level"
  ;; ∂³/∂x∂y∂z of xyz + x²y²z² at one point = 1 + 8xyz
  (define (f x y z) (g:+ (g:* x y z) (g:square (g:* x y z))))
  (check-same ((D (lambda (x) ((D (lambda (y) ((D (lambda (z) (f x y z))) 'c))) 'b))) 'a)
              (g:+ 1 (g:* 8 'a 'b 'c)))
  (define (inner w x) ((D (lambda (y) ((D (lambda (z) (g:* w x y z))) 2))) 3))
  (check-equal? ((D (lambda (w) ((D (lambda (x) (inner w x))) 5))) 7) 1))

(test-case "the derivative of a derivative at a moving point"
  ;; g(x) = f'(x²), so g'(x) = 2x f''(x²)
  (check-same ((D (lambda (x) ((D g:sin) (g:square x)))) 'x)
              (g:* -2 'x (g:sin (g:square 'x)))))

(test-case "a square root by Newton's method has two derivatives"
  (define (root x)
    (let loop ([y 1.0] [n 0])
      (if (= n 8) y (loop (g:- y (g:/ (g:- (g:square y) x) (g:* 2 y))) (add1 n)))))
  (check-same ((D root) 4) 1/4)
  (check-same (((g:expt D 2) root) 4) -1/32)
  (check-same (((g:expt D 3) root) 4) 3/256))

;; ---------------------------------------------------------------------------
;; Functions that return functions

;; [M] the shift: s(u)(f)(x) = f(x + u), so that D̂ = (D s)(u) differentiates.
(define (((shift u) f) x) (f (g:+ x u)))

(test-case "[M] the derivative of the shift at 0 is the derivative, once, twice and thrice"
  (define D-hat ((D shift) 0))
  (define V (literal-function 'V))
  (check-equal? ((D-hat V) 't) ((D V) 't))
  (check-equal? ((D-hat (D-hat V)) 't) (((g:expt D 2) V) 't))
  (check-equal? ((D-hat (D-hat (D-hat V))) 't) (((g:expt D 3) V) 't))
  (check-same ((D-hat (D-hat g:exp)) 1) e))

(test-case "[E] away from 0: each application shifts by 3 and differentiates"
  (define f-hat ((D shift) 3))
  (check-same ((f-hat g:exp) 5) (exp 8.0))
  (check-same ((f-hat (f-hat g:exp)) 5) (exp 11.0))
  (check-same ((f-hat (f-hat (f-hat g:exp))) 1) (exp 10.0)))

(test-case "[M] it is no matter whether D̂ is named or written out twice"
  (define V (literal-function 'V))
  (check-equal? ((((D shift) 0) (((D shift) 0) V)) 't) (((g:expt D 2) V) 't)))

(test-case "[M] uncurried by hand, the derivative by the first argument is the same"
  (define V (literal-function 'V))
  (define ((direct f) x) ((D (lambda (u) (((shift u) f) x))) 0))
  (check-equal? ((direct (direct V)) 't) (((g:expt D 2) V) 't)))

(test-case "[M] a function that takes D̂ of itself as an argument"
  ;; v(u)(f₁)(f₂)(x) = f₁(f₂)(x + u)
  (define ((((v u) f1) f2) x) ((f1 f2) (g:+ x u)))
  (define v-hat ((D v) 0))
  (check-same (((v-hat (v-hat identity)) g:exp) 1) e)
  (check-same (((v-hat (v-hat (v-hat identity))) g:exp) 1) e))

(test-case "[M] numbers boxed as Church boxes"
  (define ((box x) m) (m x))
  (define (unbox b) (b (lambda (x) x)))
  (define ((wrap f) x) (box (f (unbox x))))
  (define ((unwrap f) x) (unbox (f (box x))))
  (define (((wrap2 f) g) x) (box ((f (unwrap g)) (unbox x))))
  (define D-hat ((D (lambda (u) (wrap2 (shift u)))) 0))
  (check-same ((unwrap (D-hat (wrap g:exp))) 1) e)
  (check-same ((unwrap (D-hat (D-hat (wrap g:exp)))) 1) e))

(test-case "[E] two functions handed to a continuation share the variable"
  (define a (literal-function 'a (-> (X Real Real) Real)))
  (define ((f x) continue)
    (continue (lambda (y) (a x y)) (lambda (g) (g x))))
  (check-equal? (((D f) 't) (lambda (f1 f2) (f1 't))) (((partial 0) a) 't 't))
  (check-equal? (((D f) 't) (lambda (f1 f2) (f2 g:sin))) (g:cos 't))
  (check-same (((D f) 't) (lambda (f1 f2) (f2 f1))) ((D (lambda (t) (a t t))) 't))
  (define ((product x) continue) (continue (lambda (y) (g:* x y)) (lambda (g) (g x))))
  (check-equal? (((D product) 5) (lambda (f1 f2) (f2 f1))) 10))

(test-case "[E] two functions in a tuple do not"
  (define a (literal-function 'a (-> (X Real Real) Real)))
  (define (f x) (up (lambda (y) (a x y)) (lambda (g) (g x))))
  (define pair ((D f) 't))
  (check-equal? ((ref pair 1) (ref pair 0)) (((g:* (partial 0) (partial 1)) a) 't 't)))

(test-case "[DVL] a pair of functions, one applied to the other"
  (define (f x) (up (lambda (y) (g:sin (g:* x y))) (lambda (g) (lambda (z) (g (g:+ x z))))))
  (define pair ((D f) 3))
  (check-= (((ref pair 1) (ref pair 0)) 3.14159) 8.504448924508122 1e-12))

(test-case "[DVL] the same with a Church pair, which shares the variable"
  (define ((f x) recipient)
    (recipient (lambda (y) (g:sin (g:* x y))) (lambda (g) (lambda (z) (g (g:+ x z))))))
  (define (apply-second-to-first g f) ((f g) 3.14159))
  (check-= (((D f) 3) apply-second-to-first) 8.32914929893078 1e-12)
  ;; the arguments in the other order: the derivative of a number
  (check-= ((D (lambda (x) ((f x) apply-second-to-first))) 3) 8.32914929893078 1e-12))

(test-case "[DVL] a result handed to a continuation, and the derivative either way"
  (define (((church-output f) x) recipient) (recipient (f x)))
  (define (((flip f) x) y) ((f y) x))
  (define (continue x) (g:* x x))
  (define expected (* 2 (sin 1.0) (cos 1.0)))
  (check-= (continue ((D g:sin) 1.0)) (expt (cos 1.0) 2) 1e-15)
  (check-= (((D (church-output g:sin)) 1.0) continue) expected 1e-15)
  (check-= ((D ((flip (church-output g:sin)) continue)) 1.0) expected 1e-15))

(test-case "[DVL] a directional derivative over Church pairs"
  (define (c-cons a d) (lambda (recipient) (recipient a d)))
  (define (c-car c) (c (lambda (a d) a)))
  (define (c-cdr c) (c (lambda (a d) d)))
  (define (f point) (c-cons (g:+ (c-car point) (c-cdr point)) (g:* (c-car point) (c-cdr point))))
  (define line (lambda (s) (f (c-cons (g:+ 7 (g:* s 2)) (g:+ 11 (g:* s 3))))))
  (check-equal? (((D line) 0) up) (up 5 43)))

;; ---------------------------------------------------------------------------
;; The argument carries the perturbation that is being extracted

;; h ↦ h'(3)
(define slope-at-3 ((D (lambda (x) (lambda (h) (h x)))) 3))

(test-case "applied within itself, whatever kind of function carries the inner variable"
  (define expected (cos 3))               ; ∂²/∂x∂y (x sin y) at 3, 3
  (for ([inner (list (lambda (x) (lambda (y) (g:* x (g:sin y))))
                     (lambda (x) (g:* x g:sin))
                     (lambda (x) (compose (lambda (s) (g:* x s)) g:sin))
                     (lambda (x) ((g:* x I-operator) g:sin))
                     (lambda (x) (ref (lambda (y) (up 0 (g:* x (g:sin y)))) 1)))])
    (check-same (slope-at-3 (lambda (x) (slope-at-3 (inner x)))) expected)))

(test-case "a tuple of functions, or a list of them, carries it as well"
  ;; (c, h) ↦ c h'(3), within itself: d/dy (y² cos 3) = 6 cos 3
  (define at-3 ((D (lambda (x) (lambda (s) (g:* (ref s 0) ((ref s 1) x))))) 3))
  (check-same (at-3 (up 1 (lambda (y) (at-3 (up y (g:* y g:sin)))))) (* 6 (cos 3)))
  (define at-3-of-list ((D (lambda (x) (lambda (s) (g:* (car s) ((cadr s) x))))) 3))
  (check-same (at-3-of-list (list 1 (lambda (y) (at-3-of-list (list y (g:* y g:sin))))))
              (* 6 (cos 3))))

(test-case "a number that carries it comes back with it"
  ;; (x, y) ↦ x y curried; the outer derivative is by the inner argument
  (define times ((D (lambda (x) (lambda (y) (g:* x y)))) 3))
  (check-equal? ((D times) 5) 1)
  (check-equal? (slope-at-3 times) 1)
  (check-equal? (slope-at-3 (lambda (y) (g:* y (times y)))) 6))

(test-case "operators as values: the derivative of x ↦ x D"
  (define xD ((D (lambda (x) (g:* x D))) 3))
  (check-pred operator? xD)
  (check-same xD D)
  (check-same ((g:* xD xD) g:exp) g:exp)
  (check-same ((D (lambda (x) (g:* (g:square x) (g:expt D 2)))) 'a) (g:* 2 'a (g:expt D 2))))

(test-case "closures made in different runs keep their variables apart"
  (define (curried-product x) (lambda (y) (lambda (z) (g:* x y z))))
  (check-equal? ((((D curried-product) 2) 3) 5) 15)
  (check-equal? (((D ((D curried-product) 2)) 3) 5) 5)
  (check-equal? ((D ((D ((D curried-product) 2)) 3)) 5) 1))

(test-case "functions of functions of tuples: a variation within a variation"
  (define (((vary eta) f) q)
    ((D (lambda (epsilon) (f (g:+ q (g:* epsilon eta))))) 0))
  (define q (literal-function 'q))
  (define eta (literal-function 'eta))
  (define zeta (literal-function 'zeta))
  (define (f q) (lambda (t) (g:cube (q t))))
  (check-same ((((vary eta) f) q) 't)
              (g:* 3 (g:square (q 't)) (eta 't)))
  (check-same ((((vary zeta) ((vary eta) f)) q) 't)
              (g:* 6 (q 't) (eta 't) (zeta 't)))
  (check-same ((((vary eta) ((vary eta) f)) q) 't)
              (g:* 6 (q 't) (eta 't) (eta 't))))
