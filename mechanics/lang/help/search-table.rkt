#lang racket/base
;; The table of the search, made of the manual and the programs when this file is compiled; a
;; change of one of them has it compiled anew.

(require (for-syntax racket/base
                     compiler/cm-accomplice
                     "card-table.rkt" "documents.rkt" "make-search-table.rkt" "page.rkt"))

(provide search-table)

(define-syntax (table-of-search stx)
  (define folder (let-values ([(base name dir?) (split-path (syntax-source stx))]) base))
  (define (place . parts) (simplify-path (apply build-path folder 'up 'up 'up parts)))
  (define pages (manual-pages (place "scribblings" "mechanics" "mechanics.scrbl")))
  (define programs (place "examples" "mechanics"))
  (for ([p (in-list pages)]) (register-external-file (page-file p)))
  (for ([f (in-directory programs)] #:when (regexp-match? #rx"[.]rkt$" (path->bytes f)))
    (register-external-file f))
  (parameterize ([print-reader-abbreviations #t])
    (define table (make-search-table (documents pages cards programs)))
    (datum->syntax stx (list 'quote table) stx)))

;; (vector findings priors terms)
(define search-table
  (table-of-search))
