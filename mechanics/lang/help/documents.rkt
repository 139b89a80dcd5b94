#lang racket/base
;; All that the search can find: names, pages of the manual and their sections, libraries, programs
;; and the exercises of the book.  Read while the table is made.

(require racket/file
         racket/list
         racket/string
         "name-documents.rkt" "page-documents.rkt" "page.rkt" "program-documents.rkt")

(provide documents)

;; pages : of the manual; cards : of its names; folder : of the programs
;; -> documents, those of one kind together
(define (documents pages cards folder)
  (append (append-map page-documents pages)
          (name-documents pages cards (uses pages folder))
          (program-documents folder)))

;; name -> the number of sections and programs that use it
(define (uses pages folder)
  (define in-pages
    (for*/list ([p (in-list pages)] [s (in-list (page-sections p))])
      (map (lambda (x) (format "~a" x)) (flatten (section-parts s)))))
  (define in-programs
    (for/list ([name (in-list (program-files folder))])
      (string-split (file->string (build-path folder name)) #px"[][()\\s'`,]+")))
  (for*/fold ([counts (hash)]) ([names (in-list (append in-pages in-programs))]
                                [name (in-list (remove-duplicates names))])
    (hash-update counts name add1 0)))
