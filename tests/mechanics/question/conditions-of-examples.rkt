#lang racket/base
;; Every verdict that an example, or an exercise, defines and that names conditions is proved
;; when it is asked again under them.

(require mechanics
         racket/file
         racket/port
         racket/runtime-path
         racket/string
         "../support/checks.rkt")

(define-runtime-path examples "../../../examples/mechanics")

(define (speaks-of-conditions? file)
  (and (regexp-match? #rx"[.]rkt$" (path->string file))
       (string-contains? (file->string file) "verdict-conditions")))

;; -> ((name . verdict) ...) that the module defines
(define (verdicts-of file)
  (parameterize ([current-namespace (make-base-namespace)]
                 [current-output-port (open-output-nowhere)])
    (namespace-attach-module (variable-reference->namespace (#%variable-reference)) 'mechanics)
    (dynamic-require file #f)
    (define inside (module->namespace file))
    (for*/list ([name (in-list (namespace-mapped-symbols inside))]
                [value (in-value (namespace-variable-value name #f (lambda () #f) inside))]
                #:when (verdict? value))
      (cons name value))))

(test-case "under their conditions the verdicts of the examples are proved"
  (define asked
    (for*/sum ([file (in-list (find-files speaks-of-conditions? examples))]
               [found (in-list (verdicts-of file))]
               [way (in-list (verdict-alternatives (cdr found)))])
      (with-check-info (['file file] ['name (car found)] ['way way])
        (check-pred proved? (verify-again (cdr found) way)))
      1))
  (check-true (>= asked 5) (format "~a" asked)))
