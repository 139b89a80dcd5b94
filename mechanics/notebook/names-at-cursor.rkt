#lang racket/base
;; The name at the cursor of a cell: names that go on from it, and its card.

(require "../error/message-words.rkt"
         "../generic/on-demand.rkt"
         "../lang/help/card-lines.rkt" "../lang/help/card.rkt" "../lang/help/cards.rkt"
         "../lang/prompt/lines.rkt"
         (only-in "../lang/redefinition/prompt.rkt" head-at-prompt))

(require-on-demand ["name-card.rkt" name->bundle])

(provide completion description)

;; code : text of the cell; cursor : in characters -> message
(define (completion code cursor)
  (define-values (start end) (name-around code cursor))
  (define beginning (substring code start (min cursor (string-length code))))
  (define matches
    (for/list ([name (in-list (if (string=? beginning "") '() (completions beginning)))]
               [_ (in-range most-matches)])
      name))
  (hasheq 'status "ok" 'start start 'end cursor 'matches matches
          'signatures (for/list ([name (in-list matches)]) (signature-text (string->symbol name)))))

(define most-matches 200)

;; How the name is called, as its definition at the prompt or the manual says; "" of others
(define (signature-text name)
  (define head (head-at-prompt name))
  (define c (and (not head) (card-of name)))
  (cond [(pair? head) (format "~a" head)]
        [c (joined (call-lines (car (card-signatures c)) 500) " ")]
        [else ""]))

;; The card that (help name) prints
(define (description code cursor)
  (define-values (start end) (name-around code cursor))
  (define name (substring code start end))
  (define data
    (with-handlers ([exn:fail? (lambda (e) (hasheq))])
      (if (string=? name "") (hasheq) (name->bundle (string->symbol name)))))
  (hasheq 'status "ok" 'found (positive? (hash-count data)) 'data data))

;; -> start and end of the name that the cursor is in or behind
(define (name-around code given)
  (define cursor (min given (string-length code)))
  (define (name-character? i)
    (define c (string-ref code i))
    (not (or (char-whitespace? c) (memv c delimiters))))
  (define start
    (let loop ([i cursor]) (if (and (> i 0) (name-character? (sub1 i))) (loop (sub1 i)) i)))
  (define end
    (let loop ([i cursor])
      (if (and (< i (string-length code)) (name-character? i)) (loop (add1 i)) i)))
  (values start end))

(define delimiters (string->list "()[]{}\"',`;"))
