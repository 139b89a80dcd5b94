#lang racket/base
;; Definitions of the reader's that a library required later has, too.
;;
;; They stay.  A note says so once, with both signatures: a call of the one that means the other
;; would silently give wrong answers.

(require (only-in racket/list last)
         racket/string
         "../../generic/on-demand.rkt")

(require-on-demand ["../help/cards.rkt" card-of]
                   ["../help/card.rkt" card-library card-signatures signature-call])

(provide (struct-out clash) tell-clash named-by)

;; name : symbol; header : first call of the reader's definition, as a datum; line : of the
;; definition, or #f
(struct clash (name header line))

;; library : specification of the require, as a datum
(define (tell-clash library clashes)
  (parameterize ([print-reader-abbreviations #t])
    (eprintf "; ~s: your own definitions stay\n" library)
    (for ([c (in-list clashes)]) (eprintf "~a" (clash->text c library)))
    (eprintf ";   the library's: (require (prefix-in its: ~s)), then its:~s\n"
             library (clash-name (car clashes)))))

(define (clash->text c library)
  (define line (clash-line c))
  (define other (call-in library (clash-name c)))
  (format ";   ~s~a~a\n"
          (clash-header c)
          (if line (format ", defined on line ~a" line) "")
          (if other (format "; the library's is ~a" other) "")))

;; The call of the library's procedure in the manual, or #f.
(define (call-in library name)
  (define c (card-of name))
  (and c
       (eq? (card-library c) library)
       (string-join (signature-call (car (card-signatures c))))))

;; The names that a specification of `require` lists one by one, as symbols: they are wanted.
(define (named-by spec)
  (define d (syntax->datum spec))
  (if (and (list? d) (> (length d) 2) (memq (car d) '(only-in rename-in)))
      (for/list ([listed (in-list (cddr d))])
        (if (pair? listed) (last listed) listed))
      '()))
