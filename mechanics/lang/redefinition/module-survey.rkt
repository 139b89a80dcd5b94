#lang racket/base
;; Definitions and uses in the forms of a module, as far as they are seen before expansion: which
;; names are defined more than once, and which are used too early.
;;
;; A form is run where it stands, but the body of a function where it is called.  So a form uses
;; the names in it, and with the name of a function or a macro that is defined already, the names
;; in that one.  Names that are not defined yet are used too early.

(require (only-in racket/list append* append-map remove-duplicates)
         (for-template racket/base)
         "binding-forms.rkt" "names-used.rkt")

(provide (struct-out survey) survey-forms all-early lines-of-repeated
         same-name?)

;; defined : the identifiers that `define` and `define-values` define, each where
;; it is defined first; repeated : those of them that are defined again; early :
;; for each form those that it uses before their definition; headers : symbol -> how the
;; first definition of it begins, as a datum.
(struct survey (defined repeated early headers))

(define (survey-forms forms)
  (define pieces (map read-pieces forms))
  (define all (append-map variables (append* pieces)))
  (define defined (remove-duplicates all bound-identifier=?))
  (survey defined (remq* defined all) (early-uses pieces defined) (headers forms)))

;; Of forms at the top level, not of forms within `begin`.
(define (headers forms)
  (for*/fold ([table (hasheq)]) ([form (in-list forms)]
                                 [id (in-value (defined-by-define form))]
                                 #:when (and id (not (hash-ref table (syntax-e id) #f))))
    (hash-set table (syntax-e id) (definition-header form))))

;; The lines of names that are defined several times -> ((name line line ...) ...)
(define (lines-of-repeated s)
  (for*/list ([first-one (in-list (survey-defined s))]
              [others (in-value (filter (same-name? first-one) (survey-repeated s)))]
              #:when (and (pair? others) (andmap syntax-line (cons first-one others))))
    (cons (syntax-e first-one) (sort (map syntax-line (cons first-one others)) <))))

;; All identifiers that are used early, in the order of their definitions.
(define (all-early s)
  (define early (append* (survey-early s)))
  (filter (lambda (id) (memq id early)) (survey-defined s)))

;; Is it the same name, in the same context?
(define ((same-name? id) other) (bound-identifier=? id other))

;; ---------------------------------------------------------------------------
;; Forms

;; A form that defines or is run.  ids : identifiers that it defines; variables? : as variables,
;; not as macros; run? : is a part of it run where it stands?; content : syntax with the names that
;; it uses.
(struct piece (ids variables? run? content))

(define (variables p) (if (piece-variables? p) (piece-ids p) '()))

;; The pieces of a form: none if it neither defines a name that is followed nor is run, several if
;; it is `begin`.
(define (read-pieces form)
  (syntax-case form (begin define-values)
    [(begin inner ...) (append-map read-pieces (syntax->list #'(inner ...)))]
    [(_ head . body)
     (defined-by-define form)
     (let ([run? (and (identifier? #'head) (run-by-definition? #'body))])
       (list (piece (list (defined-by-define form)) #t run? (if run? #'body form))))]
    [(define-values (id ...) value)
     (andmap identifier? (syntax->list #'(id ...)))
     (list (piece (syntax->list #'(id ...)) #t (run-by-definition? #'(value)) #'value))]
    [(keyword head . body)
     (and (among? #'keyword (list #'define-syntax #'define-syntax-rule)) (macro-name #'head))
     (list (piece (list (macro-name #'head)) #f #f #'body))]
    [(keyword . _) (among? #'keyword not-run) '()]
    [_ (list (piece '() #f #t form))]))

;; name or (name . formals) -> identifier, or #f
(define (macro-name head)
  (syntax-case head ()
    [(name . _) (identifier? #'name) #'name]
    [_ (and (identifier? head) head)]))

(define not-run
  (list #'require #'provide #'module #'module* #'module+ #'struct #'define-syntaxes
        #'begin-for-syntax #'define-for-syntax #'define-values-for-syntax))

;; ---------------------------------------------------------------------------
;; Early uses

;; pieces : for each form its pieces
(define (early-uses pieces defined)
  (define known
    (for*/hasheq ([ps (in-list pieces)] [p (in-list ps)] [id (in-list (piece-ids p))])
      (values (syntax-e id) #t)))
  (define met (make-hasheq))            ; name -> names in the function or macro
  (define (early? id reached)
    (define name (syntax-e id))
    (and (hash-ref reached name #f) (not (hash-ref met name #f))))
  (define (early-in p)
    (define names (names-in (piece-content p) known))
    (define reached (if (piece-run? p) (reachable names met) (hasheq)))
    (begin0 (filter (lambda (id) (early? id reached)) defined)
            (for ([id (in-list (piece-ids p))])
              (hash-update! met (syntax-e id)
                            (lambda (before) (if (piece-run? p) before (append names before)))
                            '()))))
  (for/list ([ps (in-list pieces)]) (append-map early-in ps)))

;; The names, the names in functions of these names, and further on: name -> #t.
(define (reachable names met)
  (define reached (make-hasheq))
  (let reach ([names names])
    (for ([name (in-list names)] #:unless (hash-ref reached name #f))
      (hash-set! reached name #t)
      (reach (hash-ref met name '()))))
  reached)
