#lang racket/base
;; The equations that the values of operations satisfy, as data.
;;
;; The value r of an operation on a, or on a and b, depends on time as these do, and satisfies
;; an equation in which nothing but products occur: of the quotient b r = a, of the logarithm
;; a r' = a'.  Some need a partner p: sin has cos, r' = p a' and p' = −r a'; tan has
;; p = 1 + r², with r' = p a'.  To compare Taylor coefficients in such an equation gives the
;; coefficient k of the unknown from lower ones: a recurrence (Griewank and Walther,
;; Evaluating Derivatives, ch. 13).
;;
;; They stand in the table of operations, and are read twice: by recurrence.rkt for truncated
;; Taylor numbers and power series, in any arithmetic, and by compile/ for motions, in flonums.

(require "../../operation/operation-column.rkt")

(provide equations-of (struct-out equation) (struct-out term) (struct-out start)
         power-equations exponential-equations integral-equation)

;; leading x = constant + Σ terms, or leading x' = Σ terms, for the unknown x
;; leading : a row, or #f for 1; start : how the unknown begins if the equation does not say
(struct equation (differential? leading constant terms start) #:authentic)

;; factor left right, or factor left right' in a differential equation; left : a row or #f
(struct term (factor left right) #:authentic)

;; The operation of this name on the first coefficient of a row.
(struct start (operation row) #:authentic)

;; Rows are a, b (the arguments), r (the value) and p (its partner).
(define (algebraic leading constant . terms) (equation #f leading constant terms #f))
(define (differential leading . terms) (equation #t leading 0 terms #f))
(define (beginning operation row e) (struct-copy equation e [start (start operation row)]))

;; r' = u p a' and p' = v r a', where p is the other function of a
(define (pair u other v)
  (list (differential #f (term u 'p 'a))
        (beginning other 'a (differential #f (term v 'r 'a)))))

;; p r' = u a' and p' = v a r', where p is the other function of r, and a the one of r
(define (inverse u other v)
  (list (differential 'p (term u #f 'a))
        (beginning other 'r (differential #f (term v 'a 'r)))))

(define-fact-column equations equations)

;; The equations of the value and of its partner, if it has one; #f for an operation without.
(define (equations-of name arguments) (hash-ref equations (operation-key name arguments) #f))

;; r = aⁿ with a constant n: a r' = n r a'
(define (power-equations n) (list (differential 'a (term n 'r 'a))))

;; r = aᵇ with a constant a: r' = log(a) r b'
(define (exponential-equations log-a) (list (differential #f (term log-a 'r 'b))))

;; r' = b a', of an operation without equations: b is its derivative at a.
(define integral-equation (differential #f (term 1 'b 'a)))
