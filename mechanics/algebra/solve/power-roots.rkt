#lang racket/base
;; Roots of equations that are linear or quadratic in an unknown, or in a power of it.

(require racket/list
         "root.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt"
         "../expression/substitute.rkt" "../expression/symbols.rkt"
         "../simplify/simplify-expression.rkt")

(provide linear-root quadratic-roots power-roots)

;; xs : the unknowns, none of which may be in the coefficient
(define (linear-root f x xs A)
  (define ab (line f x A))
  (and ab
       (not (ormap (lambda (y) (occurs? y (car ab))) xs))
       (root x (quotient-of (e:negate (cadr ab)) (car ab) A) '() '())))

;; a x² + b x + c
(define (quadratic-roots f x A)
  (define-values (c plus minus)
    (values (value-at f x 0 A) (value-at f x 1 A) (value-at f x -1 A)))
  (and c plus minus
       (let* ([a (simplify-expression (e:- (e:* 1/2 (e:+ plus minus)) c) A)]
              [b (simplify-expression (e:* 1/2 (e:- plus minus)) A)]
              [square (e:+ (e:* a (e:expt x 2)) (e:+ (e:* b x) c))])
         (and (not (eqv? a 0))
              (zero-everywhere? (e:- f square) A)
              (roots-of-square a b c x A)))))

(define (roots-of-square a b c x A)
  (define D (simplify-expression (e:- (e:expt (e:* 1/2 b) 2) (e:* a c)) A))
  (define (solution sign)
    (quotient-of (e:- (e:* sign (applied op:sqrt D)) (e:* 1/2 b)) a A))
  (define-values (branch rest) (sign-and-rest D A))
  (define known? (number? rest))
  (define conditions
    (if known? '() (list (list '>= (simplify-expression (e:* branch rest) A) 0))))
  (if (and known? (eqv? branch -1))
      '()
      (for/list ([sign '(1 -1)]) (root x (solution sign) conditions '()))))

;; a x²ⁿ + b xⁿ + c, where n is the least power of x there is; b or c may be 0
(define (power-roots f x A)
  (define powers (remove-duplicates (powers-of f x)))
  (define n (and (pair? powers) (apply min powers)))
  (define y (string->uninterned-symbol "y"))
  (define (in-y e)
    (node-map-powers e x (lambda (k) (if (zero? (remainder k n)) (e:expt y (quotient k n)) x))))
  (define g (and n (> n 1) (in-y f)))
  (define roots
    (and g
         (not (occurs? x g))
         (let ([linear (linear-root g y (list y) A)])
           (if linear (list linear) (quadratic-roots g y A)))))
  (and roots
       (append-map (lambda (r) (nth-roots (root-value r) (root-conditions r) n x A)) roots)))

;; The real x with xⁿ = value: where n is even, those of a value that is not negative
(define (nth-roots value conditions n x A)
  (define (size v) (simplify-expression (applied op:expt v (/ 1 n)) A))
  (define (roots xs condition)
    (for/list ([v (in-list xs)]) (root x v (append condition conditions) '())))
  (define sign (known-branch value A))
  (define one (if (eqv? sign -1) (e:negate (size (e:negate value))) (size value)))
  (cond [(eqv? sign 0) (roots '(0) '())]
        [(odd? n) (roots (list (if sign one (signed (size (magnitude value)) value))) '())]
        [(eqv? sign -1) '()]
        [else (roots (list one (e:negate one)) (if sign '() (list (list '>= value 0))))]))

(define (magnitude v) (e:apply op:abs v))
(define (signed size v) (e:* (e:apply op:sgn v) size))

;; The exponents of x in e, 1 where it stands alone.
(define (powers-of e x)
  (cond [(eq? e x) '(1)]
        [(not (node? e)) '()]
        [(power-of? e x) (list (cadr (node-args e)))]
        [else (append-map (lambda (a) (powers-of a x)) (node-args e))]))

(define (power-of? e x)
  (and (eq? (node-head e) op:expt)
       (eq? (car (node-args e)) x)
       (exact-positive-integer? (cadr (node-args e)))))

;; e with (change k) in place of each power k of x
(define (node-map-powers e x change)
  (let walk ([e e])
    (cond [(not (node? e)) e]
          [(power-of? e x) (change (cadr (node-args e)))]
          [else (rebuild (node-head e) (map walk (node-args e)))])))
