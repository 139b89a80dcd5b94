#lang racket/base
;; Names at the prompt: is a name known, for a function, and from which module?

(require (only-in "../redefinition/prompt.rkt" variable-name?)
         (only-in "../../generic/up-down.rkt" tuple?))

(provide known-name? function-name? defining-module procedure-called)

(define (known-name? name)
  (or (and (identifier-binding (namespace-symbol->identifier name)) #t)
      (variable-name? name)))

;; -> path or symbol of the module that defines the name, or #f if no module does
(define (defining-module name)
  (define binding
    (with-handlers ([exn:fail? (lambda (e) #f)])
      (identifier-binding (namespace-symbol->identifier name))))
  (define place
    (and (pair? binding)
         (resolved-module-path-name (module-path-index-resolve (car binding)))))
  (if (pair? place) (car place) place))

;; name : text in a message -> procedure or #f
;; The name is evaluated, for a function with keywords is a macro.
(define (procedure-called name)
  (define (unknown e) #f)
  (with-handlers ([exn:fail:contract:variable? unknown] [exn:fail:syntax? unknown])
    (define f (eval (namespace-symbol->identifier (string->symbol name))))
    (and (procedure? f) f)))

;; Does the name have a function for its value?
(define (function-name? name)
  (define x (namespace-variable-value name #t (lambda () #f)))
  (and (procedure? x) (not (tuple? x))))
