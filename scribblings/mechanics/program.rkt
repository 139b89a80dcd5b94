#lang racket/base
;; The example programs as they are in the source, with what they print and draw.

(require file/convertible
         racket/file
         racket/list
         racket/path
         racket/runtime-path
         racket/string
         scribble/base
         scribble/core
         (only-in scribble/html-properties link-resource)
         (only-in scribble/manual typeset-code filepath)
         (only-in "../../mechanics/plot/on-demand.rkt" can-draw?))

(provide program program-link program-table)

(define-runtime-path examples "../../examples/mechanics")

;; The text of a program, without its opening comment and its tests, what it prints when
;; it is run, and the picture or the animation that it provides under that name, if it does.
;; context : syntax whose bindings the code is linked by.
(define (program name context)
  (define path (build-path examples name))
  (define-values (output picture animation) (run path))
  (list* (para "This is " (program-link name) ":")
         (typeset-code #:context context (program-text path))
         (append
          (if (string=? output "") '() (list (para "It prints") (printed output)))
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

(define (printed output)
  (apply verbatim #:indent 2 (add-between (string-split output "\n" #:trim? #f) "\n")))

;; A program's name, which leads to a copy of it among the pages of the manual.
(define (program-link name [text (filepath (format "examples/mechanics/~a" name))])
  (elem #:style (style #f (list (link-resource (build-path examples name)))) text))

;; The programs of a folder, each with what its first lines say of it.
(define (program-table folder)
  (tabular #:sep (hspace 2)
           #:column-properties '(top top)
           (for/list ([file (in-list (directory-list (build-path examples folder)))]
                      #:when (path-has-extension? file #".rkt"))
             (define name (format "~a/~a" folder file))
             (list (program-link name (filepath (path->string file)))
                   (program-heading (build-path examples name))))))

;; The first sentence of its opening comment; "p." and "pp." end none.
(define (program-heading path)
  (define comment
    (takef (cdr (file->lines path)) (lambda (l) (regexp-match? #px"^;; \\S" l))))
  (define text
    (string-normalize-spaces (string-join (map (lambda (l) (substring l 3)) comment) " ")))
  (cond [(regexp-match #px"^.*?(?<![ (]p)(?<![ (]pp)[.?](?=\\s|$)" text) => car]
        [else (string-append text ".")]))

(define (program-text path)
  (define lines (file->lines path))
  (define body
    (takef (dropf (cdr lines) (lambda (l) (string-prefix? l ";;")))
           (lambda (l) (not (string-prefix? l "(module+ test")))))
  (string-append (car lines) "\n\n" (string-trim (string-join body "\n")) "\n"))

(define (run path)
  (define port (open-output-string))
  (define-values (picture animation)
    (parameterize ([current-output-port port] [current-namespace (fresh-namespace)])
      (dynamic-require path #f)
      (values (dynamic-require path 'picture (lambda () #f))
              (dynamic-require path 'animation (lambda () #f)))))
  (values (string-trim (get-output-string port)) picture animation))

;; Each program has a library of its own, for it may assume something; what draws is
;; shared, so that the page can convert pictures.
(define-namespace-anchor here)
(define (fresh-namespace)
  (define-values (from to) (values (namespace-anchor->empty-namespace here)
                                   (make-base-empty-namespace)))
  (for ([module (in-list (if (can-draw?) '(file/convertible plot/no-gui) '(file/convertible)))])
    (parameterize ([current-namespace from]) (dynamic-require module #f))
    (namespace-attach-module from module to))
  to)
