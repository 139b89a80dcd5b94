#lang racket/base
;; The list that the manual's search box looks through is written beside the pages, in
;; search-index.js, when the page with the index is rendered as HTML.

(require json
         racket/class
         racket/list
         racket/match
         racket/runtime-path
         racket/string
         scribble/core
         scribble/manual-struct
         (only-in scribble/base get-index-entries)
         (only-in scribble/html-properties link-resource)
         "search-data.rkt"
         "../../../mechanics/lang/help/finding.rkt")

(provide with-search-index)

(define-runtime-path examples "../../../examples/mechanics")

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
      (write-string "mechanicsManual(\n" port)
      (write-json (search-data (addresses renderer index info)) port #:encode 'all)
      (write-string "\n);\n" port))))

;; -> function of a finding: where it is, as seen from a page of the manual, or #f
(define (addresses renderer index info)
  (define names (tags-of-names renderer index info))
  (define (rendered e) (link-target (send renderer render-content e index info)))
  (define (place tag) (and tag (rendered (link-element #f "x" tag))))
  (lambda (f)
    (case (finding-kind f)
      [(name) (place (hash-ref names (finding-title f) #f))]
      [(library) (place `(mod-path ,(finding-title f)))]
      [(page section) (place `(part ,(last (string-split (finding-where f) "#"))))]
      [else (rendered (element (style #f (list (link-resource
                                                (build-path examples (finding-where f)))))
                               "x"))])))

(define (link-target rendered)
  (match rendered
    [`((a ,attributes . ,_)) (cond [(assq 'href attributes) => cadr] [else #f])]
    [_ #f]))

;; name -> the tag of its entry.  Which libraries export a name is known when the whole manual is.
(define (tags-of-names renderer index info)
  (for/fold ([tags (hash)]) ([e (in-list (reverse (get-index-entries index info)))])
    (define about (described renderer index info (fourth e)))
    (if (exported-index-desc? about)
        (hash-set tags (string-join (second e)) (first e))
        tags)))

(define (described renderer index info description)
  (if (delayed-index-desc? description)
      ((delayed-index-desc-resolve description) renderer index info)
      description))
