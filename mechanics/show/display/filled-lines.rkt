#lang racket/base
;; Words put into lines of at most so many characters.

(provide filled)

;; words : texts; lines after the first begin with `margin`
;; -> lines, none without words
(define (filled words width [margin ""])
  (for/fold ([lines '()] [line #f]
             #:result (reverse (if line (cons line lines) lines)))
            ([word (in-list words)])
    (cond [(not line) (values lines word)]
          [(<= (+ (string-length line) 1 (string-length word)) width)
           (values lines (string-append line " " word))]
          [else (values (cons line lines) (string-append margin word))])))
