#lang racket/base
;; Tables as text for spreadsheets and learning platforms.
;;
;; A cell that begins like a formula would be a formula in a spreadsheet: it gets an apostrophe
;; before it, which marks text there.

(require (only-in racket/string string-append* string-join))

(provide rows->CSV CSV-safe CSV-cell-text)

;; rows : lists of values, displayed
(define (rows->CSV rows)
  (string-append* (for/list ([cells (in-list rows)])
                    (string-append (string-join (map CSV-cell cells) ",") "\r\n"))))

(define (CSV-cell x)
  (string-append "\"" (regexp-replace* #rx"\"" (CSV-safe (format "~a" x)) "\"\"") "\""))

;; Also the wide forms of the signs count, which some spreadsheets take for them.
(define formula #px"^\\s*[=+@\\-|%＝＋＠－]")

(define (CSV-safe text)
  (define plain (regexp-replace* #px"\\p{C}+" text " "))
  (if (regexp-match? formula plain) (string-append "'" plain) plain))

;; The text in the cell.
(define (CSV-cell-text cell)
  (if (and (regexp-match? #rx"^'" cell) (regexp-match? formula (substring cell 1)))
      (substring cell 1)
      cell))
