#lang racket/base
;; The addition theorems hold for angles and exponents that are fractions with sums below:
;; by form, by verdict and by value.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation
         mechanics/algebra/simplify/simplify-expression
         mechanics/algebra/zero/zero-test
         "../../support/checks.rkt"
         "../../support/property/expressions.rkt" "../../support/property/property.rkt")

(define (node op . args) (make-node op args))
(define (of op) (lambda (u) (node op u)))
(define-values (sin* cos* sinh* cosh* exp*)
  (values (of op:sin) (of op:cos) (of op:sinh) (of op:cosh) (of op:exp)))
(define (sum u v) (node op:+ u v))
(define (product u v) (node op:* u v))
(define (difference u v) (node op:- u v))

;; ---------------------------------------------------------------------------
;; Random fractions

(define (random-symbol) (choose 'x 'y 'z))
(define (random-below deep?)
  (define u (random-symbol))
  (case (random (if deep? 10 7))
    [(0 1 2) (sum (choose 1 2 -1 1/2) u)]
    [(3 4) (sum u (random-symbol))]
    [(5) (sum 1 (product u u))]
    [(6) (product u (sum 1 (random-symbol)))]
    [(7) (sum 2 (node op:sin u))]
    [(8) (sum 1 (node op:sqrt u))]
    [else (sum (node op:exp u) (random-symbol))]))

(define (random-above)
  (choose 1 2 -1/3 (random-symbol) (product (random-symbol) (random-symbol))
          (sum 1 (random-symbol))))

(define (random-fraction deep?)
  (case (random 4)
    [(0) (random-above)]
    [else (node op:/ (random-above) (random-below deep?))]))

;; ---------------------------------------------------------------------------
;; Both sides of each theorem

(define (theorems a b)
  (define s (sum a b))
  (list (cons (exp* s) (product (exp* a) (exp* b)))
        (cons (exp* (difference a b)) (node op:/ (exp* a) (exp* b)))
        (cons (sin* s) (sum (product (sin* a) (cos* b)) (product (cos* a) (sin* b))))
        (cons (cos* s) (difference (product (cos* a) (cos* b)) (product (sin* a) (sin* b))))
        (cons (sinh* s) (sum (product (sinh* a) (cosh* b)) (product (cosh* a) (sinh* b))))
        (cons (cosh* s) (sum (product (cosh* a) (cosh* b)) (product (sinh* a) (sinh* b))))
        (cons (node op:/ 1 (cos* s))
              (node op:/ 1 (difference (product (cos* a) (cos* b)) (product (sin* a) (sin* b)))))
        (cons (node op:/ 1 (sum 1 (exp* s)))
              (node op:/ 1 (sum 1 (product (exp* a) (exp* b)))))))

;; Of sines and cosines either side may be what is shown; of exponentials not.
(define (angles? e)
  (node-fold e
             (lambda (leaf) #f)
             (lambda (n parts)
               (or (memq (node-head n) (list op:sin op:cos op:sinh op:cosh))
                   (ormap values parts)))))

(define (shown e) (format "~s" (expression->datum e)))

(define (check-theorems a b)
  (for ([t (in-list (theorems a b))])
    (define d (difference (car t) (cdr t)))
    (with-check-info (['left (shown (car t))])
      (check-equal? (simplify-expression d) 0 "by form")
      (check-eq? (zero-test-status (zero-test d)) 'proved "by verdict")
      (unless (angles? (car t))
        (check-equal? (shown (simplify-expression (car t))) (shown (simplify-expression (cdr t)))
                      "by print"))
      (check-false (value-kept (car t)) "by value"))))

(define seed 1303)

(define (check-random count deep?)
  (random-seed seed)
  (for ([i (in-range count)])
    (define a (random-fraction deep?))
    (define b (random-fraction deep?))
    (test-case (format "~a and ~a" (shown a) (shown b)) (check-theorems a b))))

(test-case (format "addition theorems with rational functions, seed ~a" seed)
  (check-random 60 #f))

(test-case (format "addition theorems with sines, roots and exponentials below, seed ~a" seed)
  (check-random 20 #t))
