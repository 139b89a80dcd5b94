#lang racket/base
;; The map, mechanics/README.md: the rooms in their order, and the files it names.
;;
;; A room is a line `- `folder/`: what it holds`; one that is indented is a folder of the
;; room before it.  A line may name several folders, or files that stand for a room.

(require racket/file
         racket/list
         racket/string
         "library.rkt")

(provide map-text parse-rooms room-of rooms mapped-folders mapped-files)

(define (map-text) (file->string (full-path "README.md")))

;; -> list of lists of names, lowest room first: ("algebra/zero/"), ("book/" "book.rkt") …
(define (parse-rooms text)
  (for/list ([line (in-list (string-split text "\n"))]
             #:when (regexp-match? #rx"^- `[^`]*(/|[.]rkt)`.*:" line))
    (line-names line)))

(define (line-names line)
  (map cadr (regexp-match* #rx"`([^`]+(?:/|[.]rkt))`" (car (string-split line ": "))
                           #:match-select values)))

(define rooms (parse-rooms (map-text)))

;; The folders that have a line, indented or not.
(define (mapped-folders text)
  (for*/list ([line (in-list (string-split text "\n"))]
              #:when (regexp-match? #rx"^ *- `" line)
              [name (in-list (line-names line))]
              #:when (string-suffix? name "/"))
    (string-trim name "/" #:left? #f)))

;; All files that the text names.
(define (mapped-files text)
  (remove-duplicates
   (filter (lambda (name) (regexp-match? #rx"[.](rkt|md)$" name))
           (map cadr (regexp-match* #rx"`([^` ]+)`" text #:match-select values)))))

;; The place of the room that a file is in, counted from below; #f if it is in none.  Of
;; several, the one named most exactly.
(define (room-of name [rooms rooms])
  (define found
    (for*/list ([(room i) (in-indexed rooms)]
                [place (in-list room)]
                #:when (if (string-suffix? place "/") (string-prefix? name place)
                           (equal? name place)))
      (cons i (string-length place))))
  (and (pair? found) (car (argmax cdr found))))
