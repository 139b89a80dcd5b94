#lang racket/base
;; Names from outside the module that is expanded.

(provide imported?)

;; Is it bound by the language, by `require`, or by the module around a submodule?
(define (imported? id)
  (define binding (identifier-binding id))
  (and (pair? binding)
       (let-values ([(path base) (module-path-index-split (car binding))])
         (and path #t))))
