#lang racket/base
;; Names that the search can find.  The more pages and programs use a name, the likelier it is
;; looked for.

(require racket/list
         racket/string
         "card.rkt" "document.rkt" "finding.rkt" "page.rkt" "prose.rkt" "words.rkt")

(provide name-documents)

;; used : hash, text of a name to the number of its uses
(define (name-documents pages cards used)
  (define texts (texts-of-entries pages))
  (for/list ([c (in-list cards)])
    (define name (symbol->string (card-name c)))
    (document (finding 'name name (symbol->string (card-library c)) "")
              (list (title-field name (title-weight c))
                    (about-its-page c)
                    (cons in-sentence (or (card-sentence c) ""))
                    (cons in-page-title (card-page c))
                    (cons in-text (hash-ref texts (card-name c) "")))
              (+ (if (eq? (card-library c) 'mechanics) 10 0)
                 (bonus-of-uses (hash-ref used name 0))))))

(define (bonus-of-uses n)
  (inexact->exact (round (* 3 (/ (log (add1 n)) (log 2))))))

;; name -> the words of its entries
(define (texts-of-entries pages)
  (for*/fold ([texts (hasheq)]) ([p (in-list pages)] [e (in-list (page-entries p))]
                                 [words (in-value (distinct-words (entry-body e)))]
                                 [name (in-list (remove-duplicates (map car (entry-names e))))])
    (hash-update texts name (lambda (t) (string-append t " " words)) "")))

;; Other libraries have usual words for their drawings, and predicates are called by programs.
(define (title-weight c)
  (if (or (not (memq (card-library c) '(mechanics mechanics/book mechanics/plot)))
          (regexp-match? #rx"[?]$" (symbol->string (card-name c))))
      in-lesser-title
      in-title))

;; golden-section-min is no section of a motion; Poincare-map, on the page of maps, is a map.
(define (about-its-page c)
  (define field (title-field (symbol->string (card-name c)) (title-weight c)))
  (define topic (words-of (card-page c)))
  (cons (+ in-page-title (car field))
        (string-join (filter (lambda (w) (member w topic)) (telling-words (cdr field))))))
