#lang racket/base
;; Names that other libraries of this package define, for whoever forgot to require one.
;; A library is asked for its exports when a name turns out to be unknown, which loads its
;; declaration and runs nothing.

(provide library-of exports)

(define libraries '(mechanics/plot mechanics/animate mechanics/pict mechanics/book))

;; -> a library that exports the name, or #f
(define (library-of name)
  (for/first ([library (in-list libraries)] #:when (memq name (exports library))) library))

;; None if a library that it stands on is not installed.
(define (exports library)
  (with-handlers ([exn:fail:filesystem? (lambda (e) '())])
    (module-declared? library #t)
    (define-values (variables syntaxes) (module->exports library))
    (append (names variables) (names syntaxes))))

;; Of exports as `module->exports` tells them, those of phase 0.
(define (names exports)
  (map car (cdr (or (assv 0 exports) '(0)))))
