#lang racket/base
;; The table of cards, loaded at its first use.
;;
;; No compiled module depends on the table: it changes with every line of the manual's reference,
;; and the library, and all modules that require it, would be compiled anew each time.  `make`
;; compiles it beside the library, and so does `raco setup`.

(require racket/runtime-path
         "card.rkt"
         (for-syntax racket/base))

(provide all-cards card-of card-names)

(define-runtime-module-path-index table "card-table.rkt")

;; In the order of the manual.  Breaks wait: a module that is half loaded stays so.
(define (all-cards)
  (parameterize ([current-namespace (variable-reference->empty-namespace (#%variable-reference))])
    (parameterize-break #f (dynamic-require table 'cards))))

;; -> card or #f
(define (card-of name)
  (findf (lambda (c) (eq? (card-name c) name)) (all-cards)))

(define (card-names) (map card-name (all-cards)))
