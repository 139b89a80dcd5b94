#lang racket/base
;; The procedure that the prompt knows by a name that a message tells.

(provide procedure-called)

;; name : text -> procedure or #f
;; The name is evaluated, for a function with keywords is a macro.
(define (procedure-called name)
  (define (unknown e) #f)
  (with-handlers ([exn:fail:contract:variable? unknown] [exn:fail:syntax? unknown])
    (define f (eval (namespace-symbol->identifier (string->symbol name))))
    (and (procedure? f) f)))
