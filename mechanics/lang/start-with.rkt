#lang racket/base
;; The first definition of a variable that will be replaced: as what is imported
;; under its name, unless that is a macro, which has no value.

(require (for-syntax racket/base))

(provide start-with)

(define-syntax (start-with stx)
  (syntax-case stx ()
    [(_ id imported)
     (if (syntax-local-value #'imported (lambda () #f))
         #'(begin)
         #'(define-values (id) imported))]))
