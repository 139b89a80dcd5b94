#lang racket/base
;; Simplification leaves its results as they are, whatever signs are declared, and
;; whether it may assume others or not, if the expression has a value somewhere.

(require racket/list
         mechanics/algebra/assumption/assumption-set
         mechanics/algebra/assumption/reference-point
         mechanics/algebra/expression/expression
         mechanics/algebra/expression/read
         mechanics/algebra/simplify/declare-relations
         mechanics/algebra/simplify/simplify-expression
         "../../support/checks.rkt" "../../support/property/expressions.rkt")

;; ---------------------------------------------------------------------------
;; Random signs

(define symbols '(a b c x))

(define (random-relations)
  (remove-duplicates
   (append
    (for/list ([s (in-list symbols)] #:when (zero? (random 2))) (list (choose '> '< '>= '<=) s 0))
    (if (zero? (random 2)) (list (list (choose '> '<) 'a 'b)) '()))))

(define (declared relations)
  (with-handlers ([exn:algebra:contradiction? (lambda (x) no-assumptions)])
    (declare-relations no-assumptions relations)))

(define (random-assumptions)
  (define A (declared (random-relations)))
  (if (zero? (random 3)) (with-automatic-assumptions A #f) A))

;; ---------------------------------------------------------------------------

(define (simplified e A) (expression->datum (simplify-expression e A)))

;; #f, or what it is changed to
(define (changed e A)
  (define once (simplify-expression e A))
  (define again (simplified once A))
  (and (not (equal? (expression->datum once) again))
       (format "~s from ~s" again (expression->datum once))))

(define (random-of class) (random-expression (class-depth class) (class-kinds class)))

(define (check-settled first-seed count assumptions)
  (for ([seed (in-range first-seed (+ first-seed count))])
    (random-seed seed)
    (define e (random-of (list-ref classes (modulo seed (length classes)))))
    (define A (assumptions))
    (when (find-reference (list e) A)
      (check-false (changed e A) (format "seed ~a" seed)))))

(test-case "results stay as they are"
  (check-settled 1000 1500 (lambda () no-assumptions)))

(test-case "results stay as they are under declared signs"
  (check-settled 12000 1500 random-assumptions))

;; ---------------------------------------------------------------------------
;; Findings of random expressions

(define (check-stays datum . relations)
  (define A (declared relations))
  (for ([A (in-list (list A (with-automatic-assumptions A #f)))])
    (check-false (changed (datum->expression datum) A) (format "~s" datum))))

(test-case "roots of other degrees, or of other quotients, in the result"
  (check-stays '(* (- (+ c c) (+ 1 b)) (expt (expt b -1/4) 2)))
  (check-stays '(* (- (expt (/ c x) -1/2) (expt (* x a) 3/2)) (expt (/ c b) -1/2))))

(test-case "flonums with many digits in common"
  (check-stays '(/ (+ (/ b 0.5) (/ -2/3 x)) (+ (- -0.1 x) (expt b 2))))
  (check-stays '(/ (- (+ c -0.1) (/ b b)) (* (/ b c) a x))))

(test-case "a flonum that multiplies all is whole, or not, or lies in a denominator"
  (for ([r '(0.1 0.3 1e-20 2.5e17 1e15 -0.7)])
    (check-stays `(* ,r (+ (* 3 a) (* 5 b))))
    (check-stays `(/ (* ,r (+ (* 3 a) (* 5 b))) (+ 7 x)))
    (check-stays `(/ (+ (* 3 a) (* 5 b)) (* ,r (+ 7 x))))
    (check-stays `(+ (* ,r a) (/ b ,r)))
    (check-stays `(* (sqrt (* ,r a)) (sin (* ,r x))))))

(test-case "logarithms of odd powers of what has no known sign"
  (check-stays '(+ (log (/ a x)) (expt (log (* 9 (expt (+ a b) 3))) 2)) '(>= x 0))
  (check-stays '(* (log x) (log (* 4 (expt (+ b b) 3)))) '(> c 0))
  (check-stays '(* (log (/ x b)) (expt a 2) (log b)) '(> a 0) '(< x 0) '(> a b)))
