#lang racket/base
;; Certified values of expressions: every operation has one, exact where it can be, and none
;; where a part of the expression has none.

(require mechanics/algebra/ball/ball
         mechanics/algebra/ball/ball-tape
         mechanics/algebra/ball/ball-value
         mechanics/algebra/assumption/signs
         mechanics/algebra/expression/expression
         mechanics/algebra/expression/flat-graph
         mechanics/algebra/expression/operation
         mechanics/algebra/expression/read
         "../../support/checks.rkt" "../../support/random.rkt")

;; The value of e where every symbol is x, and every function its first argument.
(define (value-at e x [p 80])
  (tape-value (expression->tape e) (lambda (leaf arguments) x) p))

(define (value d [x 2] [p 80]) (value-at (datum->expression d) x p))

(define (middle b) (* (ball-middle b) (expt 2 (ball-scale b))))
(define (number v) (exact->inexact (if (ball? v) (middle v) v)))

(define (sign d) (make-node op:sgn (list (datum->expression d))))

(define binary (list op:+ op:- op:* op:/ op:expt op:atan))
(define unary (filter (lambda (op) (not (memq op (list op:+ op:- op:* op:/ op:expt)))) operations))

(test-case "every operation of the table has certified values, as Racket computes them"
  (define (check op . xs)
    (define e (make-node op (map (lambda (x) (datum->expression x)) xs)))
    (check-= (number (value-at e 0)) (apply (operation-numeric op) xs) 1e-12
             (format "~a of ~a" (operation-name op) xs)))
  (with-seeds 20
    (define x (/ (random-integer 1 99) 100))
    (for ([op (in-list unary)])
      (if (eq? op op:acosh)
          (check op (+ 1 x))
          (check op x))
      (when (memq op (list op:exp op:sin op:cos op:tan op:asin op:acos op:atan op:sinh op:cosh
                           op:tanh op:asinh op:atanh op:abs op:sgn))
        (check op (- x))))
    (for ([op (in-list binary)])
      (check op x (random-rational))))
  (check op:atan -1 -2)
  (check op:atan 1 -2)
  (check op:atan 0 -2))

(test-case "at the exact numbers where some have exact values, too"
  (for* ([op (in-list unary)] [x (in-list '(0 1 2 -1 -2 1/2))])
    (define expected
      (with-handlers ([exn:fail:contract? (lambda (_) #f)]) ((operation-numeric op) x)))
    (when (and (real? expected) (rational? expected))
      (check-= (number (value-at (make-node op (list 'x)) x)) expected 1e-12
               (format "~a of ~a" (operation-name op) x)))))

(test-case "exact values stay exact"
  (check-eqv? (value '(expt (- x 2) (- x 1))) 0)
  (check-eqv? (value '(expt (- x 1) (sqrt x))) 1)
  (check-= (number (value '(* (- x 1) (exp x)))) (exp 2.0) 1e-12)
  (check-eqv? (value '(+ (* 1/2 x) (sin (- x x)) (cos 0) (sqrt (* 2 x)))) 4)
  (check-eqv? (value '(expt (* 2 x) 3/2)) 8)
  (check-eqv? (value '(* (exp 1) (- x x))) 0)
  (check-eqv? (value '(* (exp 1) (- x 2))) 0)
  (check-eqv? (value '(expt (- x 2) 1/3)) 0)
  (check-eqv? (value '(/ (log (/ x x)) (expt x 5))) 0)
  (check-eqv? (value-at (sign '(- (sin x) 1)) 2) -1)
  (check-pred ball? (value '(expt x 1000))))

(test-case "a large power of an exact number is known to nearly all bits"
  (define b (value '(expt x 1000) 1/3 80))
  (check-true (< (* (expt 2 60) (ball-radius b)) (ball-middle b))))

(test-case "a tuple has the values of its components"
  (define v (value '(up x (- x 2) (exp x))))
  (check-equal? (list (car v) (cadr v) (caddr v)) '(up 2 0))
  (check-= (number (cadddr v)) (exp 2.0) 1e-12))

(test-case "an angle depends on both coordinates of its point"
  (check-= (number (value '(+ (atan (- x 1) x) (atan (- x 1) (- 0 x))))) (acos -1.0) 1e-12))

(test-case "each part has to have a value"
  (for ([d (in-list '((* (- x 2) (log (- x 3))) (/ 1 (- x 2)) (expt (- x 2) -2) (sqrt (- 1 x))
                      (expt (- 1 x) 1/3) (f (sqrt (- 1 x))) (expt 0 (- 1 x))
                      (+ 1 (atan (- x 2) (- x 2)))))])
    (check-eq? (value-at (datum->expression (list '* 1 (list 'g d))) 2) 'no-value (format "~s" d)))
  (for ([d (in-list '((sqrt (- (exp (log x)) x)) (expt (- (exp (log x)) x) 1/3)
                      (atan (- (exp (log x)) x) -1) (/ 1 (- (exp (log x)) x))
                      (expt (- 1 x) (exp (log x)))))])
    (check-eq? (value d) 'unknown (format "~s" d)))
  (check-eq? (value-at (sign '(- (exp (log x)) x)) 2) 'unknown))

(test-case "what is known of a value"
  (define zero (value '(- (exp (log x)) x)))
  (check-false (value-not-zero? zero))
  (check-eqv? (value-signs zero) any-sign)
  (check-eqv? (value-signs (value '(- 1 (exp x)))) negative)
  (check-eqv? (value-signs (value '(abs (- (exp (log x)) x)))) nonnegative)
  (check-true (values-overlap? (value '(exp (log x))) 2))
  (check-false (values-overlap? (value '(exp (log x))) 2001/1000))
  (check-true (values-overlap? (list 'up 1 (value '(exp (log x)))) '(up 1 2)))
  (check-false (values-overlap? '(up 1 2) '(down 1 2)))
  (check-false (values-overlap? '(up 1 2) '(up 1 2 3))))

(test-case "more bits tell more"
  (define d '(- (sqrt (+ (expt 10 60) x)) (expt 10 30)))
  (check-false (value-not-zero? (value d 2 80)))
  (check-true (value-not-zero? (value d 2 320))))
