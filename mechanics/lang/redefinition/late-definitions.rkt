#lang racket/base
;; Definitions that a module knows from its first line on, and a session does not: of macros, and of
;; names that the language has, too.  A function above such a definition that uses the name means
;; another thing in a session, where its forms are run one after the other.

(require (for-syntax racket/base racket/list
                     "binding-forms.rkt" "names-used.rkt" "../imported-name.rkt"))

(provide late-definitions)

;; (late-definitions form ...) : the body of a program, in the context of its language
;; -> ((name line-of-use line-of-definition) ...), by the lines of the first use
(define-syntax (late-definitions stx)
  (define forms (filter (lambda (f) (not (of-a-file? f))) (cdr (syntax->list stx))))
  (define found
    (for*/list ([(form k) (in-parallel forms (in-naturals))]
                [later (in-value (known-in (list-tail forms (+ k 1))))]
                [name (in-list (names-in form (without later (known-in (take forms (+ k 1))))))])
      (list name (syntax-line form) (hash-ref later name))))
  (define in-order (sort (sort found < #:key caddr) < #:key cadr))
  #`'#,(remove-duplicates in-order #:key car))

(begin-for-syntax
  ;; name -> line of its first definition
  (define (known-in forms)
    (for*/fold ([known (hasheq)]) ([f (in-list (reverse forms))]
                                   [id (in-value (known-at-once f))] #:when id)
      (hash-set known (syntax-e id) (syntax-line f))))

  (define (without table names)
    (for/fold ([table table]) ([name (in-hash-keys names)]) (hash-remove table name)))

  ;; -> identifier or #f
  (define (known-at-once form)
    (define id (defined-by-define form))
    (syntax-case form ()
      [_ id (and (imported? id) id)]
      [(keyword (name . _) . _) (and (defines-macro? #'keyword) (identifier? #'name)) #'name]
      [(keyword name . _) (and (defines-macro? #'keyword) (identifier? #'name)) #'name]
      [_ #f]))

  (define (defines-macro? id) (among? id (list #'define-syntax #'define-syntax-rule)))

  (define (of-a-file? form)
    (syntax-case form ()
      [(keyword . _)
       (and (identifier? #'keyword) (memq (syntax-e #'keyword) '(module module* module+ provide)))]
      [_ #f])))
