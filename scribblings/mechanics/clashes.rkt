#lang racket/base
;; Which names mechanics shares with other libraries, read off the libraries, and
;; the `require` that settles each case.

(require racket/list
         scribble/base)

(provide clash-lines shared-names replaced-names)

;; The names both modules export with different meanings.
(define (shared-names a b)
  (define ours (exports a))
  (define theirs (exports b))
  (sort (for/list ([(name where) (in-hash ours)]
                   #:when (and (hash-has-key? theirs name)
                               (not (equal? where (hash-ref theirs name)))))
          name)
        symbol<?))

;; name -> where it is defined
(define (exports module-path)
  (define ns (make-base-empty-namespace))
  (parameterize ([current-namespace ns])
    (namespace-require `(for-label ,module-path))
    (define-values (variables syntaxes) (declared-exports module-path))
    (for*/hasheq ([phase (in-list (append variables syntaxes))]
                  #:when (eqv? (car phase) 0)
                  [export (in-list (cdr phase))])
      (define name (car export))
      (define binding
        (identifier-label-binding (namespace-symbol->identifier name)))
      (values name
              (list (resolved-module-path-name (module-path-index-resolve (car binding)))
                    (cadr binding))))))

(define (declared-exports module-path)
  (module-declared? module-path #t)
  (module->exports module-path))

;; The names of racket/base that mean more here, but for those given, which mean something
;; else; and but for those of Racket's own machinery, which nobody writes.
(define (replaced-names . others)
  (define names
    (for/list ([name (in-list (shared-names 'mechanics 'racket/base))]
               #:unless (or (memq name others) (regexp-match? #rx"^#%" (symbol->string name))))
      (tt (symbol->string name))))
  (add-between names ", "))

;; For each library that shares names with ours, the `require` that leaves them out.
(define (clash-lines #:with [ours 'mechanics] . libraries)
  (apply verbatim #:indent 2
         (add-between
          (for*/list ([library (in-list libraries)]
                      [names (in-value (shared-names ours library))]
                      #:unless (null? names))
            (format "~s" `(require ,ours (except-in ,library ,@names))))
          "\n")))
