#lang racket/base
;; The names that a module exports, and which of them are not Racket's own.

(provide export-table own-names)

;; Exports that are Racket's own bindings are documented there.
(define rackets-own '(racket/base racket/match))

;; name -> where it is defined, for all that a module exports at phase 0.
(define (export-table module-path)
  (parameterize ([current-namespace (make-base-empty-namespace)])
    (dynamic-require module-path (void))
    (namespace-require module-path)
    (define-values (variables syntaxes) (module->exports module-path))
    (for*/hasheq ([phase (in-list (append variables syntaxes))]
                  #:when (eqv? (car phase) 0)
                  [export (in-list (cdr phase))])
      (define name (car export))
      (values name (definition name)))))

(define (definition name)
  (define binding (identifier-binding (namespace-symbol->identifier name)))
  (list (resolved-module-path-name (module-path-index-resolve (car binding)))
        (cadr binding)))

;; The names a module exports that are not Racket's own.  Those that begin with
;; #% serve the language and are not typed by anyone.
(define (own-names module-path)
  (define tables (map export-table rackets-own))
  (for/list ([(name where) (in-hash (export-table module-path))]
             #:unless (regexp-match? #rx"^#%" (symbol->string name))
             #:unless (for/or ([table (in-list tables)])
                        (equal? where (hash-ref table name #f))))
    name))
