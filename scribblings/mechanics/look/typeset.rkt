#lang racket/base
;; Elements that are typeset in a browser, and as written in every other form of the manual.

(require (only-in racket/class send)
         racket/list
         racket/runtime-path
         racket/string
         scribble/base
         scribble/core
         scribble/html-properties
         (only-in xml cdata xexpr->string))

(provide typeset-element typesetting formula-font)

;; markup : string; plain : content for all but HTML
(define (typeset-element markup plain)
  (define drawn (element (style #f (list (xexpr-property (cdata #f #f markup) ""))) '()))
  (delayed-element (lambda (renderer part info)
                     (if (memq 'html (send renderer current-render-mode)) drawn plain))
                   (lambda () plain)
                   (lambda () plain)))



;; ---------------------------------------------------------------------------
;; Results

;; A printer of results.  On a page, a port that takes elements, a browser shows its results
;; as formulas, with a switch to the prompt's output; elsewhere that output is all.
;; print : prints as a prompt does; value->markup : of the library whose values they are
(define ((typesetting print value->markup) x)
  (define markup (and (port-writes-special? (current-output-port)) (value->markup x)))
  (cond [markup
         (define printed (open-output-string))
         (parameterize ([current-output-port printed]) (print x))
         (define text (string-trim (get-output-string printed) "\n"))
         (write-special (typeset-element (with-switch markup text) (printed-lines text))
                        (current-output-port))
         (newline)]
        [else (print x)]))

(define (with-switch markup text)
  (format "<span class=\"answer\">~a~a<span class=\"printed\">~a</span></span>"
          (string-append "<input type=\"checkbox\" class=\"switch\" "
                         "title=\"as the prompt prints it\" "
                         "aria-label=\"as the prompt prints it\">")
          markup
          (xexpr->string text)))

;; Each where it begins.
(define (printed-lines text)
  (add-between (map printed-line (string-split text "\n" #:trim? #f)) (linebreak)))

(define (printed-line line)
  (define indentation (cdar (regexp-match-positions #px"^ *" line)))
  (list (hspace indentation) (element "RktRes" (substring line indentation))))

;; ---------------------------------------------------------------------------
;; The font

(define-runtime-path font-file "../../../mechanics/show/document/font/math.woff2")

;; Where this stands, the font is put beside the pages.
(define formula-font (element (style #f (list (install-resource font-file))) '()))
