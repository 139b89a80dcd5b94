#lang racket/base
;; Functions that tell themselves which arguments they take: those with keywords, loaded on demand,
;; and those that are drawn with.
;;
;; `define` makes a macro of such a function, so that a call of it costs nothing more than
;; one without.  A module that loads it on demand gains nothing by that; and to find out
;; that it is a macro, Racket instantiates all that the program needed when it was
;; compiled: some 40 ms at the first call.  `define-plain` makes a variable.
;;
;; A module that loads a function on demand passes on any keywords and any number of arguments.
;; So the function itself says which ones it takes.

(require "former-arguments.rkt" "function.rkt"
         "../error/complain.rkt")

(provide define-plain telling-what-it-takes)

;; (define-plain (name argument ...) body ...)
(define-syntax-rule (define-plain (name . arguments) body ...)
  (define-values (name) (telling-what-it-takes 'name (lambda arguments body ...))))

;; f by that name and with messages of its own
;; advice : keyword -> a line on its replacement where it is not accepted, or #f
(define (telling-what-it-takes who f #:advice [advice (lambda (name) #f)])
  (define-values (required known) (procedure-keywords f))
  (define mask (arity-mask f))
  (define (check-count arguments)
    (unless (bitwise-bit-set? mask (length arguments))
      (raise-other-count who f known (length arguments))))
  (define (apply-with names values . arguments)
    (for ([name (in-list names)])
      (unless (memq name known)
        (raise-unknown-keyword who name known (or (advice name) (former-keyword who name)))))
    (check-count arguments)
    (keyword-apply f names values arguments))
  (define (apply-without . arguments)
    (check-count arguments)
    (apply f arguments))
  (procedure-rename (make-keyword-procedure apply-with apply-without) who))

(define (raise-unknown-keyword who name known advice)
  (complain who "there is no keyword ~s here~a~a" name
            (keywords->text known) (on-its-line advice)))

(define (raise-other-count who f known n)
  (complain-of-arity who "takes ~a; it was given ~a~a~a" (arity->text f)
                     (if (= n 0) "none" n) (keywords->text known)
                     (on-its-line (former-count who n))))

(define (on-its-line advice) (if advice (string-append "\n  " advice) ""))

(define (keywords->text known)
  (if (null? known) "" (format "\n  its keywords: ~s" known)))
