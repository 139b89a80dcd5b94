#lang racket/base
;; A keyword that a procedure does not take: Racket's message names the procedure.  Where
;; the prompt knows one of that name, those that it takes are told.

(require "spelling.rkt")

(provide hint-for-keyword)

;; -> lines to add to the message, or #f
(define (hint-for-keyword message)
  (define found
    (regexp-match
     #rx"^application: procedure does not expect an argument with given keyword\n  procedure: ([^ \n]+)\n  given keyword: #:([^ \n]+)"
     message))
  (define known (if found (keywords-of (string->symbol (cadr found))) '()))
  (and (pair? known) (hint (caddr found) known)))

(define (hint given known)
  (define likely (likely-names (string->symbol given) (map bare known)))
  (if (null? likely)
      (format "\n  its keywords: ~s" known)
      (format "\n  did you mean ~a?" (alternatives (map dressed likely)))))

(define (bare k) (string->symbol (keyword->string k)))
(define (dressed name) (string->symbol (format "#:~a" name)))

;; In the order of the alphabet.
(define (keywords-of name)
  (with-handlers ([exn:fail? (lambda (e) '())])
    (define-values (required known) (procedure-keywords (eval (namespace-symbol->identifier name))))
    (or known '())))
