#lang racket/base
;; Text in screens.

(require (only-in racket/list split-at)
         racket/string
         "../error/message-words.rkt")

(provide first-screen)

;; rows, columns : size of a screen
;; -> the beginning that fits, with its newline; the rest, or #f; the number of its rows
(define (first-screen text rows columns)
  (define lines (screen-rows text columns))
  (define n (length lines))
  (cond [(<= n rows) (values text #f 0)]
        [else
         (define-values (shown more) (split-at lines rows))
         (values (as-text shown) (as-text more) (- n rows))]))

;; Lines too long for the screen are cut as the terminal cuts them.
(define (screen-rows text columns)
  (for*/list ([line (in-list (string-split (string-trim text "\n" #:left? #f) "\n" #:trim? #f))]
              [start (in-range 0 (max 1 (string-length line)) columns)])
    (substring line start (min (+ start columns) (string-length line)))))

(define (as-text rows) (string-append (joined rows "\n") "\n"))
