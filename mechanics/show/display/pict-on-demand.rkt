#lang racket/base
;; Formulas as picts, loaded when the first one is asked for.

(require "drawing-library.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["typeset-pict.rkt" [->pict value->pict] loaded?])

(provide ->pict)

;; -> string, which ends with the remedy, or #f
(define why-not (reason-not-to-load loaded?))

(define ->pict
  (procedure-rename
   (make-keyword-procedure
    (lambda (keywords keyword-values . arguments)
      (check-drawing '->pict why-not)
      (keyword-apply value->pict keywords keyword-values arguments)))
   '->pict))
