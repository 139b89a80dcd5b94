#lang racket/base
;; The tables of cards and of the search, each loaded at its first use.
;;
;; No compiled module depends on a table: it changes with every line of the manual, and the
;; library, and all modules that require it, would be compiled anew each time.  `make` compiles
;; them beside the library, and so does `raco setup`.

(require racket/runtime-path
         "card.rkt"
         (for-syntax racket/base))

(provide all-cards card-of card-names table-of-search)

(define-runtime-module-path-index card-table "card-table.rkt")
(define-runtime-module-path-index search-table "search-table.rkt")

;; In the order of the manual.
(define (all-cards) (loaded card-table 'cards))

(define (table-of-search) (loaded search-table 'search-table))

;; Breaks wait: a module that is half loaded stays so.
(define (loaded table name)
  (parameterize ([current-namespace (variable-reference->empty-namespace (#%variable-reference))])
    (parameterize-break #f (dynamic-require table name))))

;; -> card or #f
(define (card-of name)
  (findf (lambda (c) (eq? (card-name c) name)) (all-cards)))

(define (card-names) (map card-name (all-cards)))
