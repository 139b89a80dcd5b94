#lang racket/base
;; The table of cards, loaded when it is first asked for.
;;
;; Nothing that is compiled depends on it: it changes with every line of the manual's
;; reference, and the library, and all that requires it, would be compiled anew each time.
;; `make` compiles it beside the library, and so does `raco setup`.

(require racket/runtime-path
         "card.rkt"
         (for-syntax racket/base))

(provide all-cards card-of card-names)

(define-runtime-module-path-index table "table.rkt")

;; In the order of the manual.  A break waits: what is left half loaded stays so.
(define (all-cards)
  (parameterize ([current-namespace (variable-reference->empty-namespace (#%variable-reference))])
    (parameterize-break #f (dynamic-require table 'cards))))

;; -> card or #f
(define (card-of name)
  (for/first ([c (in-list (all-cards))] #:when (eq? (card-name c) name)) c))

(define (card-names) (map card-name (all-cards)))
