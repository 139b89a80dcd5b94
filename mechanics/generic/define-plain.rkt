#lang racket/base
;; Functions with keywords, to be loaded on demand.
;;
;; `define` makes a macro of such a function, so that a call of it costs nothing more than
;; one without.  A module that loads it on demand gains nothing by that; and to find out
;; that it is a macro, Racket instantiates all that the program needed when it was
;; compiled: some 40 ms at the first call.  What is defined here is a variable.
;;
;; What loads a function on demand takes any keyword, so that nothing can tell the caller
;; of a misspelt one what the function takes, but the function.

(provide define-plain telling-keywords)

;; (define-plain (name argument ...) body ...)
(define-syntax-rule (define-plain (name . arguments) body ...)
  (define-values (name) (telling-keywords 'name (lambda arguments body ...))))

;; f, by that name, with a message of its own for keywords that it does not take
(define (telling-keywords who f)
  (define-values (required known) (procedure-keywords f))
  (define (apply-checked names values . arguments)
    (for ([name (in-list names)])
      (unless (memq name known) (raise-unknown-keyword who name known)))
    (keyword-apply f names values arguments))
  (procedure-rename (if (null? known) f (make-keyword-procedure apply-checked f)) who))

(define (raise-unknown-keyword who name known)
  (raise
   (exn:fail:contract
    (format "~a: there is no keyword ~s here\n  its keywords: ~s" who name known)
    (current-continuation-marks))))
