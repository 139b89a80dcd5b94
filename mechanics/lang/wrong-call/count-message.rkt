#lang racket/base
;; Racket's message of a wrong number of arguments, in fewer words:
;;
;;     energy: arity mismatch;
;;      the expected number of arguments does not match the given number
;;       expected: 2 plus an optional argument with keyword #:mass
;;       given: 1
;;
;; becomes  energy: takes 2 arguments and perhaps #:mass; it was given 1

(require racket/string
         "../unknown-name/known-name.rkt"
         (only-in "../../error/message-words.rkt" counted)
         (only-in "../../generic/function.rkt" arity->text))

(provide restated read-miscount (struct-out miscount) missing)

(define boilerplate
  (pregexp
   (string-append "^(?:([^\\s]+): )?arity mismatch;\n"
                  " the expected number of arguments does not match the given number\n"
                  "(?:  expected: ([^\n]*)\n)?"
                  "  given: ([0-9]+)")))

;; The same where keywords are given.
(define no-case
  #px"^application: no case matching ([0-9]+) non-keyword arguments?[^\n]*\n  procedure: ([^\\s]+)")

;; name, expected : text or #f; given : number
(struct miscount (name expected given))

;; The contents of a message on a wrong number of arguments; #f for other messages
(define (read-miscount message)
  (define found (regexp-match boilerplate message))
  (define other (regexp-match no-case message))
  (cond [found (miscount (cadr found) (caddr found) (string->number (cadddr found)))]
        [other (miscount (caddr other) #f (string->number (cadr other)))]
        [else #f]))

;; names : texts of the arguments that are needed -> text to add, or ""
(define (missing names given)
  (if (< given (length names))
      (format "\n  missing: ~a" (string-join (list-tail names given) ", "))
      ""))

;; -> the message in other words; itself if it is about something else
(define (restated message)
  (define m (read-miscount message))
  (if m (in-short (miscount-name m) (miscount-expected m) (miscount-given m)) message))

(define (in-short name expected given)
  (define f (and name (procedure-called name)))
  (format "~a: takes ~a; it was given ~a"
          (or name "application")
          (or (and expected (expected->text expected))
              (and f (arity->text f))
              "another number of arguments")
          (if (eqv? given 0) "none" given)))

;; "2 plus an optional argument with keyword #:mass" -> text, or #f without a number
(define (expected->text expected)
  (define parts (string-split expected " plus "))
  (define number (number->text (car parts)))
  (define keywords
    (if (null? (cdr parts)) '() (map keywords->text (string-split (cadr parts) " and an "))))
  (and number (string-append number (string-append* keywords))))

(define (number->text text)
  (cond [(string->number text) => (lambda (n) (counted n "argument"))]
        [(regexp-match #rx"^at least ([0-9]+)$" text)
         => (lambda (found)
              (string-append "at least " (counted (string->number (cadr found)) "argument")))]
        [(regexp-match? #rx"^a different number" text) #f]
        [else (string-append text " arguments")]))

(define (keywords->text text)
  (string-append (if (regexp-match? #rx"optional" text) " and perhaps " " and ")
                 (string-join (regexp-match* #rx"#:[^ ,]+" text) ", ")))
