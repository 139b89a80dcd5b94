#lang racket/base
;; Text that ends where a screen does.

(require (only-in racket/list add-between split-at)
         racket/string)

(provide first-screen)

;; text, and the size of a screen in rows and columns
;; -> the beginning that fits, with its newline; the rest, or #f; how many rows that takes
(define (first-screen text rows columns)
  (define lines (screen-rows text columns))
  (define n (length lines))
  (cond [(<= n rows) (values text #f 0)]
        [else
         (define-values (shown more) (split-at lines rows))
         (values (joined shown) (joined more) (- n rows))]))

;; Lines too long for the screen are cut as the terminal would.
(define (screen-rows text columns)
  (for*/list ([line (in-list (string-split (string-trim text "\n" #:left? #f) "\n" #:trim? #f))]
              [start (in-range 0 (max 1 (string-length line)) columns)])
    (substring line start (min (+ start columns) (string-length line)))))

(define (joined rows)
  (string-append (apply string-append (add-between rows "\n")) "\n"))
