#lang racket/base
;; The head in the definition of a reader's procedure: typed at the prompt, or in a file.

(require (only-in racket/file file->lines)
         (only-in racket/string string-join string-prefix?)
         "../unknown-name/known-name.rkt" "marked-line.rkt" "error-location.rkt"
         "../redefinition/heads.rkt" "../redefinition/prompt.rkt")

(provide own-head form-evaluated)

;; name : symbol; marks : of the exception -> head such as ((L m k) local), a datum, or #f
(define (own-head name marks)
  (define line (marked-line marks))
  (define file (or (own-file (defining-module name)) (and line (own-file (car line)))))
  (define head (or (head-at-prompt name) (and file (head-in-file name file))))
  (and (pair? head) head))

;; place : of a module -> path of its file, if that is the reader's, or #f
(define (own-file place)
  (and (path? place) (file-exists? place) (not (of-library? place)) place))

;; ---------------------------------------------------------------------------
;; Forms of a file

(define (head-in-file name file)
  (for/last ([form (in-list (forms-from file 1))]
             #:when (definition-of? name form))
    (definition-head form)))

(define (definition-of? name d)
  (and (list? d) (> (length d) 2)
       (eq? (car d) 'define)
       (eq? (head-name-in (cadr d)) name)))

;; The form that was being evaluated, of a file of the reader's, a datum; or #f
(define (form-evaluated marks)
  (define line (marked-line marks))
  (define file (and line (own-file (car line))))
  (define forms (if file (forms-from file (cdr line)) '()))
  (and (pair? forms) (car forms)))

;; The forms from that line on, as far as they can be read, without the line of the language.
(define (forms-from file line)
  (define lines (with-handlers ([exn:fail:filesystem? (lambda (e) '())]) (file->lines file)))
  (define kept
    (for/list ([text (in-list lines)] [i (in-naturals 1)] #:when (>= i line))
      (if (string-prefix? text "#lang") "" text)))
  (define port (open-input-string (string-join kept "\n")))
  (let loop ()
    (define form (with-handlers ([exn:fail:read? (lambda (e) eof)]) (read port)))
    (if (eof-object? form) '() (cons form (loop)))))
