#lang racket/base
;; Points where a function has a value but no derivative, and points beside them.

(require mechanics/generic/arithmetic
         mechanics/generic/compare
         mechanics/generic/elementary
         mechanics/generic/rounding
         mechanics/error/failure
         mechanics/value/structure
         mechanics/calculus/derivative
         "../support/checks.rkt" "../support/same.rkt")

(define-syntax-rule (check-singular message where expression)
  (check-exn (lambda (e)
               (and (exn:fail:mechanics:singular? e)
                    (equal? (exn-message e) message)
                    (equal? (format "~s" (exn:fail:mechanics:singular-where e))
                            (format "~s" where))))
             (lambda () expression)))

(define (power n) (lambda (x) (g:expt x n)))

(test-case "the absolute value has a kink at 0, exact or not, and the sign a jump"
  (check-singular "abs: has no derivative at 0" 0 ((D g:abs) 0))
  (check-singular "abs: has no derivative at 0.0" 0.0 ((D g:abs) 0.0))
  (check-singular "abs: has no derivative at -0.0" -0.0 ((D g:abs) -0.0))
  (check-singular "sgn: has no derivative at 0" 0 ((D g:sgn) 0))
  (check-singular "abs: has no derivative at 0" 0 ((D g:magnitude) 0))
  (check-singular "abs: has no derivative at 0" 0 ((D (lambda (x) (g:abs (g:- x 2)))) 2)))

