#lang racket/base
;; Hints beneath a message of a wrong number of arguments, or of a wrong keyword, for a procedure
;; of the library: how it is called, with the manual's names of its arguments; which argument is
;; missing; and which keyword an argument too many may have been meant for.  Nothing is wrapped:
;; the message itself names the procedure.
;;
;; The reader may have a procedure of that name.  Nothing is said if the prompt knows it for the
;; reader's, or if the numbers of arguments do not fit the manual's.

(require racket/list
         racket/string
         "count-message.rkt" "../unknown-name/known-name.rkt" "error-location.rkt"
         "../../error/spelling.rkt"
         "../help/card-lines.rkt" "../help/card.rkt" "../help/cards.rkt"
         (only-in "../redefinition/prompt.rkt" variable-name?))

(provide count-hint order-hint keyword-names constraint-hint)

;; The manual's signatures of the procedures of this name; none if another is meant, or where
;; there is no table and no manual to make it of: a message must not fail.
(define (signatures-of name)
  (define c (with-handlers ([exn:fail:filesystem? (lambda (e) #f)]) (card-of name)))
  (if (and c (in-use? (card-library c)) (not (readers-own? name)))
      (filter (lambda (s) (eq? (signature-kind s) 'procedure)) (card-signatures c))
      '()))

;; The objects of the book are commonly typed by the reader.
(define (in-use? library)
  (or (eq? library 'mechanics)
      (parameterize ([current-namespace
                      (variable-reference->empty-namespace (#%variable-reference))])
        (module-declared? library #f))))

;; Does the prompt have the name from elsewhere than this library?
(define (readers-own? name)
  (define place (defining-module name))
  (if place
      (not (and (path? place) (of-mechanics? place)))
      (variable-name? name)))

;; ---------------------------------------------------------------------------
;; Numbers of arguments

;; -> text to add, or #f
(define (count-hint message)
  (define given (number-in message given-patterns))
  (define signatures (if given (signatures-in message) '()))
  (and (pair? signatures)
       (plausible? signatures (number-in message expected-patterns) given)
       (string-append* (append (map called-as signatures)
                               (if (null? (cdr signatures))
                                   (list (what-differs (car signatures) given message))
                                   '())))))

;; How a procedure with three arguments or more is called, which may stand in the wrong order;
;; or #f.
(define (order-hint message)
  (define signatures (signatures-in message))
  (and (pair? signatures)
       (andmap (lambda (s) (>= (length (signature-needed s)) 3)) signatures)
       (string-append* (map called-as signatures))))

;; The signatures of the procedure that a message names.
(define (signatures-in message)
  (define found (or (regexp-match #rx"^application: [^\n]*\n  procedure: ([^ \n]+)" message)
                    (regexp-match #rx"^([^ \n]+): " message)))
  (if found (signatures-of (string->symbol (cadr found))) '()))

(define given-patterns
  '(#rx"\n  given: ([0-9]+)" #rx"it was given ([0-9]+|none)" #rx", given ([0-9]+)(?::|$)"
    #rx"no case matching ([0-9]+)"))

(define expected-patterns
  '(#rx"\n  expected: ([0-9]+)[ \n]" #rx": takes ([0-9]+) argument" #rx": expected ([0-9]+) arg"))

(define (number-in message patterns)
  (define found (for/or ([p (in-list patterns)]) (regexp-match p message)))
  (and found (or (string->number (cadr found)) 0)))

;; May this be about one of the signatures, or about a call within it?
(define (plausible? signatures expected given)
  (define (taken? n) (ormap (lambda (s) (takes? s n)) signatures))
  (or (ormap (lambda (s) (memv expected (signature-parameters s))) signatures)
      (and (not (taken? given))
           (or (not expected) (taken? expected)))))

(define (called-as s)
  (define lines (call-lines (struct-copy signature s [result #f]) 62))
  (string-append "\n  it is called as " (string-join lines "\n")))

(define (what-differs s given message)
  (define needed (map argument-name (signature-needed s)))
  (define most (+ (length needed) (length (signature-optional s))))
  (cond [(pair? (signature-parameters s)) ""]
        [(< given (length needed)) (missing needed given)]
        [(signature-rest s) ""]
        [else
         (string-append
          (if (null? (signature-keywords s))
              ""
              (question (likely-keywords s (positional-after most message))))
          (if (and (= given (add1 most)) (gives-function? s)) (applied s needed) ""))]))

;; An argument too many may be meant for the value: so the state for a state derivative.
(define (gives-function? s)
  (regexp-match? #rx"^(function|operator)$|→" (or (signature-result s) "")))

(define (applied s needed)
  (format "\n  its value is a function, which takes what comes next: ((~a ~a) ...)"
          (substring (car (signature-call s)) 1) (string-join needed " ")))

;; The call has already named them, if they are many.
(define (question keywords)
  (if (<= (length keywords) 3)
      (format "\n  did you mean ~a?" (alternatives keywords))
      ""))

;; ---------------------------------------------------------------------------
;; Keywords

(define (keyword-names name)
  (append* (for/list ([s (in-list (signatures-of name))])
             (map argument-keyword (signature-keywords s)))))

;; The keywords that take values such as these texts; or else all.
(define (likely-keywords s texts)
  (define all (signature-keywords s))
  (define fitting
    (filter (lambda (a) (ormap (lambda (t) (fits? t (argument-what a))) texts)) all))
  (map argument-keyword (if (null? fitting) all fitting)))

;; The arguments behind the first n, as the message prints them.
(define (positional-after n message)
  (define found (regexp-match #rx"\n  arguments[.][.][.]:\n(.*)$" message))
  (define lines (if found (map string-trim (string-split (cadr found) "\n")) '()))
  (define positional (filter (lambda (l) (not (regexp-match? #rx"^#:" l))) lines))
  (drop positional (min n (length positional))))

(define (fits? text what)
  (define (about pattern) (regexp-match? pattern what))
  (cond [(regexp-match? #rx"^[(](non)?holonomic " text) (about #rx"constraint")]
        [(regexp-match? #rx"^#<procedure" text) (about #rx"function|path|→")]
        [(string->number text) (about #rx"number|integer|1, 2, 3")]
        [else #t]))

;; The keyword that takes a constraint, which was given where none is expected.
(define (constraint-hint message)
  (define found (regexp-match #rx"\n  given: ([(](?:non)?holonomic .*)$" message))
  (define wanted
    (for*/list ([s (in-list (if found (signatures-in message) '()))]
                [a (in-list (signature-keywords s))]
                #:when (fits? (cadr found) (argument-what a)))
      (argument-keyword a)))
  (and (pair? wanted) (question wanted)))
