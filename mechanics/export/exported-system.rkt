#lang racket/base
;; A system ready for export: the instruction list of its state derivative.
;;
;; The derivative is run on placeholders, as it is for our own code (compile/trace.rkt).  The
;; symbols left in it are parameters of the code; those of the example name the variables.

(require racket/list
         "../algebra/expression/expression.rkt" "../algebra/expression/symbols.rkt"
         "../compile/tangent-program.rkt" "../compile/trace.rkt"
         "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/function.rkt"
         (only-in "../motion/check.rkt" check-rates)
         "../value/shape.rkt")

(provide (struct-out exported) make-exported exported-size exported-parameter-count)

;; name       : string, of the functions and files
;; definition : string, what the system is, as the user wrote it
;; variables, parameters : symbols, one for each scalar
;; clock?     : is the first variable the time?
;; slope      : program of variables and parameters, whose values are the rates
;; jacobian   : program of the same, the derivatives of each rate by each variable and
;;              parameter, row by row; or #f
(struct exported (name definition variables parameters clock? slope jacobian) #:authentic)

(define (exported-size s) (length (exported-variables s)))
(define (exported-parameter-count s) (length (exported-parameters s)))

;; order : symbols, the parameters as they are wanted; or #f
(define (make-exported who derivative example name order derivatives?)
  (unless (and (procedure? derivative) (accepts? derivative 1))
    (complain who "expected a state derivative, a function of one state\n  given: ~a"
              (describe-with-value derivative)))
  (define variables (variables-of who example))
  (define (parameters-in es) (check-parameters who order (free-symbols es) variables))
  (define-values (p value)
    (trace who derivative example #:further-inputs parameters-in #:names variables))
  (when (string? p) (raise-no-code who derivative p))
  (check-rates who derivative example value)
  (exported name (value->text derivative) variables (parameters-in (scalars value))
            (eqv? 1 (car (scalars value)))
            p
            (and derivatives? (tangent-program p))))

;; Symbols of the example, and x0, x1 ... where it holds numbers.
(define (variables-of who example)
  (define names
    (for/list ([x (in-list (scalars example))] [k (in-naturals)])
      (cond [(free-symbol? x) x]
            [(real? x) (string->symbol (format "x~a" k))]
            [else (complain who
                            (string-append "the example is a state of numbers, or of symbols"
                                           " that name its variables\n  given: ~a")
                            (value->text example))])))
  (define twice (check-duplicates names eq?))
  (when twice
    (complain who "two variables of the state have one name\n  name: ~a\n  given: ~a"
              twice (value->text example)))
  names)

(define (free-symbols es)
  (sort (remove-duplicates
         (for*/list ([e (in-list es)] #:when (expression? e)
                     [s (in-list (symbols-in e))] #:when (symbol-interned? s))
           s)
         eq?)
        symbol<?))

;; -> the parameters found, in the order wanted
(define (check-parameters who order found variables)
  (define both (for/first ([s (in-list found)] #:when (memq s variables)) s))
  (when both
    (complain who
              (string-append "the symbol ~a is a parameter of the state derivative, and names a"
                             " variable of the state, too\n  give one of them another name")
              both))
  (define twice (and order (check-duplicates order eq?)))
  (when twice (complain who "a parameter is there twice\n  parameter: ~a" twice))
  (define missing (and order (for/first ([s (in-list found)] #:unless (memq s order)) s)))
  (when missing
    (complain who
              "the state derivative holds a symbol that is not among the parameters\n  ~a: ~a\n  ~a: ~a"
              "symbol" missing "parameters" order))
  (or order found))

(define (raise-no-code who derivative reason)
  (complain who
            (string-append "this state derivative has no code in other languages\n  of: ~a"
                           "\n  reason: ~a")
            (value->text derivative) reason))
