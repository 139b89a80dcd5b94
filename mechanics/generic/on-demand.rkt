#lang racket/base
;; Modules that are loaded when something of theirs is first called.
;;
;;     (require-on-demand [file name ...] ...)
;;     (provide-on-demand [file name ...] ...)
;;
;; define the names, procedures all, and require a file when one of its is called; the
;; second provides them, too.  [name here] instead of a name calls it `here`.  A procedure
;; with keywords is to be made by `define-plain` (define-plain.rkt says why).
;;
;; A break while modules are being made leaves them half made, and nothing in Racket takes
;; that up again: `lazy-require` would raise the break at every later call.  So a break
;; waits until they stand, some hundredths of a second.

(require (for-syntax racket/base)
         racket/runtime-path)

(provide require-on-demand provide-on-demand)

(define-syntax-rule (provide-on-demand [file name ...] ...)
  (begin (require-on-demand [file name ...] ...)
         (provide name ... ...)))

;; A submodule that nobody loads requires the files, so that they are compiled with the
;; module that has the form; once in a module, therefore.
(define-syntax-rule (require-on-demand [file name ...] ...)
  (begin (module compiled-too racket/base
           (require (for-label (only-in file) ...)))
         (require-clause [file name ...]) ...))

;; A runtime path, so that an executable has the file.
(define-syntax-rule (require-clause [file name ...])
  (begin
    (define-runtime-module-path-index index 'file)
    (define (value-of exported) (load-value (#%variable-reference) index exported))
    (define-on-demand value-of name) ...))

(define-syntax define-on-demand
  (syntax-rules ()
    [(_ value-of [name here]) (define here (called-later 'here (lambda () (value-of 'name))))]
    [(_ value-of name) (define-on-demand value-of [name name])]))

;; In the namespace of the module that asks: several may have the library loaded.
(define (load-value place index name)
  (define space (variable-reference->namespace place))
  (parameterize ([current-namespace space])
    (parameterize-break #f
      (namespace-call-with-registry-lock space (lambda () (dynamic-require index name))))))

;; A procedure named `name`, which is the one that `load` gives.
(define (called-later name load)
  (define loaded #f)
  (define (it)
    (unless loaded (set! loaded (load)))
    loaded)
  (define call
    (case-lambda [(x) ((it) x)]
                 [(x y) ((it) x y)]
                 [arguments (apply (it) arguments)]))
  (define (call-with names values . arguments) (keyword-apply (it) names values arguments))
  (procedure-rename (make-keyword-procedure call-with call) name))
