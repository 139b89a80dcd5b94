#lang racket/base
;; Names that other libraries of this package, or Racket's, define, which a program may have
;; forgotten to require.  Only for an unknown name their exports are listed, which loads their
;; declarations and runs nothing.

(provide library-of Racket-library-of exports)

(define libraries
  '(mechanics/plot mechanics/animate mechanics/pict mechanics/book mechanics/geometry))
(define Racket-libraries
  '(racket/list racket/string racket/math racket/vector racket/function racket/format racket/file
    racket/port))

;; -> a library that exports the name, or #f
(define (library-of name) (exporter name libraries))
(define (Racket-library-of name) (exporter name Racket-libraries))

(define (exporter name libraries)
  (findf (lambda (library) (memq name (exports library))) libraries))

;; The exported names of phase 0; none if a library that it needs is not installed.
(define (exports library)
  (with-handlers ([exn:fail:filesystem? (lambda (e) '())])
    (module-declared? library #t)
    (define-values (variables syntaxes) (module->exports library))
    (for*/list ([phase (in-list (append variables syntaxes))]
                #:when (eqv? 0 (car phase))
                [exported (in-list (cdr phase))])
      (car exported))))
