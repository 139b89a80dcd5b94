#lang racket/base
;; Sources of the manual's pages: their entries, and the examples at their prompts.
;;
;; `scribble/reader` reads a page as strings and forms.  It is loaded while the library is
;; compiled, and never by a program: hence the dynamic-require.

(require racket/file
         racket/list
         racket/path
         "entry.rkt" "prose.rkt")

(provide (struct-out page) (struct-out entry) (struct-out line) (struct-out section)
         manual-pages page-sections example-lines)

;; requires : data of modules that the prompt requires
;; lines : the lines at the prompt of the page, in its order; parts : all of it, strings and data
(struct page (file title requires entries lines parts))

;; tag : text, or #f where it is made of the heading; own-pages? : has each section of the page one
;; of its own?
(struct section (heading tag own-pages? parts))

;; names : ((name . signature) ...); library : symbol, of the module that provides them;
;; body : parts of text; lines : those of the entry's examples
(struct entry (names library body lines))

;; text : as it is written; form, run : data, the form shown and the form evaluated
;; error? : does the example raise an error?
(struct line (text form run error?))

;; The page in that file, then those that it includes, in their order.
(define (manual-pages file [library 'mechanics])
  (define text (file->string file))
  (define parts (read-parts file text))
  (define here (or (ormap module-named parts) library))
  (cons (make-page file text parts library)
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

;; library : of the page that includes it
(define (make-page file text parts library)
  (define lines (map (lambda (part) (lines-in part text)) parts))
  (define entries
    (for*/list ([(part own here) (in-parallel parts lines (libraries-along parts library))]
                [d (in-value (syntax->datum part))]
                #:when (pair? d)
                [names (in-value (entry-signatures d))]
                #:when (pair? names))
      (entry names here (body-of d) own)))
  (page file (title parts) (required-at-prompt parts) entries
        (append (typed-before parts text) (append* lines))
        (map syntax->datum parts)))

;; ---------------------------------------------------------------------------
;; Parts of a page

(define (with-head parts heads)
  (for/list ([part (in-list parts)]
             #:when (pair? (syntax-e part))
             #:when (memq (syntax-e (car (syntax-e part))) heads))
    (syntax->datum part)))

(define (included parts) (map cadr (with-head parts '(include-section))))

(define (title parts)
  (define found (with-head parts '(title)))
  (if (null? found) "" (section-heading (section-of (car found)))))

;; A page in sections: first the text before any, headed by the title, then each with its
;; heading, whatever its depth.
(define (page-sections p)
  (let divide ([parts (page-parts p)] [here (section (page-title p) #f #f '())])
    (define begun (and (pair? parts) (section-of (car parts))))
    (cond [(null? parts) (list (in-order here))]
          [(not begun) (divide (cdr parts) (with-part here (car parts)))]
          [(eq? (caar parts) 'title) (divide (cdr parts) begun)]
          [else (cons (in-order here) (divide (cdr parts) begun))])))

(define (with-part s part)
  (struct-copy section s [parts (cons part (section-parts s))]))

(define (in-order s)
  (struct-copy section s [parts (reverse (section-parts s))]))

;; @section[#:tag "tag"]{Heading} -> a section of no parts yet; anything else -> #f
(define (section-of part)
  (and (pair? part)
       (memq (car part) '(title section subsection subsubsection subsubsub*section))
       (section (plain-text (without-keywords (cdr part))) (tag-of part)
                (and (memq 'toc (flatten (keyword-value part '#:style))) #t)
                '())))

(define (tag-of part) (keyword-value part '#:tag))

(define (keyword-value part keyword)
  (define found (memq keyword part))
  (and found (cadr found)))

(define (module-named part)
  (define found (with-head (list part) '(defmodule)))
  (and (pair? found) (cadr (car found))))

;; For each part its library: that of the last @defmodule[...] before it, or else `library`.
(define (libraries-along parts library)
  (cond [(null? parts) '()]
        [else
         (define here (or (module-named (car parts)) library))
         (cons here (libraries-along (cdr parts) here))]))

;; The forms that make a prompt: '(require mechanics/book) and '(define plane ...) in
;; @(define session (make-session '(require mechanics/book) '(define plane ...))).
(define (session-forms parts)
  (for*/list ([part (in-list parts)]
              #:when (pair? (with-head (list part) '(define)))
              [made (in-value (syntax->list (caddr (syntax->list part))))]
              #:when (and made (memq (syntax-e (car made)) '(make-session make-picture-session)))
              [form (in-list (cdr made))])
    (cadr (syntax->list form))))

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

;; The text of (defproc head result text ...): an at-expression puts it behind its brackets.
(define (body-of d)
  (or (memf (lambda (x) (or (string? x) (and (pair? x) (memq (car x) text-forms)))) (cdr d)) '()))

(define text-forms
  '(racket italic math elem examples bigfloat-examples picture-examples tt emph bold))

;; ---------------------------------------------------------------------------
;; Examples

;; The lines of all examples in a part, however deep.
(define (lines-in part text)
  (define parts (if (syntax? part) (syntax->list part) part))
  (cond [(not (pair? parts)) '()]
        [(memq (syntax-e (car parts)) '(examples bigfloat-examples picture-examples))
         (example-lines parts text)]
        [else (append-map (lambda (p) (lines-in p text)) parts)]))

;; parts : of a form with examples; text : of its file -> lines
(define (example-lines parts text)
  (for/list ([form (in-list (forms-typed parts))]) (make-line form text)))

(define (forms-typed parts)
  (let loop ([parts (if (eq? (syntax-e (car parts)) 'examples) (cdr parts) (cddr parts))])
    (cond [(null? parts) '()]
          [(memq (syntax-e (car parts)) '(#:eval #:label)) (loop (cddr parts))]
          [(keyword? (syntax-e (car parts))) (loop (cdr parts))]
          [else (cons (car parts) (loop (cdr parts)))])))

(define (make-line form text)
  (define d (syntax->datum form))
  (define parts (syntax->list form))
  (define (made shown run error?) (line (source shown text) (syntax->datum shown) run error?))
  (case (and parts (pair? d) (car d))
    [(eval:error) (made (cadr parts) (cadr d) #t)]
    [(eval:check) (made (cadr parts) (cadr d) #f)]
    [(eval:alts) (made (cadr parts) (caddr d) #f)]
    [else (made form d #f)]))

;; The text of a form, its further lines moved to the left as far as the first one.
(define (source form text)
  (define start (sub1 (syntax-position form)))
  (define indentation (make-string (syntax-column form) #\space))
  (regexp-replace* (string-append "\n" indentation)
                   (substring text start (+ start (syntax-span form)))
                   "\n"))
