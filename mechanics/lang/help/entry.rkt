#lang racket/base
;; Entries of the manual: `defproc` and its kin, and the signatures that they give.
;;
;; The contract of an argument is told in words, as far as the manual's contracts need.

(require racket/list
         racket/string
         "card.rkt"
         (only-in "../redefinition/definition-head.rkt" [head-name-in name-at-head]))

(provide entry-signatures)

;; ---------------------------------------------------------------------------
;; Forms

;; d : a form of the manual -> ((name . signature) ...), none if the form is no entry
(define (entry-signatures d)
  (case (car d)
    [(deftogether) (append-map entry-signatures (cadr d))]
    [(defproc) (list (procedure-signature (cadr d) (caddr d)))]
    [(defproc*) (for/list ([clause (in-list (cadr d))])
                  (procedure-signature (car clause) (cadr clause)))]
    [(defform) (list (form-signature (form-id d) (car (positional d))))]
    [(defform*) (for/list ([shape (in-list (car (positional d)))])
                  (form-signature (form-id d) shape))]
    [(defidform) (list (form-signature #f (cadr d)))]
    [(defthing) (let ([parts (positional d)])
                  (list (value-signature (car parts) (result-text (cadr parts)))))]
    [(defparam) (list (parameter-signature (cadr d) (caddr d) (cadddr d)))]
    [(defboolparam) (list (parameter-signature (cadr d) (caddr d) 'boolean?))]
    [(defstruct*) (structure-signatures (cadr d) (caddr d))]
    [else '()]))

(define (positional d)
  (let loop ([parts (cdr d)])
    (cond [(null? parts) '()]
          [(memq (car parts) '(#:id #:literals #:kind #:value)) (loop (cddr parts))]
          [(keyword? (car parts)) (loop (cdr parts))]
          [else (cons (car parts) (loop (cdr parts)))])))

(define (form-id d)
  (define found (memq '#:id d))
  (and found (name-at-head (cadr found))))

;; ---------------------------------------------------------------------------
;; Signatures

(define (procedure-signature head result)
  (define name (name-at-head head))
  (define-values (needed optional keywords rest) (sort-arguments (cdr head)))
  (cons name (signature 'procedure (call-pieces head) (result-text result)
                        needed optional keywords rest (inner-counts (car head)))))

;; ((f a b) c) -> (1 2)
(define (inner-counts head)
  (if (pair? head) (cons (length (cdr head)) (inner-counts (car head))) '()))

(define (simple-signature kind call result #:needed [needed '()] #:optional [optional '()])
  (signature kind call result needed optional '() #f '()))

(define (form-signature id shape)
  (cons (or id (name-at-head shape)) (simple-signature 'form (shape-pieces shape) #f)))

(define (shape-pieces shape)
  (if (list? shape)
      (in-parentheses (map (lambda (part) (format "~s" part)) shape))
      (list (format "~s" shape))))

(define (value-signature name result)
  (cons name (simple-signature 'value (list (symbol->string name)) result)))

(define (parameter-signature name argument-name contract)
  (define call (list (format "(~s" name) (format "[~s])" argument-name)))
  (cons name (simple-signature 'parameter call #f
                               #:optional (list (slot->argument (list argument-name contract))))))

;; An exception: its structure type, predicate and accessors.
(define (structure-signatures head fields)
  (define name (name-at-head head))
  (define (of suffix result)
    (define full (string->symbol (format "~s~a" name suffix)))
    (cons full (simple-signature 'procedure (list (format "(~s" full) "x)") result
                                 #:needed (list (slot->argument '(x any/c))))))
  (list* (value-signature name "structure type")
         (of "?" "boolean")
         (for/list ([field (in-list fields)])
           (of (format "-~s" (car field)) (result-text (cadr field))))))

;; ((f [m scalar]) [x scalar] ...) -> "((f m)" "x" "...)"
(define (call-pieces head)
  (cond [(pair? head)
         (in-parentheses (cons (string-join (call-pieces (car head))) (map slot-text (cdr head))))]
        [else (list (format "~s" head))]))

(define (in-parentheses texts)
  (define-values (others end) (split-at-right texts 1))
  (define closed (append others (list (string-append (car end) ")"))))
  (cons (string-append "(" (car closed)) (cdr closed)))

(define (slot-text slot)
  (cond [(not (pair? slot)) (format "~s" slot)]
        [(keyword? (car slot))
         (define text (format "~s ~s" (car slot) (cadr slot)))
         (if (pair? (cdddr slot)) (format "[~a]" text) text)]
        [(pair? (cddr slot)) (format "[~s]" (car slot))]
        [else (format "~s" (car slot))]))

;; -> needed, optional and keyword arguments, and the text of the repeated argument or #f
(define (sort-arguments slots)
  (define sorted                        ; ((sort . slot) ...)
    (for/list ([slot (in-list slots)] [next (in-list (cdr (append slots '(#f #f))))]
               #:when (pair? slot))
      (cons (cond [(keyword? (car slot)) 'keyword]
                  [(memq next '(... ...+)) next]
                  [(pair? (cddr slot)) 'optional]
                  [else 'needed])
            slot)))
  (define (of sorts make)
    (for/list ([s (in-list sorted)] #:when (memq (car s) sorts)) (make (cdr s))))
  (define repeated (of '(... ...+) (lambda (slot) (format "~s ..." (car slot)))))
  (values (of '(needed ...+) slot->argument)
          (of '(optional) slot->argument)
          (of '(keyword) keyword-slot)
          (and (pair? repeated) (last repeated))))

;; slot : [name contract] or [name contract default]
(define (slot->argument slot [keyword #f])
  (argument (format "~s" (car slot)) (words (cadr slot)) (default-text (cddr slot)) keyword))

(define (keyword-slot slot)
  (slot->argument (cdr slot) (string->symbol (format "~s" (car slot)))))

;; _name stands for an expression that is no program.
(define (default-text parts)
  (and (pair? parts) (regexp-replace #rx"^_" (format "~s" (car parts)) "")))

;; ---------------------------------------------------------------------------
;; Contracts in words

(define (result-text contract)
  (case contract
    [(any any/c void?) #f]
    [else (words contract)]))

(define (words contract)
  (cond [(symbol? contract) (symbol-words contract)]
        [(not (pair? contract)) (format "~s" contract)]
        [else
         (define parts (map words (cdr contract)))
         (case (car contract)
           [(or/c) (string-join (move-false-last parts) ", " #:before-last " or ")]
           [(listof) (format "list of ~a" (plural (car parts)))]
           [(list/c) (format "list of ~a" (string-join parts " and "))]
           [(sequence/c) (format "sequence of ~a" (plural (car parts)))]
           [(vectorof) (format "vector of ~a" (plural (car parts)))]
           [(quote) (format "'~s" (cadr contract))]
           [(->) (function-words contract)]
           [(->*) "function"]
           [else (format "~s" contract)])]))

(define (function-words contract)
  (define parts (cdr contract))
  (format "~a → ~a" (string-join (map words (drop-right parts 1)) ", ") (words (last parts))))

(define (move-false-last parts)
  (if (member "#f" parts) (append (remove "#f" parts) '("#f")) parts))

;; pattern of a word, and its plural; the first that fits holds
(define plurals
  '((#rx"^any value$" "anything") (#rx"^list of " "lists of ") (#rx"^.*…$" "integers")
    (#rx"(equilibri|minim)um$" "\\1a") (#rx" or |," "&") (#rx"y$" "ies") (#rx"$" "s")))

(define (plural word)
  (define p (findf (lambda (p) (regexp-match? (car p) word)) plurals))
  (regexp-replace (car p) word (cadr p)))

(define (symbol-words name)
  (case name
    [(any any/c) "any value"]
    [(procedure?) "function"]
    [(exact-nonnegative-integer?) "0, 1, 2 …"]
    [(exact-positive-integer?) "1, 2, 3 …"]
    [(exact-integer?) "integer"]
    [(real?) "real number"]
    [(void?) "nothing"]
    [else (string-replace (regexp-replace #rx"[?]$" (symbol->string name) "") "-" " ")]))
