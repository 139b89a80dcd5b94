#lang racket/base
;; The first definition of a variable that will be replaced: as the imported value of its name,
;; unless that is a macro without a value.  (A function with keywords is a macro with a value.)

(require (for-syntax racket/base))

(provide start-with)

(define-syntax (start-with stx)
  (syntax-case stx ()
    [(_ id imported)
     (if (expression? #'imported)
         #'(define-values (id) imported)
         #'(begin))]))

(define-for-syntax (expression? id)
  (or (not (syntax-local-value id (lambda () #f)))
      (with-handlers ([exn:fail:syntax? (lambda (e) #f)])
        (local-expand id 'expression '())
        #t)))
