#lang racket/base
;; Forms of a value that people ask for: expanded, factored, collected ...
;;
;; Each works on every scalar of the value.  The results are shown in the form
;; asked for, where others are simplified first; calculating with them goes on
;; as with any value, and `simplify` simplifies them.

(require "algebra.rkt" "assumptions.rkt" "simplify.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/symbols.rkt"
         "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/irrational.rkt" "../generic/wrong-argument.rkt")

(provide expand factor collect coefficient together apart
         (rename-out [numerator-of numerator] [denominator-of denominator]))

;; ---------------------------------------------------------------------------
;; The forms

;; Products and powers of sums multiplied out.
(define (expand x) (reform 'expand expand-expression x))

;; A product of irreducible factors.
(define (factor x) (reform 'factor factored-expression x))

;; One quotient in lowest terms.
(define (together x) (reform 'together together-expression x))

;; (collect x 'm), (collect x (list 'm ((D f) 't))): a polynomial in these, their
;; highest powers first.
(define collect
  (case-lambda
    [(x in)
     (define chosen (if (list? in) in (list in)))
     (for ([e (in-list chosen)]) (check-unknown 'collect e))
     (reform 'collect (lambda (e A) (collect-expression e chosen A)) x)]
    [(x) (raise-no-unknown 'collect "(collect x 'm) or (collect x (list 'm 'n))" x)]))

;; Partial fractions in a symbol.
(define apart
  (case-lambda
    [(x in)
     (check-unknown 'apart in)
     (reform 'apart (lambda (e A) (partial-fractions e in A)) x)]
    [(x) (raise-no-unknown 'apart "(apart x 's)" x)]))

;; The coefficient of in^n, simplified.
(define (coefficient x in n)
  (check-unknown 'coefficient in)
  (check-argument 'coefficient exact-integer? n
                  "an integer, the power whose coefficient is wanted")
  (map-scalars 'coefficient
               (lambda (e A)
                 (define-values (c assumptions) (expression-coefficient e in n A))
                 (note-used! assumptions)
                 (or c (raise-not-polynomial e in)))
               x))

(define (numerator-of x)
  (if (number? x) (* x (denominator-of x)) (part-of-quotient 'numerator (lambda (n d) n) x)))

;; Of a complex number the least that makes both its parts whole.
(define (denominator-of x)
  (define (of part) (if (rational? part) (denominator part) 1))
  (if (number? x)
      (lcm (of (real-part x)) (of (imag-part x)))
      (part-of-quotient 'denominator (lambda (n d) d) x)))

(define (part-of-quotient who choose x)
  (reform who
          (lambda (e A)
            (define-values (n d assumptions) (numerator-and-denominator e A))
            (values (choose n d) assumptions))
          x))

;; ---------------------------------------------------------------------------
;; On every scalar

;; rewrite : expression assumptions -> expression and its grounds
(define (reform who rewrite x)
  (map-scalars who
               (lambda (e A)
                 (define-values (new assumptions) (rewrite e A))
                 (note-used! assumptions)
                 (request-form new assumptions))
               x))

;; f : expression, and the assumptions in force -> value
(define (map-scalars who f x)
  (define A (assumptions-in-force))
  (map-leaves
   (lambda (leaf)
     (define e (irrational-as-expression leaf))
     (if (expression? e) (f e A) (raise-no-expression who leaf "use it on")))
   x))

;; ---------------------------------------------------------------------------
;; Complaints

(define (check-unknown who e)
  (check-argument who unknown? e "a symbol, or a literal function applied such as ((D f) 't)"))

(define (raise-no-unknown who usage x)
  (complain who "it is not said in what; use ~a\n  given only: ~a" usage (value->text x)))

(define (raise-not-polynomial e in)
  (complain 'coefficient
            (string-append "the expression is no polynomial in ~a: "
                           "it is divided by a sum with ~a in it\n  expression: ~a")
            (value->text in) (value->text in) (value->text e)))
