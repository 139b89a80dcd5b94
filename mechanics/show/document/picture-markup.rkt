#lang racket/base
;; Pictures within a page: SVG as elements of the page, others as data of an image.
;;
;; Names that Cairo gives to parts of a picture, glyph0-1 and the like, are the same in every
;; picture; on one page each needs its own.

(require net/base64
         "shown-result.rkt")

(provide picture->markup)

;; More bytes than these are better as points.
(define largest-svg 1000000)

;; number : of the picture on the page -> markup
(define (picture->markup p number)
  (define svg (shown-picture-svg p))
  (define png (shown-picture-png p))
  (if (and svg (or (not png) (< (bytes-length svg) largest-svg)))
      (svg->markup (bytes->string/utf-8 svg #\?) (format "p~a-" number))
      (format "<img alt=\"\" src=\"data:image/png;base64,~a\"/>" (base64-encode png #""))))

(define (svg->markup text prefix)
  (define body (regexp-replace #rx"^.*?(?=<svg)" text ""))
  (define own-names
    (for/fold ([text body]) ([place (in-list '(#rx"( id=\")" #rx"(href=\"#)" #rx"(url[(]#)"))])
      (regexp-replace* place text (string-append "\\1" prefix))))
  (regexp-replace* #px"^<svg[^>]*>" own-names in-pixels))

;; Points would be a third larger than what was asked for.
(define (in-pixels tag)
  (regexp-replace* #px" (width|height)=\"([\\d.]+)pt\"" tag " \\1=\"\\2\""))
