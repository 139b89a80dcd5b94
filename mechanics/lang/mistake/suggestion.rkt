#lang racket/base
;; What an unknown name was meant for: one that another library of the package
;; defines, or a known one that is spelt nearly so.

(require "elsewhere.rkt" "spelling.rkt")

(provide suggestion)

;; known : list of symbols; stop : what ends a sentence that is no question
;; -> text or #f
(define (suggestion name known [stop ""])
  (define library (library-of name))
  (define names (if library '() (likely-names name known)))
  (cond [library (format "(require ~a) defines it~a" library stop)]
        [(pair? names) (format "did you mean ~a?" (alternatives names))]
        [else #f]))
