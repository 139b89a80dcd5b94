#lang racket/base
;; What a document made of a program consists of: its pieces, in their order.  A page (web-page.rkt)
;; and LaTeX (TeX-document.rkt) are written from the same.

(provide (struct-out document) (struct-out heading) (struct-out prose)
         (struct-out code) (struct-out folded)
         (struct-out output) (struct-out result) (struct-out failure)
         joined-code)

;; title, language : strings, the latter #f of what is no program; pieces : list of the following
(struct document (title language pieces) #:transparent)

;; What the author wrote in comments.  paragraphs : lists of lines, where a line ends only
;; where the author meant it to
(struct heading (text) #:transparent)
(struct prose (paragraphs) #:transparent)

;; Forms as they are written; above : how many blank lines stand above them, 0 or 1
(struct code (text above) #:transparent)
(struct folded (label text) #:transparent)    ; a submodule, which was not run

;; What came of a form: what it printed, a value of shown-result.rkt, the message of an error
(struct output (text) #:transparent)
(struct result (shown) #:transparent)
(struct failure (text) #:transparent)

;; Forms between which there is nothing to show stand together.
(define (joined-code pieces)
  (cond [(or (null? pieces) (null? (cdr pieces))) pieces]
        [(and (code? (car pieces)) (code? (cadr pieces)))
         (define-values (a b) (values (car pieces) (cadr pieces)))
         (joined-code (cons (code (string-append (code-text a)
                                                 (if (= 0 (code-above b)) "\n" "\n\n")
                                                 (code-text b))
                                  (code-above a))
                            (cddr pieces)))]
        [else (cons (car pieces) (joined-code (cdr pieces)))]))
