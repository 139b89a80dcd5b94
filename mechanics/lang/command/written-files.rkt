#lang racket/base
;; Files that commands write: whole or not at all, under another name first; and how they are
;; named to the reader.

(require racket/path
         "../../error/complain.rkt" "../../show/plot/picture-file.rkt")

(provide write-whole short-path options-first check-new-file)

(define (write-whole file bytes) (write-file 'mechanics file bytes))

(define (short-path p)
  (define relative (find-relative-path (current-directory) p))
  (if (regexp-match? #rx"^[.][.]" (path->string relative)) p relative))

;; Options may stand behind the file, too.  with-value : those that take one
(define (options-first arguments [with-value '("-o")])
  (let loop ([left arguments] [options '()] [files '()])
    (cond [(null? left) (append options files)]
          ;; a file behind it would be taken for the value that was forgotten
          [(and (null? (cdr left)) (member (car left) with-value)) (append options left)]
          [(and (member (car left) with-value) (pair? (cdr left)))
           (loop (cddr left) (append options (list (car left) (cadr left))) files)]
          [(regexp-match? #rx"^-" (car left))
           (loop (cdr left) (append options (list (car left))) files)]
          [else (loop (cdr left) options (append files (list (car left))))])))

;; from : what must not be overwritten, or #f; extension : with which its name is to end, or #f
(define (check-new-file who to [from #f] [extension #f])
  (when (equal? from to) (complain who "the result would replace the program\n  file: ~a" to))
  (check-file who to)
  (unless (or (not extension) (path-has-extension? to extension))
    (complain who "it writes a file that ends with ~a\n  given: ~a~a" extension (short-path to)
              (if (path-has-extension? to #".pdf") about-PDF ""))))

(define about-PDF
  (string-append "\n  for PDF: what ends with .tex is made one by pdflatex, what ends with .html "
                 "by the browser's print command"))
