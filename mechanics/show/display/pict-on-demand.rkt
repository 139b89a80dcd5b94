#lang racket/base
;; Formulas as picts, loaded when the first one is asked for.

(require "drawing-library.rkt"
         "../../error/machine-limits.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["typeset-pict.rkt" [->pict value->pict] loaded?])

(provide ->pict)

;; -> string, which ends with what to install, or #f
(define why-not (reason-not-to-load loaded?))

(define (check-drawing-library)
  (define reason (why-not))
  (when reason
    (raise-unavailable '->pict "pictures cannot be drawn on this machine\n  reason: ~a" reason)))

(define ->pict
  (procedure-rename
   (make-keyword-procedure
    (lambda (keywords values . arguments)
      (check-drawing-library)
      (keyword-apply value->pict keywords values arguments))
    (lambda arguments
      (check-drawing-library)
      (apply value->pict arguments)))
   '->pict))
