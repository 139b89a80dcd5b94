#lang racket/base
;; Habits of the source that can be checked by reading it.  Each rule takes the name of a
;; file and its module as syntax, and gives sentences: what is wrong, and where.

(require racket/list
         racket/match
         racket/string
         "library.rkt")

(provide wholesale-provides bare-errors Racket-complaints dynamic-requires assigned-exports
         facade-code handmade-raises outward-requires source-rules
         twin-definitions twin-names long-functions)

;; ---------------------------------------------------------------------------
;; Looking

;; All parts of a form for which (find part) is not #f, with line numbers.
(define (findings name form find)
  (let walk ([s form])
    (define here (and (syntax? s) (find s)))
    (define parts (if (syntax? s) (syntax-e s) s))
    (append (if here (list (format "~a:~a: ~a" name (syntax-line s) here)) '())
            (if (pair? parts)
                (append (walk (car parts)) (walk (cdr parts)))
                '()))))

(define (head? s name)
  (define parts (syntax-e s))
  (and (pair? parts) (syntax? (car parts)) (eq? (syntax-e (car parts)) name)))

;; The datum of the part with this index.
(define (part s index)
  (define parts (syntax->datum s))
  (and (list? parts) (> (length parts) index) (list-ref parts index)))

;; (module name language form ...), where the forms may be in a #%module-begin.
(define (module-body form)
  (define forms (cdddr (syntax->list form)))
  (if (and (= (length forms) 1)
           (regexp-match? #rx"module-begin"
                          (format "~a" (part (car forms) 0))))
      (cdr (syntax->list (car forms)))
      forms))

;; ---------------------------------------------------------------------------
;; Rules on one file

(define (wholesale-provides name form)
  (findings name form
            (lambda (s) (and (eq? (syntax-e s) 'all-defined-out)
                             "all-defined-out hides what the module is for"))))

(define (bare-errors name form)
  (findings name form
            (lambda (s) (and (head? s 'error) (string? (part s 1))
                             "(error \"...\") does not say who complains"))))

;; Of our own mistakes `raise-argument-error` may speak; book/ is written as its readers write.
(define (Racket-complaints name form)
  (if (string-prefix? name "book/")
      '()
      (findings name form
                (lambda (s) (and (eq? (syntax-e s) 'raise-arguments-error)
                                 "raise-arguments-error; use complain-showing")))))

;; error/ is below the floor of require-on-demand.
(define (dynamic-requires name form)
  (if (or (string-prefix? name "lang/")
          (member name '("generic/on-demand.rkt" "error/compiling-note.rkt")))
      '()
      (findings name form
                (lambda (s) (and (head? s 'dynamic-require)
                                 "dynamic-require hides a dependency; use require-on-demand")))))

;; Racket itself refuses set! on what is imported.
(define (assigned-exports name form)
  (define exported (exported-names (syntax->datum form)))
  (findings name form
            (lambda (s) (and (head? s 'set!) (memq (part s 1) exported)
                             (format "set! on ~a, which is exported" (part s 1))))))

(define (exported-names form)
  (define (names spec)
    (cond [(symbol? spec) (list spec)]
          [(and (pair? spec) (eq? (car spec) 'rename-out)) (map car (cdr spec))]
          [else '()]))
  (cond [(not (pair? form)) '()]
        [(and (eq? (car form) 'provide) (list? form)) (append-map names (cdr form))]
        [else (append (exported-names (car form)) (exported-names (cdr form)))]))

(define facade-forms '(require tell-if-uncompiled provide module module* module+))

;; A facade only requires, provides and tells that it is not compiled; submodules serve the
;; reader and the printer.
(define (facade-code name form)
  (if (facade? name)
      (for/list ([s (in-list (module-body form))]
                 #:unless (and (pair? (syntax-e s))
                               (memq (syntax-e (car (syntax-e s))) facade-forms)))
        (format "~a:~a: a facade holds only require and provide" name (syntax-line s)))
      '()))

;; Exceptions are made in error/, in one way each; and where one of their own is defined, as
;; a signal between two files.
(define (handmade-raises name form)
  (define own (defined-structs (syntax->datum form)))
  (define (by-hand? raised)
    (and (pair? raised) (symbol? (car raised)) (not (memq (car raised) own))
         (regexp-match? #rx"^(make-)?exn(:|$)" (symbol->string (car raised)))))
  (if (string-prefix? name "error/")
      '()
      (findings name form
                (lambda (s)
                  (and (head? s 'raise) (by-hand? (part s 1))
                       "an exception made by hand; use complain, or a failure of error/")))))

(define (defined-structs form)
  (cond [(not (pair? form)) '()]
        [(and (eq? (car form) 'struct) (pair? (cdr form))) (list (cadr form))]
        [else (append (defined-structs (car form)) (defined-structs (cdr form)))]))

;; Outward requires of the library are collections, which are there wherever it is installed.
(define (outward-requires name form)
  (define folders (- (length (string-split name "/")) 1))
  (define (leaves? path)
    (> (length (takef (string-split path "/") (lambda (part) (equal? part "..")))) folders))
  (findings name form
            (lambda (s)
              (define datum (syntax-e s))
              (and (or (and (string? datum) (regexp-match? #rx"[.]rkt$" datum) (leaves? datum))
                       (and (head? s 'file) (string? (part s 1))))
                   "a path that leads out of the library; require a collection"))))

(define source-rules
  (list wholesale-provides bare-errors Racket-complaints dynamic-requires assigned-exports
        facade-code
        handmade-raises outward-requires))

;; ---------------------------------------------------------------------------
;; Rules on all files together

;; Smaller functions than this, counted in symbols and numbers, may be written twice.
(define smallest 4)

;; Functions that are the same but for their names and those that they bind: a helper has one
;; home.  forms : ((name . module as syntax) ...)
(define (twin-definitions forms [smallest smallest])
  (define homes
    (for*/fold ([homes (hash)]) ([entry (in-list forms)]
                                 [s (in-list (module-body (cdr entry)))]
                                 [meaning (in-value (nameless (syntax->datum s) smallest))]
                                 #:when meaning)
      (hash-update homes meaning
                   (lambda (others) (cons (format "~a:~a" (car entry) (syntax-line s)) others))
                   '())))
  (for/list ([places (in-list (sort (filter pair? (map sort-places (hash-values homes)))
                                    string<? #:key car))]
             #:when (pair? (cdr places)))
    (format "the same function: ~a" (string-join places ", "))))

(define (sort-places places) (sort places string<?))

;; (define (f x ...) body ...) with all names that are bound in it replaced by their places,
;; in the order in which they come; or #f if it is no such definition or a small one.  Quoted names
;; are data.
(define (nameless form smallest)
  (and (list? form) (> (length form) 2) (eq? (car form) 'define) (pair? (cadr form))
       (>= (atoms (cddr form)) smallest)
       (let ([bound (remove-duplicates (bound-names form))])
         (replace (cdr form) (places-in (cdr form) bound)))))

(define (places-in x bound)
  (define seen
    (remove-duplicates (filter (lambda (a) (memq a bound)) (filter symbol? (flatten x)))))
  (for/hasheq ([name (in-list seen)] [i (in-naturals)])
    (values name (list 'place i))))

(define (replace x places)
  (cond [(and (pair? x) (eq? (car x) 'quote)) x]
        [(pair? x) (cons (replace (car x) places) (replace (cdr x) places))]
        [(symbol? x) (hash-ref places x x)]
        [else x]))

;; Names that a form binds, wherever in it: those of headers, formals and clauses.
(define (bound-names form)
  (if (pair? form)
      (append (bound-here form) (bound-names (car form)) (bound-names (cdr form)))
      '()))

(define (bound-here form)
  (match form
    [(list* (or 'define 'define-values 'lambda) header _) (header-names header)]
    [(list* 'let (? symbol? loop) clauses _) (cons loop (clause-names clauses))]
    [(list* (or 'for/fold 'for*/fold) results clauses _)
     (append (clause-names results) (clause-names clauses))]
    [(list* (? binder?) (? keyword?) _ clauses _) (clause-names clauses)]
    [(list* (? binder?) clauses _) (clause-names clauses)]
    [_ '()]))

(define (binder? x)
  (and (symbol? x) (regexp-match? #rx"^(let|for)(/|[*]|$|rec|-values)" (symbol->string x))))

;; Optional arguments are (name default), of which the default may name more than it binds.
(define (header-names header)
  (filter (lambda (x) (and (symbol? x) (not (eq? x '...)))) (flatten header)))

;; Clauses may follow #:when and its kin; several names stand in a list.
(define (clause-names clauses)
  (if (list? clauses)
      (append-map (lambda (c) (if (pair? c) (header-names (car c)) '())) clauses)
      '()))

(define (atoms x)
  (cond [(pair? x) (+ (atoms (car x)) (atoms (cdr x)))]
        [(null? x) 0]
        [else 1]))

;; Definitions that take more lines than `limit`, but for those that `allowed` names: tables.
(define (long-functions name form limit allowed)
  (for*/list ([s (in-list (module-body form))]
              [defined (in-value (defined-by s))]
              #:when defined
              [lines (in-value (- (last-line s) (syntax-line s) -1))]
              #:when (and (> lines limit) (not (memq defined allowed))))
    (format "~a:~a: ~a takes ~a lines" name (syntax-line s) defined lines)))

;; The name of the function that a form defines, or #f.
(define (defined-by s)
  (define d (syntax->datum s))
  (and (list? d) (> (length d) 2)
       (memq (car d) '(define define-plain define-syntax))
       (let name ([head (cadr d)]) (if (pair? head) (name (car head)) head))))

(define (last-line s)
  (cond [(syntax? s) (max (or (syntax-line s) 0) (last-line (syntax-e s)))]
        [(pair? s) (max (last-line (car s)) (last-line (cdr s)))]
        [else 0]))

;; One concept, one file name, unless the room makes the difference plain; `allowed` lists
;; those names.
(define (twin-names names allowed)
  (define (base name) (last (string-split name "/")))
  (for/list ([group (in-list (group-by base (sort names string<?)))]
             #:when (pair? (cdr group))
             #:unless (member (base (car group)) allowed))
    (format "one name for ~a" (string-join group ", "))))
