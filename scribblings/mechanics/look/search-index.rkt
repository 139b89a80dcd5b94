#lang racket/base
;; The list that the manual's search box looks through: every entry of the index, with its
;; address, and with the first sentence of a name's entry in the reference.  It is written
;; beside the pages, in search-index.js, when the page with the index is rendered as HTML.

(require json
         racket/class
         racket/list
         racket/match
         racket/string
         scribble/core
         scribble/manual-struct
         (only-in scribble/base get-index-entries)
         "../../../mechanics/lang/help/card.rkt"
         "../../../mechanics/lang/help/card-table.rkt")

(provide with-search-index)

;; The part of the document that is the index, which writes the list when it is rendered.
(define (with-search-index index)
  (struct-copy part index
               [blocks (append (part-blocks index) (list (paragraph plain writer)))]))

(define writer
  (render-element #f '() (lambda (renderer index info)
                           (when (memq 'html (send renderer current-render-mode))
                             (write-search-index renderer index info)))))

(define (write-search-index renderer index info)
  (define file (build-path (send renderer get-dest-directory #t) "search-index.js"))
  (call-with-output-file file #:exists 'truncate
    (lambda (port)
      (write-string "mechanicsManual([\n" port)
      (for ([e (in-list (search-entries renderer index info))] [i (in-naturals)])
        (unless (zero? i) (write-string ",\n" port))
        (write-json e port #:encode 'all))
      (write-string "\n]);\n" port))))

;; -> lists of name, address, kind and sentence
(define (search-entries renderer index info)
  (remove-duplicates
   (for*/list ([e (in-list (get-index-entries index info))]
               [address (in-value (entry-address renderer index info (first e)))]
               #:when address)
     (define-values (name about)
       (values (string-join (second e)) (described renderer index info (fourth e))))
     (define card (and (exported-index-desc? about) (hash-ref card-of name #f)))
     (list name address (kind (first e) about card) (sentence card)))))

;; Which libraries export a name is known when the whole manual is.
(define (described renderer index info description)
  (if (delayed-index-desc? description)
      ((delayed-index-desc-resolve description) renderer index info)
      description))

;; Where a link to the tag leads, from a page of the manual.
(define (entry-address renderer index info tag)
  (match (send renderer render-content (link-element #f "x" tag) index info)
    [`((a ,attributes . ,_)) (cond [(assq 'href attributes) => cadr] [else #f])]
    [_ #f]))

;; A library is known by its tag: how the index describes one depends on Racket's version.
(define (kind tag description card)
  (cond [card (symbol->string (card-library card))]
        [(exported-index-desc? description) "name"]
        [(eq? (first tag) 'mod-path) "library"]
        [else "section"]))

(define (sentence card) (or (and card (card-sentence card)) ""))

;; name -> the card of its entry in the reference
(define card-of
  (for/hash ([c (in-list cards)])
    (values (symbol->string (card-name c)) c)))
