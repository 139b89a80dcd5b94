#lang racket/base
;; Racket's tests of kinds of value, for programs that are traced.
;;
;; They answer as Racket's do, but a placeholder for a number is neither a
;; number nor a symbol: to ask is to look inside.  An irrational number of ours is exact, one of
;; higher precision than Racket's is not.

(require "kind.rkt" "naming.rkt" "irrational.rkt" "tracing.rkt")

(provide g:number? g:real? g:rational? g:integer? g:exact? g:inexact? g:symbol?
         g:equal? g:eqv? g:memv g:member g:case)

(define-syntax-rule (define-tests [id name] ...)
  (begin
    (define-named id name
      (lambda (x)
        (when (open-leaf? x) (look-inside 'name))
        (if (other-number? x) (of-other-number 'name name x) (name x)))) ...))

(define (of-other-number name test x)
  (case name
    [(exact?) (irrational? x)]
    [(inexact?) (not (irrational? x))]
    [(rational?) (and (not (irrational? x)) (rational? (comparand x)))]
    [else (test (comparand x))]))

(define-tests
  [g:number? number?] [g:real? real?] [g:rational? rational?] [g:integer? integer?]
  [g:exact? exact?] [g:inexact? inexact?] [g:symbol? symbol?])

;; To compare is to look inside.
(define-syntax-rule (look-inside-if-open name x ...)
  (when (and (being-traced?) (or (open-value? x) ...))
    (look-inside name)))

(define-syntax-rule (define-equalities [id name] ...)
  (begin
    (define-named id name
      (lambda (x y)
        (look-inside-if-open 'name x y)
        (name x y))) ...))

(define-equalities [g:equal? equal?] [g:eqv? eqv?] [g:memv memv])

(define-named g:member member
  (case-lambda
    [(x xs)
     (look-inside-if-open 'member x xs)
     (member x xs)]
    [(x xs same?) (member x xs same?)]))

(define-syntax-rule (g:case x clause ...)
  (case (known-for-case x) clause ...))

(define (known-for-case x)
  (look-inside-if-open 'case x)
  x)
