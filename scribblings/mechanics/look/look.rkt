#lang racket/base
;; How the manual looks and what it can do in a browser, beyond what Scribble gives every
;; manual: code, tables and pictures that a narrow screen scrolls or scales, formulas that
;; are typeset and keep together, and a search box that needs no network.

(require racket/runtime-path
         scribble/core
         scribble/html-properties
         setup/getinfo
         "formula.rkt")

(provide manual-style manual-version formula)

(define-runtime-path style-sheet "look.css")
(define-runtime-path search-script "search.js")
(define-runtime-path source "../../..")

;; The style of the manual's title, which holds for all of its pages.
(define manual-style
  (style #f (list 'toc
                  (css-style-addition style-sheet)
                  (js-style-addition search-script))))

;; The version of the library, which Scribble would take to be Racket's.
(define manual-version
  ((get-info/full source) 'version))
