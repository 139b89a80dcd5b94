#lang racket/base
;; Pictures of what interactions show, made by what is loaded for the first one.

(require "../display/drawing-library.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["result-picture.rkt" loaded? convert-drawn])

(provide convert-outcome why-no-pictures)

;; -> string, which ends with what to install, or #f
(define why-no-pictures (reason-not-to-load loaded?))

;; request, default : as `convert` takes them
(define (convert-outcome o request default)
  (if (why-no-pictures) default (convert-drawn o request default)))