(test-case "beside the kink the derivative is the sign, and so it is as an expression"
  (check-equal? ((D g:abs) -3) -1)
  (check-equal? ((D g:abs) 3.5) 1.0)
  (check-equal? ((D g:abs) 'x) (g:/ 'x (g:abs 'x)))
  (check-equal? ((D g:sgn) 'x) 0)
  (check-equal? ((D (D g:abs)) -3) 0)
  (check-true (same? ((D (lambda (x) (g:* x (g:abs x)))) 'x) (g:* 2 (g:abs 'x)))))

(test-case "neither is a function of a complex variable that has a derivative"
  (check-singular "abs: has no derivative at 3+4i" 3+4i ((D g:abs) 3+4i))
  (check-singular "sgn: has no derivative at 0+1i" +i ((D g:sgn) +i)))

(test-case "infinite slopes: roots, arcs, powers below 1"
  (check-singular "sqrt: has no derivative at 0" 0 ((D g:sqrt) 0))
  (check-singular "sqrt: has no derivative at 0.0" 0.0 ((D g:sqrt) 0.0))
  (check-singular "asin: has no derivative at 1" 1 ((D g:asin) 1))
  (check-singular "asin: has no derivative at -1.0" -1.0 ((D g:asin) -1.0))
  (check-singular "acos: has no derivative at 1" 1 ((D g:acos) 1))
  (check-singular "acosh: has no derivative at 1" 1 ((D g:acosh) 1))
  (check-singular "expt: has no derivative at 0, 1/2" (list 0 1/2) ((D (power 1/2)) 0))
  (check-singular "expt: has no derivative at 0.0, 0.5" (list 0.0 0.5) ((D (power 0.5)) 0.0)))

(test-case "a distance has none at the origin, nor a root of a square"
  (define (distance s) (g:sqrt (g:square s)))
  (check-singular "sqrt: has no derivative at 0" 0 ((D distance) (up 0 0)))
  (check-singular "sqrt: has no derivative at 0.0" 0.0 ((D distance) (up 0.0 0.0)))
  (check-equal? ((D distance) (up 3 4)) (down 3/5 4/5))
  (check-singular "sqrt: has no derivative at 0" 0 ((D (lambda (x) (g:sqrt (g:- 1 (g:cos x))))) 0))
  (check-singular "acos: has no derivative at 1" 1 ((D (lambda (x) (g:acos (g:cos x)))) 0))
  (check-equal? ((D (lambda (x) (g:* x (g:sqrt (g:* 0 x))))) 3) 0)
  (check-equal? ((D (lambda (x) (g:* x (g:sqrt (g:floor x))))) 1/2) 0))

(test-case "a derivative may exist where the next does not"
  (check-equal? ((D (power 3/2)) 0) 0)
  (check-singular "expt: has no derivative at 0, 1/2" (list 0 1/2) ((D (D (power 3/2))) 0))
  (check-equal? (((g:expt D 3) (power 2)) 0) 0)
  (check-equal? (((g:expt D 2) (power 2)) 0.0) 2))

(test-case "powers at 0: whole ones are smooth, 0ⁿ is 0 for n > 0 and jumps at n = 0"
  (check-equal? (map (lambda (n) ((D (power n)) 0)) '(0 1 2 3)) '(0 1 0 0))
  (check-equal? (map (lambda (n) ((D (power n)) 0.0)) '(0.0 1.0 2.0)) '(0 1.0 0.0))
  (check-equal? ((D (lambda (n) (g:expt 0 n))) 2) 0)
  (check-singular "expt: has no derivative at 0, 0" (list 0 0) ((D (lambda (n) (g:expt 0 n))) 0))
  (check-singular "expt: has no derivative at 0.0, 0"
                  (list 0.0 0)
                  ((D (lambda (n) (g:expt 0.0 n))) 0)))

(test-case "where the value itself is infinite so is the slope, and there is none"
  (check-singular "log: has no derivative at 0.0" 0.0 ((D g:log) 0.0))
  (check-singular "atanh: has no derivative at 1.0" 1.0 ((D g:atanh) 1.0)))

(test-case "the angle of the origin"
  (check-exn #rx"^atan: the point at the origin has no angle" (lambda () ((D g:atan) 0 0)))
  (check-singular "atan: has no derivative at 0.0, 0.0" (list 0.0 0.0) ((D g:atan) 0.0 0.0))
  (check-equal? ((D g:atan) 0 -1) (down -1 0)))

(test-case "roundings jump"
  (check-singular "floor: has no derivative where it jumps, at 3" 3 ((D g:floor) 3))
  (check-singular "round: has no derivative where it jumps, at 2.5" 2.5 ((D g:round) 2.5)))

(test-case "a maximum has a kink where two arguments are equal with different derivatives"
  (define (hinge x) (g:max x (g:* 2 x)))
  (check-equal? (list ((D hinge) 3) ((D hinge) -3)) '(2 1))
  (check-singular "max: has no derivative where two arguments are equal, at 0, 0" (list 0 0)
                  ((D hinge) 0))
  (check-singular "max: has no derivative where two arguments are equal, at 0, 0" (list 0 0)
                  ((D (lambda (x) (g:max 0 x))) 0))
  (check-singular "min: has no derivative where two arguments are equal, at 1.0, 1.0" (list 1.0 1.0)
                  ((D (lambda (x) (g:min 5 x (g:square x)))) 1.0)))

(test-case "with the same derivatives it has none"
  (check-equal? ((D (lambda (x) (g:max x x))) 3) 1)
  (check-equal? ((D (lambda (x) (g:min (g:square x) (g:* x x) (g:expt x 2)))) 3) 6)
  (check-equal? ((D (lambda (x) (g:* x (g:max 2 2)))) 3) 2)
  (check-equal? ((D (D (lambda (x) (g:max (g:cube x) (g:* x x x))))) 3) 18))

(test-case "to have the same first derivative is enough for the first derivative only"
  ;; x² and 2x - 1 touch at 1
  (define (touching x) (g:max (g:square x) (g:- (g:* 2 x) 1)))
  (check-equal? ((D touching) 1) 2)
  (check-exn exn:fail:mechanics:singular? (lambda () ((D (D touching)) 1))))

(test-case "the message names the value, also within other derivatives"
  (check-exn #rx"^abs: has no derivative at 0$"
             (lambda () ((D (lambda (x) ((D (lambda (y) (g:abs (g:* x y)))) 0))) 3))))

;; Powers of D take another way, in one run: they say the same.
(test-case "derivatives of higher order do not exist where those of lower order do not"
  (define (second f) ((g:expt D 2) f))
  (check-singular "abs: has no derivative at 0" 0 ((second g:abs) 0))
  (check-singular "abs: has no derivative at 0.0" 0.0 ((second g:abs) 0.0))
  (check-singular "sgn: has no derivative at 0" 0 ((second g:sgn) 0))
  (check-singular "sqrt: has no derivative at 0" 0 ((second (lambda (x) (g:sqrt (g:* x x)))) 0))
  (check-singular "asin: has no derivative at 1" 1 (((g:expt D 3) g:asin) 1))
  (check-singular "atan: has no derivative at 0.0, 0.0" (list 0.0 0.0)
                  ((second (lambda (x) (g:atan x x))) 0.0))
  (check-singular "floor: has no derivative where it jumps, at 2" 2 ((second g:floor) 2))
  (check-singular "max: has no derivative where two arguments are equal, at 1, 1" (list 1 1)
                  ((second (lambda (x) (g:max x (g:square x)))) 1)))

(test-case "and where only the higher ones do not, the lower ones are found"
  (check-equal? (((g:expt D 1) (power 3/2)) 0) 0)
  (check-singular "expt: has no derivative at 0, 1/2" (list 0 1/2) (((g:expt D 2) (power 3/2)) 0))
  (check-equal? (((g:expt D 3) (lambda (n) (g:expt 0 n))) 2) 0)
  (check-equal? (((g:expt D 2) (power 2)) 0) 2)
  (check-equal? (((g:expt D 2) g:abs) -3) 0))

;; Comparisons see values only: the program takes the branch that it takes
;; without D, and the derivative is that of the branch.
(test-case "at equality the branch taken is differentiated"
  (define (f x) (if (g:= x 0) 1 (g:/ (g:sin x) x)))
  (check-equal? ((D f) 0) 0)
  (define (g x) (if (g:< x 0) (g:- x) x))
  (check-equal? (list ((D g) -1) ((D g) 0) ((D g) 1)) '(-1 1 1))
  (check-equal? ((D (lambda (x) (if (g:zero? x) (g:* 5 x) 0))) 0) 5))
