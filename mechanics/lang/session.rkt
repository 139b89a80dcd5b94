#lang racket/base
;; The body of a `#lang mechanics` module, and the prompt.

(require "printer.rkt" "unbound.rkt"
         (only-in "pattern.rkt" [define define/pattern])
         syntax/wrap-modbeg
         (for-syntax racket/base))

(provide (rename-out [module-begin #%module-begin]
                     [top-interaction #%top-interaction])
         #%top)

;; ---------------------------------------------------------------------------
;; The prompt

;; `begin` is spliced at the top level, so that definitions are made there.
(define-syntax (top-interaction stx)
  (syntax-case stx ()
    [(_ . form)
     (eq? (syntax-local-context) 'top-level)
     #'(begin (#%plain-app install-session!) form)]
    [_ (raise-syntax-error #f "not at top level" stx)]))

(define (install-session!)
  (install-printer!)
  (install-hints!))

;; ---------------------------------------------------------------------------
;; Modules

;; Results of the module's expressions are printed by our printer; a program
;; run from this module has our session (unless the module brings its own).
(define-syntax (module-begin stx)
  (syntax-case stx ()
    [(_ form ...)
     (let ([forms (syntax->list #'(form ...))])
       (check-defined-once forms)
       (with-syntax ([(configuration ...)
                      (if (ormap configuration? forms)
                          '()
                          #'((module configure-runtime '#%kernel
                               (#%require mechanics/lang/runtime))))])
         (syntax/loc stx
           (printing-module-begin configuration ... form ...))))]
    [_ (raise-syntax-error #f "bad syntax" stx)]))

(define-syntax printing-module-begin
  (make-wrapping-module-begin #'print-results))

(define-syntax (print-results stx)
  (syntax-case stx ()
    [(_ expression)
     #'(#%plain-app call-with-values (lambda () expression) print-and-return)]))

(define (print-and-return . results)
  (for-each print-result results)
  (apply values results))

(begin-for-syntax
  (define (configuration? form)
    (syntax-case form ()
      [(head name . _)
       (and (identifier? #'head)
            (or (free-identifier=? #'head #'module)
                (free-identifier=? #'head #'module*))
            (eq? (syntax-e #'name) 'configure-runtime))]
      [_ #f])))

;; ---------------------------------------------------------------------------
;; One definition a name

(begin-for-syntax
  ;; Readers of a book redefine; Racket's own message does not say that they
  ;; may, elsewhere.
  (define (check-defined-once forms)
    (for/fold ([seen (hasheq)]) ([form (in-list (definitions forms))])
      (define id (defined-name form))
      (define before (hash-ref seen (syntax-e id) '()))
      (define first-one
        (for/or ([other (in-list before)]) (and (bound-identifier=? id other) other)))
      (when first-one (raise-defined-twice id first-one form))
      (hash-set seen (syntax-e id) (cons id before))))

  (define (raise-defined-twice id first-one form)
    (define line (syntax-line first-one))
    (raise-syntax-error
     #f
     (format "~a is already defined in this module~a; a module defines a name once, while at the prompt a new definition replaces the old"
             (syntax-e id) (if line (format ", on line ~a" line) ""))
     form id))

  ;; The definitions among these forms, those inside `begin` included.
  (define (definitions forms)
    (for/fold ([found '()] #:result (reverse found)) ([form (in-list forms)])
      (syntax-case form (begin)
        [(begin inner ...)
         (append (reverse (definitions (syntax->list #'(inner ...)))) found)]
        [_ (if (defined-name form) (cons form found) found)])))

  ;; The name that a form defines, or #f if it is no `define`.
  (define (defined-name form)
    (syntax-case form ()
      [(keyword head . _)
       (and (identifier? #'keyword)
            (or (free-identifier=? #'keyword #'define/pattern)
                (free-identifier=? #'keyword #'define)))
       (let name ([head #'head])
         (syntax-case head ()
           [(inner . _) (name #'inner)]
           [_ (and (identifier? head) head)]))]
      [_ #f])))
