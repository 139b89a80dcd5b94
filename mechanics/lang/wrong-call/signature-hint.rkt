#lang racket/base
;; What is said beneath a message of a wrong number of arguments, or of a wrong keyword, if it
;; is about a procedure of the library: how that is called, by the names that the manual has
;; for its arguments; which one is missing; and which keyword may have been meant by one too
;; many.  Nothing is wrapped: the message itself tells what was called.
;;
;; The reader may have a procedure of that name: then it is said only if that takes other
;; numbers than the manual's, or the prompt knows it for the reader's.

(require racket/list
         racket/runtime-path
         racket/string
         "../../error/spelling.rkt"
         "../help/card-lines.rkt" "../help/card.rkt" "../help/cards.rkt"
         (for-syntax racket/base))

(provide count-hint order-hint keyword-names constraint-hint)

;; The procedures that the manual describes under this name, as signatures; none if another is
;; meant, or where there is no table and no manual to make it of: a message must not fail.
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

(define-runtime-path library-folder "../..")

;; Does the prompt know the name for something that this library does not define?
(define (readers-own? name)
  (define binding
    (with-handlers ([exn:fail? (lambda (e) #f)])
      (identifier-binding (namespace-symbol->identifier name))))
  (if (pair? binding)
      (not (ours? (resolved-module-path-name (module-path-index-resolve (car binding)))))
      (not (eq? (namespace-variable-value name #f (lambda () unknown)) unknown))))

(define unknown (string->uninterned-symbol "unknown"))

(define (ours? place)
  (define file (if (pair? place) (car place) place))
  (and (path? file)
       (string-prefix? (path->string file) (path->string (simplify-path library-folder)))))

;; ---------------------------------------------------------------------------
;; Numbers of arguments

;; -> text to add, or #f
(define (count-hint message)
  (define name (name-in message))
  (define given (number-in message given-patterns))
  (define signatures (if (and name given) (signatures-of (string->symbol name)) '()))
  (and (pair? signatures)
       (plausible? signatures (number-in message expected-patterns) given)
       (string-append* (append (map called-as signatures)
                               (if (null? (cdr signatures))
                                   (list (what-differs (car signatures) given message))
                                   '())))))

;; Of a procedure with three arguments and more, which may be in the wrong order: how it is
;; called, or #f.
(define (order-hint message)
  (define name (name-in message))
  (define signatures (if name (signatures-of (string->symbol name)) '()))
  (and (pair? signatures)
       (andmap (lambda (s) (>= (length (signature-needed s)) 3)) signatures)
       (string-append* (map called-as signatures))))

(define (name-in message)
  (define found (or (regexp-match #rx"^application: [^\n]*\n  procedure: ([^ \n]+)" message)
                    (regexp-match #rx"^([^ \n]+): " message)))
  (and found (cadr found)))

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
  (define inner? (and expected
                      (for/or ([s (in-list signatures)]) (memv expected (signature-parameters s)))))
  (or (and inner? #t)
      (and (not (for/or ([s (in-list signatures)]) (takes? s given)))
           (or (not expected) (for/or ([s (in-list signatures)]) (takes? s expected))))))

(define (called-as s)
  (define lines (call-lines (struct-copy signature s [result #f]) 62))
  (string-append "\n  it is called as " (string-join lines "\n")))

(define (what-differs s given message)
  (define needed (map argument-name (signature-needed s)))
  (define most (+ (length needed) (length (signature-optional s))))
  (cond [(pair? (signature-parameters s)) ""]
        [(< given (length needed))
         (format "\n  missing: ~a" (string-join (drop needed given) ", "))]
        [(signature-rest s) ""]
        [else
         (string-append
          (if (null? (signature-keywords s))
              ""
              (question (likely-keywords s (positional-after most message))))
          (if (and (= given (add1 most)) (gives-function? s)) (applied s needed) ""))]))

;; One too many may be what its value is to be applied to, as the state is to which a state
;; derivative is.
(define (gives-function? s)
  (regexp-match? #rx"^(function|operator)$|→" (or (signature-result s) "")))

(define (applied s needed)
  (format "\n  its value is a function, which takes what comes next: ((~a ~a) ...)"
          (substring (car (signature-call s)) 1) (string-join needed " ")))

;; Many of them, the call has named already.
(define (question keywords)
  (if (<= (length keywords) 3)
      (format "\n  did you mean ~a?" (alternatives keywords))
      ""))

;; ---------------------------------------------------------------------------
;; Keywords

(define (keyword-names name)
  (append* (for/list ([s (in-list (signatures-of name))])
             (map argument-keyword (signature-keywords s)))))

;; Those that take values such as these texts; or else all.
(define (likely-keywords s texts)
  (define all (signature-keywords s))
  (define fitting
    (filter (lambda (a) (ormap (lambda (t) (fits? t (argument-what a))) texts)) all))
  (map argument-keyword (if (null? fitting) all fitting)))

;; The arguments behind the first n, as the message prints them.
(define (positional-after n message)
  (define found (regexp-match #rx"\n  arguments[.][.][.]:\n(.*)$" message))
  (define lines (if found (map string-trim (string-split (cadr found) "\n")) '()))
  (define values (filter (lambda (l) (not (regexp-match? #rx"^#:" l))) lines))
  (drop values (min n (length values))))

(define (fits? text what)
  (define (about pattern) (regexp-match? pattern what))
  (cond [(constraint-text? text) (about #rx"constraint")]
        [(regexp-match? #rx"^#<procedure" text) (about #rx"function|path|→")]
        [(string->number text) (about #rx"number|integer|1, 2, 3")]
        [else #t]))

(define (constraint-text? text) (regexp-match? #rx"^[(](non)?holonomic " text))

;; A constraint where none is expected: the keyword that takes it.
(define (constraint-hint message)
  (define found
    (regexp-match #rx"^([^ \n]+): expected [^\n]*\n  given: ([(](non)?holonomic .*)$"
                  message))
  (define wanted
    (if found
        (for*/list ([s (in-list (signatures-of (string->symbol (cadr found))))]
                    [a (in-list (signature-keywords s))]
                    #:when (fits? (caddr found) (argument-what a)))
          (argument-keyword a))
        '()))
  (and (pair? wanted) (question wanted)))
