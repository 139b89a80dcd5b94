#lang racket/base
;; How a procedure of the reader's is called, by the head of its definition: the one typed at
;; the prompt, or that in the file where it stands.

(require (only-in racket/file file->lines)
         (only-in racket/string string-join string-prefix?)
         "marked-line.rkt" "whereabouts.rkt"
         "../redefinition/heads.rkt" "../redefinition/prompt.rkt")

(provide own-head form-evaluated)

;; name : symbol; marks : of the exception -> head such as ((L m k) local), a datum, or #f
(define (own-head name marks)
  (define file (or (file-defining name) (file-running marks)))
  (define head (or (head-at-prompt name) (and file (head-in-file name file))))
  (and (pair? head) head))

;; Of the module that the prompt has it from.
(define (file-defining name)
  (define binding
    (with-handlers ([exn:fail? (lambda (e) #f)])
      (identifier-binding (namespace-symbol->identifier name))))
  (and (pair? binding)
       (file-of (resolved-module-path-name (module-path-index-resolve (car binding))))))

(define (file-running marks)
  (define line (marked-line marks))
  (and line (file-of (car line))))

(define (file-of place)
  (define file (if (pair? place) (car place) place))
  (and (path? file) (file-exists? file) (not (of-library? file)) file))

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

;; The form that a file was being evaluated at, a datum; or #f
(define (form-evaluated marks)
  (define line (marked-line marks))
  (define file (and line (file-of (car line))))
  (define forms (if file (forms-from file (cdr line)) '()))
  (and (pair? forms) (car forms)))

;; As far as they can be read; the line that names the language is none.
(define (forms-from file line)
  (define lines (with-handlers ([exn:fail:filesystem? (lambda (e) '())]) (file->lines file)))
  (define kept
    (for/list ([text (in-list lines)] [i (in-naturals 1)] #:when (>= i line))
      (if (string-prefix? text "#lang") "" text)))
  (define port (open-input-string (string-join kept "\n")))
  (let loop ()
    (define form (with-handlers ([exn:fail:read? (lambda (e) eof)]) (read port)))
    (if (eof-object? form) '() (cons form (loop)))))
