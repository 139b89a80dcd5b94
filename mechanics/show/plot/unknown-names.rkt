#lang racket/base
;; Which names of an expression a program would not know, as Racket's own expander sees it: those
;; that the expression binds itself are known.

(provide unknown-names)

;; source : a datum; modules : what the program requires, besides racket/base
;; namespace : where these modules are loaded or can be
;; Returns a sorted list of symbols, or a string that says why the source is no expression.
(define (unknown-names source modules namespace)
  (let look ([found '()])
    (define next (first-unknown source modules namespace found))
    (cond [(string? next) next]
          [(or (not next) (memq next found)) (sort found symbol<?)]
          [else (look (cons next found))])))

;; The expander reports one name at a time: names found so far are bound, and it runs again.
(define (first-unknown source modules namespace known)
  (define program
    (list #'module 'program 'racket/base
          (cons '#%require modules)
          (list 'lambda known (list 'lambda '() source))))
  (with-handlers ([exn:fail:syntax:unbound? name-of] [exn:fail:syntax? exn-message])
    (parameterize ([current-namespace namespace]
                   [current-load-relative-directory #f])
      (expand (datum->syntax #f program)))
    #f))

(define (name-of e)
  (define exprs (exn:fail:syntax-exprs e))
  (define name (and (pair? exprs) (syntax-e (car exprs))))
  (if (symbol? name) name (exn-message e)))
