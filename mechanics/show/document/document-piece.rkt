#lang racket/base
;; A document made of a program: its pieces, in their order.  A page (web-page.rkt) and LaTeX
;; (TeX-document.rkt) are written from the same pieces.

(provide (struct-out document) (struct-out heading) (struct-out prose)
         (struct-out code) (struct-out folded)
         (struct-out output) (struct-out result) (struct-out failure)
         joined-code)

;; title, language : strings, the latter #f if there is no program; pieces : of the kinds below
(struct document (title language pieces) #:transparent)

;; Comments of the author.  paragraphs : lists of lines, which end only where the author meant
;; them to
(struct heading (text) #:transparent)
(struct prose (paragraphs) #:transparent)

;; Forms as they are written; above : how many blank lines stand above them, 0 or 1
(struct code (text above) #:transparent)
(struct folded (label text) #:transparent)    ; a submodule, which was not run

;; Results of a form: its output, a value of shown-result.rkt, the message of an error
(struct output (text) #:transparent)
(struct result (shown) #:transparent)
(struct failure (text) #:transparent)

;; Pieces of code that follow each other become one.
(define (joined-code pieces)
  (for/foldr ([joined '()]) ([p (in-list pieces)])
    (define next (and (pair? joined) (car joined)))
    (if (and (code? p) (code? next))
        (cons (code (string-append (code-text p) (if (= 0 (code-above next)) "\n" "\n\n")
                                   (code-text next))
                    (code-above p))
              (cdr joined))
        (cons p joined))))
