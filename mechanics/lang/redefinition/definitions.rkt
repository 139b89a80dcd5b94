#lang racket/base
;; The definitions of one module, while its forms are expanded one after another.

(require "binding-forms.rkt" "module-survey.rkt" "../written-form.rkt")

(provide make-definitions
         defined? add-variable! add-macro!
         defining-occurrence definition-header-and-line used-early? mark-variable
         shows-definition? line-in)

;; shown : symbol -> names that the text of the module defines; repeated : those
;; it defines more than once; early : those it uses before; met : symbol ->
;; definitions expanded already; headers : symbol -> head of its definition; source : file of the
;; text.  A name is an identifier as its definition binds it, without the scopes of the present
;; expansion.
(struct definitions (shown repeated early met headers source))

(struct definition (name macro?))

(define (make-definitions s source)
  (definitions (by-symbol (map plain (survey-defined s)))
               (map plain (survey-repeated s))
               (map plain (all-early s))
               (make-hasheq)
               (survey-headers s)
               source))

(define (by-symbol names)
  (for/fold ([table (hasheq)]) ([name (in-list names)])
    (hash-update table (syntax-e name) (lambda (others) (cons name others)) '())))

(define (plain id)
  (syntax-local-identifier-as-binding (syntax-local-introduce id)))

;; ---------------------------------------------------------------------------
;; Definitions that are expanded

(define (defined? ds id) (and (definition-of ds (plain id)) #t))

(define (definition-of ds name)
  (findf (lambda (d) (bound-identifier=? name (definition-name d)))
         (hash-ref (definitions-met ds) (syntax-e name) '())))

(define (line-of-definition d) (syntax-line (definition-name d)))

;; A variable may be defined again, a macro may not, nor a variable as a macro.
(define (add-variable! ds id)
  (define name (plain id))
  (define before (definition-of ds name))
  (cond [(not before) (add! ds name #f)]
        [(definition-macro? before) (raise-defined-again before id)]))

(define (add-macro! ds id)
  (define name (plain id))
  (define before (definition-of ds name))
  (when before (raise-defined-again before id))
  (add! ds name #t))

(define (add! ds name macro?)
  (hash-update! (definitions-met ds) (syntax-e name)
                (lambda (others) (cons (definition name macro?) others)) '()))

(define (raise-defined-again before id)
  (define line (line-of-definition before))
  (refuse id #f (string-append "already defined~a; in a module only variables and functions may be"
                               " defined again, not macros or structure types")
          (if line (format ", on line ~a" line) "")))

;; ---------------------------------------------------------------------------
;; Definitions in the text

;; Does the text define something of this name, a symbol?
(define (shows-definition? ds name) (and (hash-ref (definitions-shown ds) name #f) #t))

;; Where the text of the module defines this name first, or #f.
(define (defining-occurrence ds id)
  (define others (hash-ref (definitions-shown ds) (syntax-e id) '()))
  (define name (and (pair? others) (findf (same-name? (plain id)) others)))
  (and name (syntax-local-introduce name)))

;; -> its first call, by the text of its definition; and its line or #f
(define (definition-header-and-line ds id)
  (define before (definition-of ds (plain id)))
  (values (hash-ref (definitions-headers ds) (syntax-e id) (syntax-e id))
          (and before (line-of-definition before))))

;; Is it used before its definition?
(define (used-early? ds id)
  (and (findf (same-name? (plain id)) (definitions-early ds)) #t))

;; The form, marked if it is one of several definitions of a name: the name must be a variable,
;; while Racket makes a macro of a function with keywords.
(define (mark-variable ds form)
  (define id (defined-by-define form))
  (define name (and id (plain id)))
  (if (and name
           (or (findf (same-name? name) (definitions-repeated ds)) (definition-of ds name)))
      (syntax-property form 'as-variable #t)
      form))

;; ---------------------------------------------------------------------------
;; Lines

;; The line of the form in the module's text; of a form made by a macro, that of its first part
;; in the text; or #f.
(define (line-in ds form)
  (let find ([form form])
    (cond [(not (syntax? form)) (and (pair? form) (or (find (car form)) (find (cdr form))))]
          [(equal? (syntax-source form) (definitions-source ds)) (syntax-line form)]
          [else (find (syntax-e form))])))
