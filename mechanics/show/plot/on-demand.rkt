#lang racket/base
;; The drawing library, loaded when the first picture is made.

(require "../display/drawing-library.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["picture.rkt" loaded? color-name? make-picture picture-bytes])

(provide can-draw? why-not color-name? make-picture picture-bytes)

;; -> string, which ends with what to install, or #f
(define why-not (reason-not-to-load loaded?))

(define (can-draw?) (not (why-not)))
