#lang racket/base
;; Names without a definition.  The commonest is a symbol whose quote was forgotten, as in
;; (L-harmonic m k): so the message says how a symbol is written, that of the expander in a module
;; and that of the error display at the prompt.  Suggestions of other names come first.
;;
;; Beneath a message the error display shows the place in the reader's own program, not calls in
;; libraries.

(require (for-syntax racket/base
                     "suggestion.rkt")
         (only-in racket/path file-name-from-path)
         "../paper-notation/expansion-advice.rkt" "../wrong-call/call-hint.rkt" "suggestion.rkt"
         "../../error/message-words.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["other-hint.rkt" hint-for-syntax hint-for-value hint-for-module]
                   ["known-name.rkt" known-name?]
                   ["../paper-notation/pasted-result.rkt" pasted-sentence]
                   ["unreadable.rkt" unreadable]
                   ["../wrong-call/error-location.rkt" whereabouts])

(provide (rename-out [top #%top])
         install-hints! note-entry! explained)

;; ---------------------------------------------------------------------------
;; In a module

;; Among definitions, a name may be one that is defined further down: it is
;; looked up again when all of them are known.
(define-syntax (top stx)
  (syntax-case stx ()
    [(_ . id)
     (identifier? #'id)
     (cond
       [(or (not (syntax-transforming-module-expression?)) (identifier-binding #'id))
        (let ([advice (or (advice-on #'id) (advice-on-name #'id))])
          (if advice
              (quasisyntax/loc stx (advised #,advice (#%top . id)))
              (syntax/loc stx (#%top . id))))]
       [(eq? (syntax-local-context) 'expression) (raise-unbound #'id)]
       [else (syntax/loc stx (#%expression id))])]
    [(_ . other) (syntax/loc stx (#%top . other))]))

(begin-for-syntax
  (define (raise-unbound id)
    (define name (syntax-e id))
    (define sentences (what-was-meant name (syntax-bound-symbols id)
                                      (or (advice-on id) (advice-on-name id))))
    (raise-syntax-error #f (string-append "unbound identifier; " (in-one-line sentences))
                        id #:exn exn:fail:syntax:unbound))

  ;; A question ends by itself.
  (define (in-one-line sentences)
    (define first-one (car sentences))
    (if (null? (cdr sentences))
        first-one
        (string-append first-one
                       (if (regexp-match? #rx"[?]$" first-one) " " "; ")
                       (in-one-line (cdr sentences))))))

;; ---------------------------------------------------------------------------
;; At the prompt

;; A value of `error-display-handler`; `other` is the handler it wraps; `entry` is the form
;; that was typed last, a datum, or #f.
(struct hinting-display (other [entry #:mutable])
  #:property prop:procedure
  (lambda (display message e)
    (define other (hinting-display-other display))
    (define told (explained message e (hinting-display-entry display)))
    (define told-e (if (equal? told message) e (with-message e told)))
    ;; DrRacket shows calls in its own way
    (if (port-writes-special? (current-error-port))
        (other told told-e)
        (parameterize ([error-print-context-length 0])
          (other (string-append told (if (exn:fail? e) (whereabouts e) "")) told-e)))))

;; The message in our words, with hints.
(define (explained message e entry)
  (cond [(exn:fail:read? e)
         (define-values (line problem) (unreadable e))
         (format "~a: ~a" (or (place-in-file e) "read") problem)]
        [else
         (string-append (if (exn:fail:contract? e) (in-our-words message e) message)
                        (or (hint-for message e entry) ""))]))

;; exn:fail:read -> the file and line that could not be read; #f for typed text
(define (place-in-file e)
  (for/or ([place (in-list (exn:fail:read-srclocs e))])
    (and (path? (srcloc-source place))
         (format "~a, line ~a" (file-name-from-path (srcloc-source place)) (srcloc-line place)))))

;; Makes the current error display ours.  Idempotent.
(define (install-hints!)
  (define display (error-display-handler))
  (unless (hinting-display? display)
    (error-display-handler (hinting-display display #f))))

;; Keeps the form that was typed, for hints if it fails.
(define (note-entry! form)
  (define display (error-display-handler))
  (when (hinting-display? display) (set-hinting-display-entry! display form)))

(define (hint-for message e entry)
  (cond [(regexp-match? #rx"^instantiate-linklet: mismatch" message) hint-for-half-made]
        [(exn:fail:contract:variable? e)
         (define id (exn:fail:contract:variable-id e))
         (cond [(regexp-match? #rx"cannot reference an identifier before its definition" message)
                (hint-for-unknown id message (advice-in (exn-continuation-marks e)) entry)]
               [(regexp-match? #rx"cannot re-define a constant" message) (hint-for-constant id)]
               [else (hint-for-value message)])]
        [(exn:fail:contract? e) (or (hint-for-call message e entry) (hint-for-value message))]
        [(exn:fail:syntax:missing-module? e) (hint-for-module message)]
        [(exn:fail:syntax? e) (hint-for-syntax message)]
        [(exn:fail:filesystem:missing-module? e) (hint-for-module message)]
        [else (hint-for-value message)]))

;; A module whose body failed lacks definitions that other modules need.
(define hint-for-half-made
  (string-append "\n  a library that this stands on could not be loaded earlier, and said why;"
                 "\n  when that is mended, start a new session"))

;; For names unknown at the prompt, not for names that a module uses too early: they need no quote.
;; advice : on the form around the name, or #f; entry : the form that was typed
(define (hint-for-unknown id message advice entry)
  (define pasted (and entry (not advice) (pasted-sentence entry known-name?)))
  (and (or (regexp-match? #rx"in module: top-level$" message)
           (unknown-in-module? id))
       (joined (cons "" (what-was-meant id (namespace-mapped-symbols) advice pasted)) "\n  ")))

;; The compiler builds a variable that is defined once into its uses.
(define (hint-for-constant id)
  (format (string-append
           "\n  the module was compiled with ~s as it is: change it there and run it again, or"
           "\n  in DrRacket switch off \"Enforce constant definitions\""
           " in Choose Language, Show Details")
          id))

;; Is the prompt inside a module, as in DrRacket, which does not define the name?  A
;; namespace may lack even #%variable-reference.
(define (unknown-in-module? id)
  (with-handlers ([exn:fail:syntax? (lambda (e) #f)])
    (and (variable-reference->module-source (eval '(#%variable-reference)))
         (not (identifier-binding (namespace-symbol->identifier id))))))

(define (with-message e message)
  (define marks (exn-continuation-marks e))
  (cond [(exn:fail:contract:variable? e)
         (exn:fail:contract:variable message marks (exn:fail:contract:variable-id e))]
        [(exn:fail:syntax? e) (exn:fail:syntax message marks (exn:fail:syntax-exprs e))]
        [(exn:fail:filesystem? e) (exn:fail:filesystem message marks)]
        [(exn:fail:read? e) (exn:fail:read message marks (exn:fail:read-srclocs e))]
        [else (exn:fail:contract message marks)]))
