#lang racket/base
;; Hints on calls that a procedure does not take.  Racket's message names the procedure and the
;; unknown keyword; of a number of arguments it says only that another is expected, where several
;; are.  The signature of a library's procedure is in the manual (signature-hint.rkt), that of a
;; reader's procedure in its definition (reader-signature.rkt).

(require "../../error/spelling.rkt" "../../generic/on-demand.rkt")

(require-on-demand ["count-message.rkt" restated]
                   ["../unknown-name/known-name.rkt" procedure-called]
                   ["reader-signature.rkt" own-count-hint tuple-hint-of-library]
                   ["signature-hint.rkt" count-hint order-hint keyword-names constraint-hint])

(provide hint-for-call in-our-words)

;; e : an exception with this message; entry : the form that was typed, a datum, or #f
;; -> lines to add, or #f
(define (hint-for-call message e entry)
  (or (hint-for-keyword message)
      (and (about-number? message e) (hint-for-number message e entry))
      (and (about-constraint? message) (constraint-hint message))
      (and (regexp-match? about-order message) (order-hint message))
      (and (regexp-match? applied-number message) "\n  operations come first, as in (* 2 pi)")))

(define (hint-for-number message e entry)
  (define marks (exn-continuation-marks e))
  (or (own-count-hint message marks entry)
      (let* ([hint (or (count-hint message) "")]
             [tuple (or (tuple-hint-of-library message hint marks entry) "")])
        (string-append hint tuple))))

;; The message itself, if it is about something else than a number of arguments.
(define (in-our-words message e)
  (if (about-number? message e) (restated message) message))

;; Messages on an argument of a wrong kind, a number in the place of a Lagrangian perhaps.
(define about-order
  (pregexp (string-append "^[^\\s]+: (?:a (?:Lagrangian|path) is a function|expected a final time |"
                          "expected a state of real numbers; the procedure )")))

;; (pi * 2): names of the library are applied by Racket itself.
(define applied-number
  #rx"^application: not a procedure;\n[^\n]*\n  given: -?[0-9.:]")

(define (about-number? message e)
  (or (exn:fail:contract:arity? e)
      (regexp-match? #rx"^application: no case matching [0-9]+ non-keyword argument" message)))

(define (about-constraint? message)
  (regexp-match? #rx"^[^ \n]+: expected [^\n]*\n  given: [(](non)?holonomic " message))

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
  ;; text behind the keywords is advice on one of an earlier version
  (and (pair? known)
       (not (regexp-match? #rx"its keywords: [^\n]*\n" message))
       (keyword-hint (caddr found) known (regexp-match? #rx"its keywords: " message))))

;; -> symbols, without #:, in the order of the alphabet if the prompt knows the procedure
(define (keywords-of name)
  (define f (procedure-called name))
  (define-values (required known) (if f (procedure-keywords f) (values '() '())))
  (if (pair? known)
      (map (lambda (k) (string->symbol (keyword->string k))) known)
      (map (lambda (k) (string->symbol (substring (symbol->string k) 2)))
           (keyword-names (string->symbol name)))))

;; told? : does the message name them already?
(define (keyword-hint given known told?)
  (define likely (likely-names (string->symbol given) known))
  (define beginning (regexp (string-append "^" (regexp-quote given))))
  (define meant
    (if (null? likely)
        (filter (lambda (k) (regexp-match? beginning (symbol->string k))) known)
        likely))
  (define (dressed names) (for/list ([k (in-list names)]) (string->symbol (format "#:~a" k))))
  (cond [(pair? meant) (format "\n  did you mean ~a?" (alternatives (dressed meant)))]
        [told? #f]
        [else (format "\n  its keywords: ~a" (dressed known))]))
