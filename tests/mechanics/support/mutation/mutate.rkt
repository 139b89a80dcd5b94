#lang racket/base
;; Does the suite notice when the algebra is wrong?
;;
;; A *mutant* is the algebra with one piece of one file's text replaced.  It is
;; loaded into a namespace of its own: every module as it is compiled, but for the
;; mutated file, which is compiled from the changed text as it is loaded; files
;; and compiled code on disk stay as they are.  Then a part of the property
;; suite, loaded there too, must fail.
;;
;; A procedure so small that it was compiled into others' code would not be
;; replaced there: such a mutant survives, and the test that kills it fails.

(require racket/file
         racket/path
         racket/runtime-path
         racket/string
         syntax/modread
         "../patience.rkt")

(provide (struct-out mutant) occurrences try-mutant try-original load-replaced)

;; file : below mechanics/algebra; old occurs in it exactly once
(struct mutant (name file old new) #:transparent)

(define-runtime-path algebra "../../../../mechanics/algebra")
(define-runtime-path probe-file "probe.rkt")

(define (mutant-path m) (simple-form-path (build-path algebra (mutant-file m))))

;; How often the text to be replaced occurs.
(define (occurrences m)
  (length (regexp-match* (regexp-quote (mutant-old m)) (file->string (mutant-path m)))))

;; -> what failed, or #f if nothing did.  The mutant itself must load.
(define (try-mutant m)
  (define text (string-replace (file->string (mutant-path m)) (mutant-old m) (mutant-new m)))
  (run-probe (mutant-path m) text))

(define (try-original) (run-probe #f #f))

;; Modules of the probe that are no part of the algebra are shared.
(define shared-modules '(racket/base racket/list racket/cmdline racket/fixnum))

(define (run-probe path text)
  (define here (variable-reference->namespace (#%variable-reference)))
  (define there (make-base-empty-namespace))
  (for ([m (in-list shared-modules)]) (share here there m #t))
  (share here there 'math/bigfloat #f)
  (parameterize ([current-namespace there]
                 [current-load/use-compiled
                  (load-replaced path text (current-load/use-compiled))])
    (limited (dynamic-require (simple-form-path probe-file) 'probe))))

(define (share here there m needed?)
  (with-handlers ([exn:fail? (lambda (x) (when needed? (raise x)))])
    (parameterize ([current-namespace here]) (dynamic-require m #f))
    (namespace-attach-module here m there)))

;; A load handler that takes the text for the file of that path.
(define ((load-replaced path text otherwise) file name)
  (cond [(not (and path (equal? path (simple-form-path file)))) (otherwise file name)]
        [(pair? name) (void)]           ; a submodule, if there is one
        [else
         (define port (open-input-string text))
         (port-count-lines! port)
         (define form
           (check-module-form
            (with-module-reading-parameterization (lambda () (read-syntax file port)))
            name file))
         (parameterize ([current-load-relative-directory (path-only path)]
                        [current-module-declare-name (make-resolved-module-path path)])
           (eval form))]))

;; A mutant that does not end has been noticed too.
(define (limited thunk) (value-within 60 2000 thunk "it does not end"))
