#lang racket/base
;; Definitions of the reader's that a library required later has, too.
;;
;; They stay.  That is said once, with both signatures: whoever calls the one and means the
;; other gets answers that are wrong without a word.

(require (only-in racket/list append-map)
         racket/string
         "../../generic/on-demand.rkt")

(require-on-demand ["../help/cards.rkt" card-of]
                   ["../help/card.rkt" card-library card-signatures signature-call])

(provide (struct-out clash) tell-clash named-by)

;; name : symbol; header : how the reader's own is called, as a datum; line : of its definition,
;; or #f
(struct clash (name header line))

;; library : what was required, as a datum
(define (tell-clash library clashes)
  (parameterize ([print-reader-abbreviations #t])
    (tell-clash-on (current-error-port) library clashes)))

(define (tell-clash-on port library clashes)
  (fprintf port "; ~s: your own definitions stay\n" library)
  (for ([c (in-list clashes)]) (write-string (clash->text c library) port))
  (fprintf port ";   the library's: (require (prefix-in its: ~s)), then its:~s\n"
           library (clash-name (car clashes))))

(define (clash->text c library)
  (define line (clash-line c))
  (define other (call-in library (clash-name c)))
  (format ";   ~s~a~a\n"
          (clash-header c)
          (if line (format ", defined on line ~a" line) "")
          (if other (format "; the library's is ~a" other) "")))

;; How the library's procedure is called, as the manual tells; or #f.
(define (call-in library name)
  (define c (card-of name))
  (and c
       (eq? (card-library c) library)
       (string-join (signature-call (car (card-signatures c))))))

;; The names that a specification of `require` lists one by one, as symbols: they are wanted.
(define (named-by spec)
  (syntax-case* spec (only-in rename-in) same-spelling?
    [(only-in _ id ...) (append-map local-name (syntax->list #'(id ...)))]
    [(rename-in _ id ...) (append-map local-name (syntax->list #'(id ...)))]
    [_ '()]))

(define (same-spelling? a b) (eq? (syntax-e a) (syntax-e b)))

(define (local-name stx)
  (syntax-case stx ()
    [(_ id) (identifier? #'id) (list (syntax-e #'id))]
    [id (identifier? #'id) (list (syntax-e #'id))]
    [_ '()]))
