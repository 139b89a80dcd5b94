#lang racket/base
;; Pictures of interactions' outcomes, made by files that are loaded for the first one.

(require "../display/drawing-library.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["outcome-picture.rkt" loaded? convert-drawn drawn-elements])

(provide convert-outcome outcome-elements why-no-pictures)

;; -> string, which ends with the remedy, or #f
(define why-no-pictures (reason-not-to-load loaded?))

;; request, default : as `convert` takes them
(define (convert-outcome o request default)
  (if (why-no-pictures) default (convert-drawn o request default)))

;; Of a value that is drawn of lines: as drawn-elements (outcome-picture.rkt); #f of others
(define (outcome-elements x) (and (not (why-no-pictures)) (drawn-elements x)))
