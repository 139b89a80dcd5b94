#lang racket/base
;; The table of the search: for each word the findings that have it, with weights.
;;
;; A word counts the more the fewer findings have it, and the more the nearer to the title it
;; stands.  Both are in the table: a search only adds numbers, and does so alike at the prompt and
;; in a browser.

(require racket/list
         racket/string
         "document.rkt" "synonyms.rkt" "words.rkt")

(provide make-search-table)

;; documents -> (vector findings priors terms synonyms replacements): a vector, bytes, a hash from a
;; word to bytes, three for each finding: its place, high byte first, and its weight; a hash from a
;; word to words, and pairs of phrases
(define (make-search-table all)
  (define terms (weighed (word-fields all) (length all)))
  (vector (list->vector (map document-finding all))
          (list->bytes (map document-prior all))
          (for/hash ([(word found) (in-hash terms)])
            (values word (as-bytes found)))
          synonyms
          replacements))

;; -> hash, word to a hash from the place of a document to its weight
(define (word-fields all)
  (for*/fold ([terms (hash)]) ([(d k) (in-indexed all)]
                               [field (in-list (document-fields d))]
                               [word (in-list (remove-duplicates (words-of (cdr field))))]
                               #:unless (member word joining-words))
    (hash-update terms word
                 (lambda (found) (hash-update found k (lambda (w) (max w (car field))) 0))
                 (hash))))

(define (in-indexed l) (in-parallel l (in-naturals)))

(define (weighed terms total)
  (for/hash ([(word found) (in-hash terms)])
    (define rarity (log (/ total (hash-count found))))
    (values word
            (for/hash ([(k w) (in-hash found)])
              (values k (max 1 (min 255 (inexact->exact (round (* w rarity))))))))))

(define (as-bytes found)
  (apply bytes-append
         (for/list ([k (in-list (sort (hash-keys found) <))])
           (bytes (quotient k 256) (remainder k 256) (hash-ref found k)))))

;; ---------------------------------------------------------------------------
;; Synonyms

;; word -> words
(define synonyms
  (for*/fold ([all (hash)]) ([group (in-list same-words)]
                             [words (in-value (words-of group))]
                             [w (in-list words)])
    (hash-update all w (lambda (others) (remove-duplicates (append others (remove w words)))) '())))

;; ((words . others) ...), with a space between words
(define replacements
  (for/list ([p (in-list phrases)])
    (cons (string-join (words-of (first p))) (string-join (words-of (second p))))))
