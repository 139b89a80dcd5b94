#lang racket/base
;; Racket's tests of what a value is, for programs that are traced.
;;
;; They answer what Racket's do, but a placeholder for a number is neither a
;; number nor a symbol: to ask is to look inside.

(require "naming.rkt" "tracing.rkt")

(provide g:number? g:real? g:rational? g:integer? g:exact? g:inexact? g:symbol?
         g:equal? g:eqv?)

(define-syntax-rule (define-tests [id name] ...)
  (begin
    (define-named id name
      (lambda (x)
        (when (open-leaf? x) (look-inside 'name))
        (name x))) ...))

(define-tests
  [g:number? number?] [g:real? real?] [g:rational? rational?] [g:integer? integer?]
  [g:exact? exact?] [g:inexact? inexact?] [g:symbol? symbol?])

(define-syntax-rule (define-equalities [id name] ...)
  (begin
    (define-named id name
      (lambda (x y)
        (when (and (being-traced?) (or (open-value? x) (open-value? y)))
          (look-inside 'name))
        (name x y))) ...))

(define-equalities [g:equal? equal?] [g:eqv? eqv?])
