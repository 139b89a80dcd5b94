#lang racket/base
;; The data of search.js: the table that `(help "words")` has (mechanics/lang/help), with an
;; address and a sentence for each finding, and the patterns that make words of a text.

(require net/base64
         racket/list
         racket/string
         "../../../mechanics/lang/help/card.rkt"
         "../../../mechanics/lang/help/card-table.rkt"
         "../../../mechanics/lang/help/finding.rkt"
         "../../../mechanics/lang/help/search-table.rkt"
         "../../../mechanics/lang/help/words.rkt")

(provide search-data)

;; address : finding -> text, or #f for what the pages do not have
;; -> what JSON can say
(define (search-data address)
  (hasheq 'findings (for/list ([f (in-vector (vector-ref search-table 0))])
                      (list (symbol->string (finding-kind f)) (finding-title f)
                            (finding-where f) (sentence f) (or (address f) "")))
          'priors (bytes->list (vector-ref search-table 1))
          'words (for/hasheq ([(word postings) (in-hash (vector-ref search-table 2))])
                   (values (string->symbol word)
                           (bytes->string/latin-1 (base64-encode postings #""))))
          'synonyms (for/hasheq ([(word others) (in-hash (vector-ref search-table 3))])
                      (values (string->symbol word) others))
          'phrases (for/list ([p (in-list (vector-ref search-table 4))])
                     (list (car p) (cdr p)))
          'pattern word-pattern
          'endings (for/list ([e (in-list endings)])
                     (list (first e) (string-replace (second e) "\\1" "$1")))
          'joining joining-words))

(define (sentence f)
  (case (finding-kind f)
    [(name) (or (card-sentence (hash-ref card-named (finding-title f))) "")]
    [else (finding-sentence f)]))

(define card-named
  (for/hash ([c (in-list cards)]) (values (symbol->string (card-name c)) c)))
