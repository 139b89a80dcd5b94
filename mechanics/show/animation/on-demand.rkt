#lang racket/base
;; Parts that need the drawing library, loaded when the first picture is made.

(require "../display/drawing-library.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["paint.rkt" loaded? paint])

(provide paint why-no-pictures)

;; -> string, which ends with the remedy, or #f
(define why-no-pictures (reason-not-to-load loaded?))
