#lang racket/base
;; Pages of the manual as they are written: their entries, and the examples at their prompts.
;;
;; `scribble/reader` reads a page as strings and forms.  It is loaded while the library is
;; compiled, and never by a program; so it is asked for by name.

(require racket/file
         racket/list
         racket/path
         "entry.rkt")

(provide (struct-out page) (struct-out entry) (struct-out line)
         manual-pages)

;; library : symbol; requires : data of modules that the prompt requires
;; lines : all that is typed at the prompt of the page, in its order
(struct page (file title library requires entries lines))

;; names : ((name . signature) ...); library : that has them; body : parts of text; lines : its
;; own of the page
(struct entry (names library body lines))

;; text : as it is written; form, run : data, what is shown and what is evaluated
;; error? : is it to raise an error
(struct line (text form run error?))

;; The page in that file, then those that it includes, in their order.
(define (manual-pages file [library 'mechanics])
  (define text (file->string file))
  (define parts (read-parts file text))
  (define here (or (library-of-page parts) library))
  (cons (make-page file text parts here library)
        (append-map (lambda (name) (manual-pages (simplify-path (build-path (path-only file) name))
                                                 here))
                    (included parts))))

;; -> strings and syntax
(define (read-parts file text)
  (define read-inside (dynamic-require 'scribble/reader 'read-syntax-inside))
  (define port (open-input-string text))
  (port-count-lines! port)
  (read-line port)
  (syntax->list (read-inside file port)))

;; library : of the page; outside : of the page that includes it
(define (make-page file text parts library outside)
  (define lines (map (lambda (part) (lines-in part text)) parts))
  (define entries
    (for/list ([part (in-list parts)] [own (in-list lines)] [here (libraries-along parts outside)]
               #:when (entry-form? (syntax->datum part)))
      (make-entry (syntax->datum part) here own)))
  (page file (title parts) library (required-at-prompt parts) entries
        (append (typed-before parts text) (append* lines))))

;; ---------------------------------------------------------------------------
;; What stands in a page

(define (with-head parts heads)
  (for/list ([part (in-list parts)]
             #:when (pair? (syntax-e part))
             #:when (memq (syntax-e (car (syntax-e part))) heads))
    (syntax->datum part)))

(define (included parts) (map cadr (with-head parts '(include-section))))

(define (title parts)
  (define found (with-head parts '(title)))
  (if (null? found) "" (last (car found))))

(define (module-named part)
  (define found (with-head (list part) '(defmodule)))
  (and (pair? found) (cadr (car found))))

;; As in @defmodule[mechanics/book].
(define (library-of-page parts) (ormap module-named parts))

;; For each part the library of what it describes: a module further down begins there, and holds
;; for the whole of a page that has no entry before it.
(define (libraries-along parts library)
  (define-values (libraries last-one)
    (for/fold ([libraries '()] [here library]) ([part (in-list parts)])
      (define next (or (module-named part) here))
      (values (cons next libraries) next)))
  (reverse libraries))

;; What a prompt is made of: '(require mechanics/book) and '(define plane ...) in
;; @(define session (make-session '(require mechanics/book) '(define plane ...))).
(define (session-forms parts)
  (for*/list ([part (in-list parts)]
              #:when (pair? (with-head (list part) '(define)))
              [made (in-value (syntax->list (caddr (syntax->list part))))]
              #:when (and made (session-maker? (syntax-e (car made))))
              [form (in-list (cdr made))])
    (cadr (syntax->list form))))

(define (session-maker? name) (memq name '(make-session make-picture-session)))

(define (requires? form) (eq? (car (syntax->datum form)) 'require))

(define (required-at-prompt parts)
  (append (if (memq 'make-picture-session (flatten (with-head parts '(define))))
              '(mechanics/plot)
              '())
          (append-map (lambda (form) (cdr (syntax->datum form)))
                      (filter requires? (session-forms parts)))))

(define (typed-before parts text)
  (for/list ([form (in-list (session-forms parts))] #:unless (requires? form))
    (make-line form text)))

;; ---------------------------------------------------------------------------
;; Entries

;; (defproc head result text ...): what follows the signature.  An at-expression puts the
;; text behind all that is in brackets.
(define (make-entry d library lines) (entry (entry-signatures d) library (body-of d) lines))

(define (body-of d)
  (define after
    (case (car d)
      [(defproc defthing defparam defstruct*) (if (eq? (car d) 'defparam) 4 3)]
      [(defform) (if (memq '#:id d) 4 2)]
      [else 2]))
  (define rest (drop d (min after (length d))))
  (dropf rest (lambda (x) (not (or (string? x) (and (pair? x) (memq (car x) text-forms)))))))

(define text-forms
  '(racket italic math elem examples bigfloat-examples picture-examples tt emph bold))

;; ---------------------------------------------------------------------------
;; Examples

;; All lines of the examples that stand in a part, however deep.
(define (lines-in part text)
  (define parts (if (syntax? part) (syntax->list part) part))
  (cond [(not (pair? parts)) '()]
        [(memq (syntax-e (car parts)) '(examples bigfloat-examples picture-examples))
         (for/list ([form (in-list (forms-typed parts))]) (make-line form text))]
        [else (append-map (lambda (p) (lines-in p text)) parts)]))

(define (forms-typed parts)
  (let loop ([parts (if (eq? (syntax-e (car parts)) 'examples) (cdr parts) (cddr parts))])
    (cond [(null? parts) '()]
          [(keyword? (syntax-e (car parts))) (loop (cddr parts))]
          [else (cons (car parts) (loop (cdr parts)))])))

(define (make-line form text)
  (define d (syntax->datum form))
  (define parts (syntax->list form))
  (define (made shown run error?) (line (source shown text) (syntax->datum shown) run error?))
  (case (and parts (pair? d) (car d))
    [(eval:error) (made (cadr parts) (cadr d) #t)]
    [(eval:alts) (made (cadr parts) (caddr d) #f)]
    [else (made form d #f)]))

;; The text of a form, its further lines moved to the left as far as the first one.
(define (source form text)
  (define start (sub1 (syntax-position form)))
  (define indentation (make-string (syntax-column form) #\space))
  (regexp-replace* (string-append "\n" indentation)
                   (substring text start (+ start (syntax-span form)))
                   "\n"))
