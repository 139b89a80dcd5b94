#lang racket/base
;; The arguments of commands, and the files that they write, whole or not at all.

(require racket/cmdline
         racket/path
         "../../error/complain.rkt" "../../generic/output-file.rkt")

(provide read-arguments write-text short-path plain-file-name print-paths check-new-file)

;; ---------------------------------------------------------------------------
;; Arguments

;; valued, repeated : options with a value; a repeated one may stand several times
;; argument : name of the one argument that is no option
;; -> that argument; and option -> #t or its value, or #f; of a repeated one the list of its values
(define (read-arguments command arguments #:argument [argument "file"]
                        #:valued [valued '("-o")] #:switches [switches '()]
                        #:repeated [repeated '()])
  (define (with-value option) (list (list option) (lambda (_ x) (cons option x)) '("" "value")))
  (define (switch option) (list (list option) (lambda (_) (cons option #t)) '("")))
  (parse-command-line
   (format "raco mechanics ~a" command)
   (options-first arguments (append valued repeated))
   `((once-each ,@(map with-value valued) ,@(map switch switches))
     (multi ,@(map with-value repeated)))
   (lambda (given file)
     (define (value-of option)
       (define found (for/list ([g (in-list given)] #:when (equal? option (car g))) (cdr g)))
       (cond [(member option repeated) found]
             [(pair? found) (car found)]
             [else #f]))
     (values file value-of))
   (list argument)))

;; Options may stand behind the file, too.
(define (options-first arguments with-value)
  (let loop ([left arguments] [options '()] [files '()])
    (cond [(null? left) (append options files)]
          ;; a file behind it would be taken for the value that was forgotten
          [(and (null? (cdr left)) (member (car left) with-value)) (append options left)]
          [(member (car left) with-value)
           (loop (cddr left) (append options (list (car left) (cadr left))) files)]
          [(regexp-match? #rx"^-" (car left))
           (loop (cdr left) (append options (list (car left))) files)]
          [else (loop (cdr left) options (append files (list (car left))))])))

;; ---------------------------------------------------------------------------
;; Files

(define (write-text who file text) (write-file who file (string->bytes/utf-8 text)))

(define (short-path p)
  (define relative (find-relative-path (current-directory) p))
  (if (regexp-match? #rx"^[.][.]" (path->string relative)) p relative))

;; A name for a file; students may choose any, in any script.
(define (plain-file-name text)
  (define plain (regexp-replace* #px"(?![\\w .@-]|\\p{L}|\\p{M}|\\p{N})." text "_"))
  (if (regexp-match? #rx"^[.]*$" plain) (string-append "_" plain) plain))

(define (print-paths files) (for ([f (in-list files)]) (printf "~a\n" (short-path f))))

;; from : file that must not be overwritten, or #f; extension : that the name must have, or #f
(define (check-new-file who to [from #f] [extension #f])
  (when (equal? from to) (complain who "the result would replace the program\n  file: ~a" to))
  (check-file who to)
  (unless (or (not extension) (path-has-extension? to extension))
    (complain who "it writes a file that ends with ~a\n  given: ~a~a" extension (short-path to)
              (if (path-has-extension? to #".pdf") about-PDF ""))))

(define about-PDF
  (string-append "\n  for PDF: what ends with .tex is made one by pdflatex, what ends with .html "
                 "by the browser's print command"))
