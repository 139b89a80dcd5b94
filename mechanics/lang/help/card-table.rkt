#lang racket/base
;; The cards, made of the manual's reference when this file is compiled; a change of a page has it
;; compiled anew.

(require (for-syntax racket/base
                     compiler/cm-accomplice
                     "make-cards.rkt" "page.rkt"))

(provide cards)

(define-syntax (table-of-cards stx)
  (define folder (let-values ([(base name dir?) (split-path (syntax-source stx))]) base))
  (define reference
    (simplify-path (build-path folder 'up 'up 'up "scribblings" "mechanics" "reference.scrbl")))
  (parameterize ([print-reader-abbreviations #t])
    (define pages (manual-pages reference))
    (for ([p (in-list pages)]) (register-external-file (page-file p)))
    (datum->syntax stx (list 'quote (manual-cards pages stx)) stx)))

;; name -> card
(define cards
  (table-of-cards))
