#lang racket/base
;; From a generic function to a program: run it once on placeholders.
;;
;; The function is ordinary code over the generic arithmetic.  Given
;; placeholders in place of numbers it computes an expression graph, which holds
;; for all numbers, provided that it did not take a branch on the way: a test of
;; a placeholder ends the trace, and so does an error, which may be due to the
;; placeholder not being a number.

(require "program.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/symbols.rkt"
         "../error/complain.rkt" "../error/refusal.rkt"
         "../generic/describe.rkt" "../generic/irrational.rkt" "../generic/tracing.rkt"
         "../value/shape.rkt")

(provide trace raise-no-value)

;; f : a procedure of one structure of the shape of `example`
;; -> program and the shape of f's value there; or the reason why there is none,
;; a string, and #f.  as-constant : number in the program -> its constant; check-unknown : called
;; with who and an expression that has no numeric value; further : the scalars of the value ->
;; symbols that are inputs, too, after those of the example; names : of these, symbols, or #f
(define (trace who f example #:constants [as-constant real->double-flonum]
               #:unknown [check-unknown raise-no-value]
               #:further-inputs [further (lambda (es) '())]
               #:names [names #f])
  (define placeholders
    (for/list ([k (in-range (shape-length example))])
      (make-placeholder (if names (symbol->string (list-ref names k)) (format "x~a" k)))))
  (define holes (list->vector placeholders))
  (define (run) (f (scalars->structure example (lambda (k) (vector-ref holes k)))))
  (define result (value-or-reason run))
  (if (string? result)
      (values result #f)
      (make-program placeholders further (unbox result) as-constant
                    (lambda (e) (check-unknown who e)))))

;; An error that is not due to the placeholders comes up again when f is run on numbers.
(define (value-or-reason run)
  (with-handlers ([raised? (lambda (x) (if (exn? x) (exn-message x) (format "it raises ~e" x)))])
    (call-traced (lambda () (box (run)))
                 (lambda (test) (format "it takes a decision by `~a`" test)))))

(define (make-program placeholders further value as-constant check-unknown)
  (define es (map irrational-as-expression (scalars value)))
  (define odd (for/first ([e (in-list es)] #:unless (expression? e)) e))
  (if odd
      (values (format "its value holds ~a" (describe-with-value odd)) #f)
      (let/ec return
        (define (fail e)
          (when (unknown? e) (check-unknown e))
          (return (format "~a is not a real number" (value->text e)) #f))
        (define inputs (append placeholders (further es)))
        (values (expressions->program inputs es fail #:constants as-constant) value))))

(define (raise-no-value who e)
  (complain who "~a is left in the function's value, but has no numeric value\n  ~a"
            (describe-with-value e)
            (if (symbol? e)
                "give every symbol a number"
                "a literal function stands for any function; put a definite one in its place")))
