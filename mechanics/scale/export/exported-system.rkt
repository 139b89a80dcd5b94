#lang racket/base
;; A system ready for export: the instruction list of its state derivative.
;;
;; The derivative is run on placeholders, as it is for our own code (compile/trace.rkt).  The
;; symbols left in it are parameters of the code; those of the example name the variables.

(require racket/list
         "state-variables.rkt"
         "../../algebra/expression/expression.rkt" "../../algebra/expression/symbols.rkt"
         "../../compile/derivative-sweep.rkt" "../../compile/shorter-program.rkt"
         "../../compile/trace.rkt"
         "../../error/complain.rkt" "../../error/hint.rkt"
         "../../generic/describe.rkt" "../../generic/function-check.rkt"
         "../../generic/up-down.rkt"
         "../../generic/wrong-argument.rkt"
         (only-in "../../motion/system/check.rkt" check-rates)
         "../../value/shape.rkt")

(provide (struct-out exported) make-exported with-jacobian
         exported-size exported-parameter-count no-function)

;; name       : string, of the functions and files
;; definition : string, the system as the user wrote it
;; variables, parameters : symbols, one for each scalar
;; clock?     : is the first variable the time?
;; slope      : program of variables and parameters, whose values are the rates
;; jacobian   : program of the same, the derivatives of each rate by each variable and
;;              parameter, row by row; or #f
;; tables     : alist of further files and their texts
(struct exported (name definition variables parameters clock? slope jacobian tables) #:authentic)

(define (exported-size s) (length (exported-variables s)))
(define (exported-parameter-count s) (length (exported-parameters s)))

;; order : symbols, the parameters as they are wanted; or #f.  otherwise : called, not to return,
;; with the reason why the derivative has no code
(define (make-exported who derivative example name order derivatives?
                       #:definition [definition (value->text derivative)]
                       #:otherwise [otherwise #f])
  (unless (takes-arguments? derivative 1)
    (complain-of-argument who "a state derivative, a function of one state" derivative))
  (define given (given-names who example))
  (define (parameters-in es) (check-parameters who order (free-symbols es) given))
  (define (trace-it)
    (trace who derivative example #:further-inputs parameters-in
           #:names (for/list ([x (in-list given)] [k (in-naturals)])
                     (or x (string->symbol (format "x~a" k))))
           #:unknown (if otherwise (unknown-for otherwise) raise-no-value)))
  (define fail (or otherwise (no-code who derivative)))
  (define-values (p value) (trace-it))
  (when (string? p) (fail p))
  (define-values (again other-value) (trace-it))
  (unless (equal? p again) (fail "it is another one each time it is called"))
  (check-rates who derivative example value)
  (define parameters (parameters-in (scalars value)))
  (define clock? (eqv? 1 (car (scalars value))))
  (define s
    (exported name definition
              (all-named given (suggested-names derivative example clock?) parameters)
              parameters clock? (shorter-program p) #f '()))
  (if derivatives? (with-jacobian s) s))

(define (with-jacobian s) (struct-copy exported s [jacobian (tangent-program (exported-slope s))]))

(define ((unknown-for otherwise) who e)
  (otherwise (format "~a has no numeric value" (value->text e))))

(define ((no-code who derivative) reason)
  (complain who
            (string-append "this state derivative has no code in other languages\n  of: ~a"
                           "\n  reason: ~a")
            (value->text derivative) reason))

;; Called with an operation of s that a language, a string, lacks; does not return.
(define ((no-function who s language) operation)
  (complain who "there is no function for this operation in ~a\n  operation: ~a\n  of: ~a"
            language operation (exported-definition s)))

;; ---------------------------------------------------------------------------
;; Variables

;; Symbols of the example, and #f where it holds numbers.
(define (given-names who example)
  (unless (tuple? example)
    (complain who "the example is a state, a tuple such as (up 't 'q 'v)\n  given: ~a~a"
              (describe-with-value example) (list-hint example)))
  (define names
    (for/list ([x (in-list (scalars example))])
      (cond [(free-symbol? x) x]
            [(real? x) #f]
            [else (complain who
                            (string-append "the example is a state of numbers, or of symbols"
                                           " that name its variables\n  given: ~a")
                            (value->text example))])))
  (define twice (check-duplicates (filter values names) eq?))
  (when twice
    (complain who "two variables of the state have one name\n  name: ~a\n  given: ~a"
              twice (value->text example)))
  names)

;; -> names, the given ones and others in place of #f: no two alike, and none like a parameter
(define (all-named given suggested parameters)
  (define (free name taken)
    (if (memq name taken) (free (string->symbol (format "~a_" name)) taken) name))
  (define-values (names taken)
    (for/fold ([names '()] [taken (append parameters (filter values given))])
              ([x (in-list given)] [other (in-list suggested)])
      (define name (or x (free other taken)))
      (values (cons name names) (cons name taken))))
  (reverse names))

;; ---------------------------------------------------------------------------
;; Parameters

(define (free-symbols es)
  (sort (remove-duplicates
         (for*/list ([e (in-list es)] #:when (expression? e)
                     [s (in-list (symbols-in e))] #:when (symbol-interned? s))
           s)
         eq?)
        symbol<?))

;; variables : names given by the user, or #f -> the parameters found, in the order wanted
(define (check-parameters who order found variables)
  (define both (for/first ([s (in-list (or order found))] #:when (memq s variables)) s))
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
