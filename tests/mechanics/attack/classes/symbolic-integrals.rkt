#lang racket/base
;; Integrals with symbols: formulas the library finds, their derivatives, and formulas F(high) −
;; F(low) put to it, most of which hold only where no cut lies between the ends.  Some are of
;; integrands of which it finds no antiderivative but in the claim, and hold jumps and gaps.

(require "../disguise.rkt" "../judge/number.rkt" "../judge/point.rkt"
         "../statement.rkt" "../template.rkt")

(provide symbolic-integrals)

(define (symbolic-integrals)
  (define-values (e F) (if (chance 6) (random-unknown) (random-integrand)))
  (define-values (low high) (random-ends))
  (define difference (and F `(- ,(substituted F 'x high) ,(substituted F 'x low))))
  (define claim (and F (chance 2) (not (holds-no-value? difference)) difference))
  (define by (and (not claim) (chance 4) (pick '(a b))))
  (define f `(lambda (x) ,(quoted-symbols e '(x))))
  (define-values (from to) (values (quoted-symbols low '()) (quoted-symbols high '())))
  (inquiry (cond [claim `(verify-integral ,f ,from ,to ,(quoted-symbols claim '()))]
                 [by `((D (lambda (,by)
                            (definite-integral (lambda (x) ,(quoted-symbols e `(x ,by)))
                                               ,(quoted-symbols low (list by))
                                               ,(quoted-symbols high (list by)))))
                       ',by)]
                 [else `(definite-integral ,f ,from ,to)])
           `(integral ,e ,low ,high ,by ,claim)))

;; Has a part of it, of numbers alone, no value?  The claim would be the user's mistake.
(define (holds-no-value? e)
  (and (pair? e)
       (or (and (null? (symbols-of e)) (eq? 'none (number-at e (hasheq))))
           (ormap holds-no-value? (cdr e)))))

;; Cuts lie between them for some values of the symbols.
(define (random-ends)
  (define ends
    (pick '((0 b) (a b) ((- a) a) (-1 1) (0 1) (0 2) (-1 b) (1 b) (1/2 b) (0 3) (b (* 2 b))
            ((- b) b) (2 (* 3 b)) (0 (+ a b)) (-2 a))))
  (if (chance 5) (values (cadr ends) (car ends)) (values (car ends) (cadr ends))))

;; -> an integrand and, of some, an antiderivative between cuts, or #f.  The symbol c is a factor,
;; so that there always is one; x may be replaced by a line.
(define (random-integrand)
  (define pair (filled (pick integrands)
                       `((a . ,(pick '(a a a a 2 -1 1/2 (+ a 1) (square a)))))))
  (define line (pick '(x x x x x x x (- x) (* 2 x) (+ x a) (- 1 x) (* b x))))
  (define slope (case line [((- x) (- 1 x)) -1] [((* 2 x)) 2] [((* b x)) 'b] [else 1]))
  (define (placed e) (substituted e 'x line))
  (define e `(* c ,(placed (car pair))))
  (values (if (chance 8) (disguise-once e) e)
          (and (pair? (cdr pair)) `(* c (/ ,(placed (pick (cdr pair))) ,slope)))))

;; The derivative of x e^(sin x) is that of no table.
(define (random-unknown)
  (define-values (e F) (random-integrand))
  (define known? (and F (chance 2)))
  (define jump (if (chance 2) 0 (substituted (pick jumps) 'x (pick '(x x (- x 1) (+ x a) (- x a))))))
  (define hidden '(* (+ 1 (* x (cos x))) (exp (sin x))))
  (values (if known? `(+ ,e ,hidden) hidden)
          `(+ (* x (exp (sin x))) ,jump ,@(if known? (list F) '()))))

;; Each is constant beside some places, or where it has a value
(define jumps
  '((square (sgn x)) (sgn x) (* (square (sgn x)) (sgn (* 2 x))) (sgn (abs x)) (atan 0 x)
    (- (abs (+ x 1/2)) (abs (- x 1/2))) (- (atan (tan x)) x) (+ (atan x) (atan (/ 1 x)))
    (/ (abs x) x) (* (abs x) (sgn x) (/ 1 x)) (- (acosh (cosh x)) x)
    (* (sqrt (- (square x) 1)) (- (square (cosh x)) 1 (square (sinh x))) (sgn x))
    (+ (- (abs (+ x 1/2)) (abs (- x 1/2))) (* (sqrt (- (square x) 1)) (- 1 (square (sin x)) (square (cos x)))))
    (- (log (abs x)) (* 1/2 (log (square x)))) (- (asin (sin x)) x) (sgn (- (square x) 1))))

;; (integrand antiderivative ...), right ones or nearly
(define integrands
  '(((/ 1 (- x a)) (log (abs (- x a))) (log (- x a)) (* 1/2 (log (square (- x a)))))
    ((/ 1 x) (log (abs x)) (log (* 2 x)) (log (square x))) ((/ 1 (square (- x a))) (/ 1 (- a x)))
    ((expt (- x a) -3) (/ -1/2 (square (- x a))))
    ((/ 1 (* (- x a) (- x b))) (/ (log (abs (/ (- x a) (- x b)))) (- a b)))
    ((/ x (- (square x) (square a))) (* 1/2 (log (abs (- (square x) (square a))))))
    ((/ (* 2 x) (square (- (square x) b))) (/ 1 (- b (square x)))) ((/ 1 (- (square x) b)))
    ((/ 1 (+ (square x) (square a))) (/ (atan (/ x a)) a) (/ (atan x a) a)
                                     (/ (- (atan (/ a x))) a))
    ((/ (+ x b) (+ (square x) (* 2 x) a))) ((/ 1 (* x (- x a)))) ((sqrt (+ (square x) (* a x))))
    ((/ 1 (sqrt (+ a (* b x) (square x))))) ((/ 1 (sqrt (- (* a x) (square x)))))
    ((/ x (expt (+ a (square x)) 3/2))) ((/ (square x) (sqrt (- a (square x)))))
    ((* (exp (* a x)) (sin (* b x)))) ((/ (cos x) (+ a (sin x)))) ((/ (sin x) (+ 1/2 (cos x))))
    ((tan (* a x)) (/ (log (abs (cos (* a x)))) (- a))) ((tanh (- x a))) ((/ (cosh x) (sinh x)))
    ((/ (exp x) (- (exp x) a)) (log (abs (- (exp x) a)))) ((/ 1 (square (+ a (* b x)))))
    ((/ (* x a) (- (expt x 4) b))) ((* x (cos (* x (square a))))) ((/ 1 (* x (square (- x a)))))
    ((/ 1 (+ (square x) (* a x) 1))) ((/ 1 (+ (square x) (* -2 a x) (square a))) (/ 1 (- a x)))
    ((/ x (+ a (* b x)))) ((/ 1 (- 1 (expt x 4))) (* 1/2 (+ (atan x) (atanh x))))
    ((/ 1 (- 1 (cube x)))) ((expt x n) (/ (expt x (+ n 1)) (+ n 1)))
    ((expt (- x a) 1/3) (* 3/4 (expt (- x a) 4/3)))
    ((sqrt (square (- x a))) (* 1/2 (square (- x a))) (* 1/2 (- x a) (abs (- x a))))
    ((abs (- x a)) (* 1/2 (- x a) (abs (- x a))) (* 1/2 (square (- x a))))
    ((sgn (- x a)) (abs (- x a)) (sqrt (square (- x a))) (- x a))
    ((sqrt (+ (square x) (expt x 4))) (* 1/3 (expt (+ 1 (square x)) 3/2)))
    ((sqrt (expt (- x a) 4)) (* 1/3 (cube (- x a)))) ((/ x (sqrt (square x))) (abs x) x)
    ((sqrt (- (square a) (square x))) (* 1/2 (+ (* x (sqrt (- (square a) (square x)))) (* (square
     a) (asin (/ x a))))))
    ((/ 1 (sqrt (- (square a) (square x)))) (asin (/ x a)) (- (acos (/ x a))) (atan x (sqrt (-
     (square a) (square x)))))
    ((/ 1 (sqrt (+ (square x) a))) (log (+ x (sqrt (+ (square x) a)))))
    ((/ 1 (sqrt (- (square x) 1))) (acosh x) (log (abs (+ x (sqrt (- (square x) 1))))))
    ((/ 1 (* x (sqrt (- (square x) 1)))) (atan (sqrt (- (square x) 1))) (acos (/ 1 x)))
    ((/ 1 (sqrt (- x a))) (* 2 (sqrt (- x a))))
    ((* x (sqrt (+ a x))) (* 2/15 (- (* 3 x) (* 2 a)) (expt (+ a x) 3/2))) ((/ (sqrt x) (- x a)))
    ((tan x) (- (log (abs (cos x)))) (log (sqrt (+ 1 (square (tan x))))))
    ((/ 1 (square (cos x))) (tan x))
    ((/ 1 (square (sin x))) (/ -1 (tan x)) (- (/ (cos x) (sin x))))
    ((/ 1 (+ 2 (cos x))) (* (/ 2 (sqrt 3)) (atan (/ (tan (/ x 2)) (sqrt 3)))))
    ((/ 1 (+ 1 (cos x))) (tan (/ x 2))) ((/ 1 (- 1 (sin x))) (tan (+ (/ x 2) (/ :pi 4))))
    ((/ 1 (+ 5 (* 4 (sin x)))) (* 2/3 (atan (/ (+ 4 (* 5 (tan (/ x 2)))) 3))))
    ((/ 1 (+ a (cos x)))) ((/ 1 (+ 1 (square (sin x)))) (/ (atan (* (sqrt 2) (tan x))) (sqrt 2)))
    ((/ 1 (+ (square (* a (cos x))) (square (* b (sin x))))) (/ (atan (/ (* b (tan x)) a)) (* a
     b)))
    ((/ 1 (cos x)) (log (abs (tan (+ (/ x 2) (/ :pi 4))))) (atanh (sin x)) (asinh (tan x)))
    ((/ (sin x) (cube (cos x))) (/ 1/2 (square (cos x))) (* 1/2 (square (tan x))))
    ((sqrt (square (sin x))) (- (cos x))) ((sqrt (- 1 (square (sin x)))) (sin x))
    ((sqrt (- 1 (cos x))) (* -2 (sqrt (+ 1 (cos x)))) (* -2 (sqrt 2) (cos (/ x 2))))
    ((sqrt (- (* 1/2 (cosh (* 2 x))) 1/2)) (cosh x))
    ((/ (cos x) (sqrt (- 1 (square (sin x))))) x (asin (sin x)))
    ((* (sin (* a x)) (sin (* b x))) (* 1/2 (- (/ (sin (* (- a b) x)) (- a b)) (/ (sin (* (+ a b)
     x)) (+ a b)))))
    ((atan (tan x)) (* 1/2 (square x)) (* 1/2 (square (atan (tan x)))))
    ((asin (sin x)) (* 1/2 (square x))) ((acosh (cosh x)) (* 1/2 (square x)))
    ((atan (/ 1 x)) (+ (* x (atan (/ 1 x))) (* 1/2 (log (+ 1 (square x))))))
    ((atan (/ x a)) (- (* x (atan (/ x a))) (* 1/2 a (log (+ (square a) (square x))))))
    ((exp (* a x)) (/ (exp (* a x)) a))
    ((* x (exp (* a x))) (/ (* (- (* a x) 1) (exp (* a x))) (square a)))
    ((/ 1 (- (exp x) 1)) (- (log (abs (- (exp x) 1))) x)) ((/ 1 (- a (exp x))))
    ((/ 1 (+ 1 (exp x))) (- x (log (+ 1 (exp x))))) ((/ 1 (sinh x)) (log (abs (tanh (/ x 2)))))
    ((/ 1 (square (sinh x))) (/ -1 (tanh x)))
    ((/ (exp x) (square (- (exp x) a))) (/ 1 (- a (exp x))))
    ((exp (abs x)) (* (sgn x) (exp (abs x))) (* (sgn x) (- (exp (abs x)) 1)))
    ((/ (exp (/ 1 x)) (square x)) (- (exp (/ 1 x))))
    ((/ (exp (/ 1 x)) (* (square x) (square (+ 1 (exp (/ 1 x)))))) (/ 1 (+ 1 (exp (/ 1 x)))))
    ((log (square x)) (- (* x (log (square x))) (* 2 x)))
    ((log (abs (- x a))) (- (* (- x a) (log (abs (- x a)))) x))
    ((/ 1 (* x (log x))) (log (abs (log x))) (log (log x)))
    ((/ (log x) x) (* 1/2 (square (log x))))
    ;; sides of a kink
    ((* x (abs (- x a))) (* (sgn (- x a)) (+ (/ (cube x) 3) (* -1/2 a (square x)) (/ (cube a) 6)))
                         (* (sgn (- x a)) (+ (/ (cube x) 3) (* -1/2 a (square x)))))
    ((* (abs x) (exp (* a x)))) ((* (abs x) (abs (- x a)))) ((abs (* x (- x a)))) ((* (sgn x) (abs (- x a))))
    ((/ (abs x) (+ 1 (square x))) (* 1/2 (sgn x) (log (+ 1 (square x)))))
    ((* (sgn (- x a)) (cos x)) (* (sgn (- x a)) (- (sin x) (sin a))) (* (sgn (- x a)) (sin x)))
    ((/ (abs x) (- x a))) ((/ (sgn x) (+ x a))) ((/ 1 (+ a (abs x)))) ((expt (abs x) n)) ((sqrt (abs x)))
    ((/ 1 (+ 1 (abs x))) (* (sgn x) (log (+ 1 (abs x))))) ((/ 1 (square (- (abs x) 1)))) ((/ (abs x) (square x)))
    ((exp (- (abs x))) (* (sgn x) (- 1 (exp (- (abs x))))) (* -1 (sgn x) (exp (- (abs x)))))
    ((sinh (abs x)) (* (sgn x) (- (cosh x) 1)) (* (sgn x) (cosh x))) ((log (abs x)))
    ;; cosines in denominators, logarithms, hyperbolic functions, the error function
    ((/ 1 (+ 2 (square a) (cos x)))) ((/ 1 (+ 3 (cos (* a x))))) ((/ 1 (+ 1 (square a) (* a (cos x)))))
    ((/ 1 (+ 2 (* a (cos x))))) ((/ 1 (- 2 (cos x))) (/ (+ x (* 2 (atan (/ (sin x) (- 4 (cos x)))))) 2))
    ((log x) (- (* x (log x)) x) (- (* x (log (abs x))) x)) ((log (+ x a))) ((* x (log x)))
    ((cosh (* a x)) (/ (sinh (* a x)) a)) ((square (cosh x))) ((/ 1 (square (cosh x))) (tanh x))
    ((/ 1 (cosh x)) (atan (sinh x)) (* 2 (atan (exp x))) (* 2 (atan (tanh (/ x 2)))))
    ((exp (* -1 (+ 1 (square a)) (square x)))) ((exp (- (square x))) (* 1/2 (sqrt :pi) (erf x)) (erf x))
    ((exp (* -1 a (square x)))) ((asin x) (+ (* x (asin x)) (sqrt (- 1 (square x))))) ((asin (* a x)))
    ((/ 1 (sin x)) (- (atanh (cos x))) (log (abs (tan (/ x 2))))) ((atan (* a x)))
    ;; roots over x
    ((/ (sqrt (+ (square x) a)) x)) ((/ (sqrt (- 1 (square x))) x)) ((/ (sqrt (- (* a x) (square x))) x))
    ((/ (sqrt (- (square x) 1)) x) (- (sqrt (- (square x) 1)) (acos (/ 1 x)))
                                   (- (sqrt (- (square x) 1)) (atan (sqrt (- (square x) 1)))))
    ((/ 1 (* x (sqrt (+ (square x) (* a x)))))) ((/ 1 (* x (sqrt (- (+ (square x) x) 2)))))
    ((/ 1 (* x (sqrt (- (* 2 x) 1))))) ((/ 1 (* x (sqrt (- (square x) (square a)))))) ((sqrt (- (/ 2 x) 1)))))
