#lang racket/base
;; The example programs as they are in the source, with what they print and draw.

(require file/convertible
         racket/file
         racket/list
         racket/path
         (only-in racket/port make-pipe-with-specials)
         racket/runtime-path
         racket/string
         scribble/base
         scribble/core
         (only-in scribble/html-properties link-resource)
         (only-in scribble/manual typeset-code filepath)
         "example-cells.rkt" "look/typeset.rkt"
         (only-in "../../mechanics/lang/help/program-heading.rkt" program-heading)
         (only-in "../../mechanics/show/plot/on-demand.rkt" can-draw?))

(provide program program-link program-table)

(define-runtime-path examples "../../examples/mechanics")

;; The text of a program, without its opening comment and its tests, what it prints when
;; it is run, and the picture or the animation that it provides under that name, if it does.
;; context : syntax whose bindings the code is linked by.
(define (program name context)
  (if (examples-as-cells?) (para "This is " (program-link name) ".") (whole-program name context)))

(define (whole-program name context)
  (define path (build-path examples name))
  (define-values (output picture animation) (run path))
  (list* (para "This is " (program-link name) ":")
         (typeset-code #:context context (program-text path))
         (append
           (if (null? output) '() (cons (para "It prints") (map printed output)))
           (if picture (list (para "The picture:") (nested #:style 'inset picture)) '())
           (if animation
               (list (para "What it shows:") (nested #:style 'inset (elem (moving animation))))
               '()))))

;; An animation that offers no still picture to a browser, which then takes the GIF.
(struct moving (animation)
  #:property prop:convertible
  (lambda (m request default)
    (if (regexp-match? #rx"^(png|svg)" (symbol->string request))
        default
        (convert (moving-animation m) request default))))

;; A text, or a result as typeset.rkt has it.
(define (printed x)
  (if (string? x)
      (apply verbatim #:indent 2 (add-between (string-split x "\n" #:trim? #f) "\n"))
      (nested #:style 'inset x)))

;; A program's name, which leads to a copy of it among the pages of the manual; in a notebook, to
;; its notebook.
(define (program-link name [text (filepath (format "examples/mechanics/~a" name))])
  (elem #:style (style #f (list (if (examples-as-cells?)
                                    (target-url (notebook-of name))
                                    (link-resource (build-path examples name)))))
        text))

(define (notebook-of name) (format "../~a" (path-replace-extension name #".ipynb")))

;; The programs of a folder, each with what its first lines say of it.
(define (program-table folder)
  (tabular #:sep (hspace 2)
           #:column-properties '(top top)
           (for/list ([file (in-list (directory-list (build-path examples folder)))]
                      #:when (path-has-extension? file #".rkt"))
             (define name (format "~a/~a" folder file))
             (list (program-link name (filepath (path->string file)))
                   (program-heading (build-path examples name))))))

(define (program-text path)
  (define lines (file->lines path))
  (define body
    (takef (dropf (cdr lines) (lambda (l) (string-prefix? l ";;")))
           (lambda (l) (not (string-prefix? l "(module+ test")))))
  (string-append (car lines) "\n\n" (string-trim (string-join body "\n")) "\n"))

;; -> list of texts and results; the picture or #f
(define (run path)
  (define-values (in out) (make-pipe-with-specials))
  (define-values (picture animation)
    (parameterize ([current-output-port out] [current-namespace (fresh-namespace)])
      (parameterize ([current-print (printer)]) (dynamic-require path #f))
      (values (dynamic-require path 'picture (lambda () #f))
              (dynamic-require path 'animation (lambda () #f)))))
  (close-output-port out)
  (values (texts-and-results in) picture animation))

;; Results typeset by the program's library, in place of the text that it prints.
(define (printer)
  (define (of-program module name) (dynamic-require module name))
  (define print-result (of-program 'mechanics/lang/printer 'print-result))
  (define other (current-print))
  (define (print x) (parameterize ([current-print other]) (print-result x)))
  ((of-program 'mechanics/show/display/receiving-printer 'result-receiver)
   (typesetting print (of-program 'mechanics/show/document/line-markup 'value->line-markup))))

(define (texts-and-results in)
  (define (text-of characters) (string-trim (list->string (reverse characters)) "\n"))
  (define (with-text characters rest)
    (define text (text-of characters))
    (if (string=? text "") rest (cons text rest)))
  (let loop ([characters '()] [found '()])
    (define c (read-char-or-special in))
    (cond [(eof-object? c) (reverse (with-text characters found))]
          [(char? c) (loop (cons c characters) found)]
          [else (loop '() (cons c (with-text characters found)))])))

;; Each program has a library of its own, for it may assume something; what draws is
;; shared, so that the page can convert pictures.
(define-namespace-anchor here)
(define (fresh-namespace)
  (define-values (from to) (values (namespace-anchor->empty-namespace here)
                                   (make-base-empty-namespace)))
  (for ([module (in-list (if (can-draw?) '(file/convertible pict) '(file/convertible)))])
    (parameterize ([current-namespace from]) (dynamic-require module #f))
    (namespace-attach-module from module to))
  to)
