#lang racket/base
;; Calls that a procedure with keywords does not take.  Racket's message names the procedure
;; and the keyword it does not know; of a number of arguments it says no more than that
;; another is expected, where several are.  If the prompt knows a procedure of that name,
;; what it takes is told.

(require "spelling.rkt"
         "../../generic/function.rkt")

(provide hint-for-call)

;; -> lines to add to the message, or #f
(define (hint-for-call message)
  (or (hint-for-keyword message) (hint-for-arity message)))

;; ---------------------------------------------------------------------------
;; Keywords

(define unknown-keyword
  (regexp
   (string-append "^application: procedure does not expect an argument with given keyword\n"
                  "  procedure: ([^ \n]+)\n  given keyword: #:([^ \n]+)")))

(define (hint-for-keyword message)
  (define found (regexp-match unknown-keyword message))
  (define known (if found (keywords-of (procedure-called (cadr found))) '()))
  (and (pair? known) (keyword-hint (caddr found) known)))

;; In the order of the alphabet.
(define (keywords-of f)
  (define-values (required known) (if f (procedure-keywords f) (values '() '())))
  (or known '()))

(define (keyword-hint given known)
  (define likely (likely-names (string->symbol given) (map bare known)))
  (if (null? likely)
      (format "\n  its keywords: ~s" known)
      (format "\n  did you mean ~a?" (alternatives (map dressed likely)))))

(define (bare k) (string->symbol (keyword->string k)))
(define (dressed name) (string->symbol (format "#:~a" name)))

;; ---------------------------------------------------------------------------
;; Numbers of arguments

(define another-number
  (regexp
   (string-append "^([^ \n]+): arity mismatch;\n"
                  " the expected number of arguments does not match the given number\n"
                  "  expected: a different number plus")))

;; The same where keywords are given.
(define no-case
  #rx"^application: no case matching [0-9]+ non-keyword arguments?\n  procedure: ([^ \n]+)")

(define (hint-for-arity message)
  (define found (or (regexp-match another-number message) (regexp-match no-case message)))
  (define f (and found (procedure-called (cadr found))))
  (and f (format "\n  it takes ~a" (arity->text f))))

;; ---------------------------------------------------------------------------
;; -> the procedure that the prompt knows by this name, or #f
;; It is evaluated, for a function with keywords is a macro.
(define (procedure-called name)
  (define (unknown e) #f)
  (with-handlers ([exn:fail:contract:variable? unknown] [exn:fail:syntax? unknown])
    (define f (eval (namespace-symbol->identifier (string->symbol name))))
    (and (procedure? f) f)))
