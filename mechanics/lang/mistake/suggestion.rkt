#lang racket/base
;; What an unknown name was meant for: one that another library of the package defines, one
;; of the book that is not there yet, one that is called otherwise elsewhere, a formula written
;; as in print, or a known one that is spelt nearly so.

(require "elsewhere.rkt" "spelling.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["../help/later.rkt" later-sentence]
                   ["other-notation.rkt" notation-sentence]
                   ["typed-formula.rkt" typed-formula])

(provide suggestion)

;; known : list of symbols; stop : what ends a sentence that is no question
;; -> text or #f
(define (suggestion name known [stop ""])
  (define library (library-of name))
  (define later (and (not library) (later-sentence name)))
  (define elsewhere (and (not library) (not later) (notation-sentence name)))
  (define names (if (or library later elsewhere) '() (likely-names name known)))
  (cond [library (format "(require ~a) defines it~a" library stop)]
        [later (string-append later stop)]
        [elsewhere (string-append elsewhere stop)]
        [(pair? names) (format "did you mean ~a?" (alternatives names))]
        [(typed-formula name) => (lambda (f) (format "operations come first: ~a~a" f stop))]
        [else #f]))
