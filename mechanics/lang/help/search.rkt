#lang racket/base
;; Cards that a text is about.  All its words must occur, each in the name, in the sentence or
;; in the name of an argument; those with all of them in the name come first, then those with
;; all of them in the sentence.  Where these are few, those follow of which the manual says more
;; with the words.

(require racket/list
         racket/string
         "card.rkt")

(provide found-cards)

;; -> cards: those that have the words in their names, in their sentences, elsewhere; else in the
;; order of the manual
(define (found-cards text cards)
  (define words (map stem (string-split (string-downcase text))))
  (define (split-by text-of cards) (partition (lambda (c) (all-in? words (text-of c))) cards))
  (define-values (in-name others)
    (split-by name-text (filter (lambda (c) (all-in? words (all-text c))) cards)))
  (define-values (in-sentence elsewhere) (split-by sentence-text others))
  (define found (append in-name in-sentence elsewhere))
  (if (< (length found) few)
      (remove-duplicates
       (append found (filter (lambda (c) (all-begin-in? words (card-words c))) cards))
       eq?)
      found))

(define few 3)

;; Plurals find what is said in the singular, and sine finds sin.
(define (stem word)
  (if (> (string-length word) 3) (regexp-replace #rx"(ies|y|es|s|e)$" word "") word))

(define (all-in? words text)
  (for/and ([w (in-list words)]) (string-contains? text w)))

;; Within a word they would be found by chance.
(define (all-begin-in? words text)
  (for/and ([w (in-list words)])
    (regexp-match? (string-append "(^| )" (regexp-quote w)) text)))

(define (name-text c) (string-downcase (symbol->string (card-name c))))

(define (sentence-text c)
  (string-downcase (string-append (name-text c) " " (or (card-sentence c) ""))))

(define (all-text c)
  (string-downcase
   (string-join
    (list* (name-text c)
           (or (card-sentence c) "")
           (card-page c)
           (append-map signature-call (card-signatures c))))))
