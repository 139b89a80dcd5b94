#lang racket/base
;; A root of one equation in x, and how the coefficients of x are found: from values at 0, 1 and −1,
;; whatever the form of the equation, with a proof that nothing else is in it.

(require "factors.rkt"
         "../expression/expression.rkt" "../expression/nodes.rkt" "../expression/operation.rkt"
         "../expression/substitute.rkt" "../expression/symbols.rkt"
         "../simplify/simplify-expression.rkt"
         "../../error/refusal.rkt")

(provide (struct-out root) put zero-everywhere? known-branch sign-and-rest value-at line quotient-of
         applied arguments-of)

;; x = value, under conditions.  waves : the sine and cosine there, an alist
(struct root (x value conditions waves) #:authentic)

(define (put e x value) (substitute-expression e (list (cons x value))))

(define (zero-everywhere? e A) (eqv? 0 (simplify-expression e A)))

;; The sign of a number; else 1 if e is known not to be negative, -1 if it is known not to
;; be positive, or #f
(define (known-branch e A)
  (define size (e:apply op:abs e))
  (cond [(real? e) (cond [(> e 0) 1] [(< e 0) -1] [else 0])]
        [(zero-everywhere? (e:- e size) A) 1]
        [(zero-everywhere? (e:+ e size) A) -1]
        [else #f]))

;; e has the sign of `sign` · rest; squares and factors of known sign are left out of the rest.
(define (sign-and-rest e A)
  (for/fold ([sign 1] [rest 1])
            ([f (in-list (if (real? e) (list (cons e 1)) (expression-factors e A)))])
    (define known (if (even? (cdr f)) 1 (known-branch (car f) A)))
    (if known (values (* sign known) rest) (values sign (e:* rest (car f))))))

;; (a b) if e = a x + b with a ≠ 0, both without x; else #f.
(define (line e x A)
  (define b (value-at e x 0 A))
  (define a (and b (value-at (e:- e b) x 1 A)))
  (and a
       (not (eqv? a 0))
       (zero-everywhere? (e:- e (e:+ (e:* a x) b)) A)
       (list a b)))

;; The value at x, or #f where there is none.
(define (value-at e x value A)
  (define there (if-raised divided-by-zero? #f (simplify-expression (put e x value) A)))
  (and there
       (not (some-node? (lambda (n) (eqv? 0 (divisor-of n))) there))
       there))

(define (quotient-of a b A) (simplify-expression (e:/ a b) A))

;; The value of an operation; of exact numbers exact, as √2 is
(define (applied op . xs) (if (ormap flonum? xs) (apply e:apply op xs) (make-node op xs)))

;; Of operations of these heads, the arguments in which x occurs, each once
(define (arguments-of f x heads)
  (parts-in f (lambda (n)
                (define u (car (node-args n)))
                (and (memq (node-head n) heads) (occurs? x u) u))))
