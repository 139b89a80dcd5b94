#lang racket/base
;; Calls that a procedure does not take.  Racket's message names the procedure and the
;; keyword it does not know; of a number of arguments it says no more than that another is
;; expected, where several are.  A procedure of the library is known by its entry in the
;; manual (signature-hint.rkt).  Of another that the prompt knows, what it takes is told.

(require "spelling.rkt"
         "../../generic/function.rkt" "../../generic/on-demand.rkt")

(require-on-demand ["signature-hint.rkt" count-hint keyword-names constraint-hint])

(provide hint-for-call)

;; e : what was raised, with this message  -> lines to add, or #f
(define (hint-for-call message e)
  (or (hint-for-keyword message)
      (and (about-number? message e)
           (or (count-hint message) (hint-for-arity message)))
      (and (about-constraint? message) (constraint-hint message))
      (and (regexp-match? applied-number message) "\n  operations come first, as in (* 2 pi)")))

;; (pi * 2): names of the library are applied by Racket itself.
(define applied-number
  #rx"^application: not a procedure;\n[^\n]*\n  given: -?[0-9.:]")

(define (about-number? message e)
  (or (exn:fail:contract:arity? e) (regexp-match? no-case message)))

(define (about-constraint? message)
  (regexp-match? #rx"^[^ \n]+: contract violation\n.*\n  given: [(](non)?holonomic " message))

;; ---------------------------------------------------------------------------
;; Keywords

(define unknown-keyword
  (list
   (regexp
    (string-append "^application: procedure does not expect an argument with given keyword\n"
                   "  procedure: ([^ \n]+)\n  given keyword: #:([^ \n]+)"))
   #rx"^([^ \n]+): there is no keyword #:([^ \n]+) here"))

(define (hint-for-keyword message)
  (define found (for/or ([p (in-list unknown-keyword)]) (regexp-match p message)))
  (define known (if found (keywords-of (cadr found)) '()))
  (and (pair? known)
       (keyword-hint (caddr found) known (regexp-match? #rx"its keywords: " message))))

;; In the order of the alphabet, if the prompt knows the procedure.
(define (keywords-of name)
  (define f (procedure-called name))
  (define-values (required known) (if f (procedure-keywords f) (values '() '())))
  (if (pair? known)
      known
      (map (lambda (k) (string->keyword (substring (symbol->string k) 2)))
           (keyword-names (string->symbol name)))))

;; told? : does the message name them already
(define (keyword-hint given known told?)
  (define likely (likely-names (string->symbol given) (map bare known)))
  (define beginning
    (filter (lambda (k) (regexp-match? (regexp (string-append "^" (regexp-quote given)))
                                       (symbol->string k)))
            (map bare known)))
  (define meant (if (null? likely) beginning likely))
  (cond [(pair? meant) (format "\n  did you mean ~a?" (alternatives (map dressed meant)))]
        [told? #f]
        [else (format "\n  its keywords: ~s" known)]))

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
