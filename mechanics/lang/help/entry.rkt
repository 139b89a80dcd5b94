#lang racket/base
;; Entries of the manual: the forms that say what a name is, `defproc` and its kin, and the
;; signatures that they give.
;;
;; The contract of an argument is told in words, as far as the words of the manual reach.

(require racket/list
         racket/string
         "card.rkt")

(provide entry-form? entry-signatures name-at-head)

;; ---------------------------------------------------------------------------
;; Forms

(define entry-forms
  '(defproc defproc* defform defform* defthing defparam defboolparam defidform defstruct*))

(define (entry-form? d) (and (pair? d) (memq (car d) (cons 'deftogether entry-forms)) #t))

;; An entry without its text -> ((name . signatures) ...), a name for each time it stands
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
    [(defthing) (list (value-signature (positional d)))]
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

(define (name-at-head head) (if (pair? head) (name-at-head (car head)) head))

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

(define (form-signature id shape)
  (cons (or id (name-at-head shape)) (signature 'form (shape-pieces shape) #f '() '() '() #f '())))

(define (shape-pieces shape)
  (if (list? shape)
      (in-parentheses (map (lambda (part) (format "~s" part)) shape))
      (list (format "~s" shape))))

(define (value-signature parts)
  (define name (car parts))
  (cons name (signature 'value (list (symbol->string name)) (result-text (cadr parts))
                        '() '() '() #f '())))

(define (parameter-signature name argument-name contract)
  (define value (argument (format "~s" argument-name) (words contract) #f #f))
  (cons name (signature 'parameter (list (format "(~s" name) (format "[~s])" argument-name)) #f
                        '() (list value) '() #f '())))

;; An exception: its name, what tells it, and what its fields are taken out by.
(define (structure-signatures head fields)
  (define name (name-at-head head))
  (define (of suffix result)
    (define full (string->symbol (format "~s~a" name suffix)))
    (cons full (signature 'procedure (list (format "(~s" full) "x)") result
                          (list (argument "x" "any value" #f #f)) '() '() #f '())))
  (list* (cons name (signature 'value (list (symbol->string name)) "structure type"
                               '() '() '() #f '()))
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

;; -> needed, optional and keyword arguments, and the text of what may be repeated or #f
(define (sort-arguments slots)
  (for/fold ([needed '()] [optional '()] [keywords '()] [rest #f]
             #:result (values (reverse needed) (reverse optional) (reverse keywords) rest))
            ([slot (in-list slots)] [next (in-list (append (drop-first slots) '(#f)))])
    (cond [(not (pair? slot)) (values needed optional keywords rest)]
          [(keyword? (car slot)) (values needed optional (cons (keyword-slot slot) keywords) rest)]
          [(memq next '(...))
           (values needed optional keywords (format "~s ..." (car slot)))]
          [(memq next '(...+))
           (values (cons (positional-slot slot) needed) optional keywords
                   (format "~s ..." (car slot)))]
          [(pair? (cddr slot)) (values needed (cons (positional-slot slot) optional) keywords rest)]
          [else (values (cons (positional-slot slot) needed) optional keywords rest)])))

(define (drop-first xs) (if (null? xs) '() (cdr xs)))

(define (positional-slot slot)
  (argument (format "~s" (car slot)) (words (cadr slot)) (default-text (cddr slot)) #f))

(define (keyword-slot slot)
  (argument (format "~s" (cadr slot)) (words (caddr slot)) (default-text (cdddr slot))
            (string->symbol (format "~s" (car slot)))))

;; _name is told and no program.
(define (default-text parts)
  (and (pair? parts) (regexp-replace #rx"^_" (format "~s" (car parts)) "")))

;; ---------------------------------------------------------------------------
;; Contracts in words

(define (result-text contract)
  (case contract
    [(any any/c) #f]
    [(void?) #f]
    [else (words contract)]))

(define (words contract)
  (cond [(symbol? contract) (symbol-words contract)]
        [(not (and (pair? contract) (list? contract))) (format "~s" contract)]
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

(define (plural word)
  (cond [(regexp-match? #rx"^any value$" word) "anything"]
        [(regexp-match? #rx"^list of " word)
         (string-append "lists" (substring word (string-length "list")))]
        [(regexp-match? #rx"…$" word) "integers"]
        [(regexp-match? #rx"equilibrium$" word) (regexp-replace #rx"um$" word "a")]
        [(regexp-match? #rx"minimum$" word) (regexp-replace #rx"um$" word "a")]
        [(regexp-match? #rx"( or |,)" word) word]
        [(regexp-match? #rx"y$" word) (regexp-replace #rx"y$" word "ies")]
        [else (string-append word "s")]))

(define (symbol-words name)
  (case name
    [(any any/c) "any value"]
    [(procedure?) "function"]
    [(exact-nonnegative-integer?) "0, 1, 2 …"]
    [(exact-positive-integer?) "1, 2, 3 …"]
    [(exact-integer? integer?) "integer"]
    [(real?) "real number"]
    [(number?) "number"]
    [(local-tuple) "local tuple"]
    [(void?) "nothing"]
    [else (string-replace (regexp-replace #rx"[?]$" (symbol->string name) "") "-" " ")]))
