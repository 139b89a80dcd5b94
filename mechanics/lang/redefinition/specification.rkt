#lang racket/base
;; The specifications of a `require`, before it is expanded.

(require (only-in racket/list remove-duplicates)
         racket/require-transform)

(provide names-imported distinct-specifications)

;; The identifiers that a specification imports into the module or the session; #f where it is
;; wrong, or of a library that cannot be read: `require` itself will say so.
(define (names-imported spec)
  (define (none e) #f)
  (with-handlers ([exn:fail:syntax? none] [exn:fail:filesystem? none])
    (define-values (imports sources) (expand-import spec))
    (for/list ([i (in-list imports)] #:when (eqv? 0 (import-mode i))) (import-local-id i))))

;; Each specification once.
(define (distinct-specifications specs) (remove-duplicates specs #:key syntax->datum))
