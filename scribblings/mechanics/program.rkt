#lang racket/base
;; The example programs as they are in the source, with what they print and draw.

(require racket/file
         racket/list
         racket/runtime-path
         racket/string
         scribble/base
         (only-in scribble/manual typeset-code filepath)
         (only-in "../../mechanics/plot/on-demand.rkt" can-draw?))

(provide program)

(define-runtime-path examples "../../examples/mechanics")

;; The text of a program, without its opening comment and its tests, what it prints when
;; it is run, and the picture that it provides under that name, if it does.
;; context : syntax whose bindings the code is linked by.
(define (program name context)
  (define path (build-path examples name))
  (define-values (output picture) (run path))
  (list* (para "This is " (filepath (format "examples/mechanics/~a" name)) ":")
         (typeset-code #:context context (program-text path))
         (para "It prints")
         (apply verbatim #:indent 2 (add-between (string-split output "\n" #:trim? #f) "\n"))
         (if picture (list (para "The picture:") (nested #:style 'inset picture)) '())))

(define (program-text path)
  (define lines (file->lines path))
  (define body
    (takef (dropf (cdr lines) (lambda (l) (string-prefix? l ";;")))
           (lambda (l) (not (string-prefix? l "(module+ test")))))
  (string-append (car lines) "\n\n" (string-trim (string-join body "\n")) "\n"))

(define (run path)
  (define port (open-output-string))
  (define picture
    (parameterize ([current-output-port port] [current-namespace (fresh-namespace)])
      (dynamic-require path #f)
      (dynamic-require path 'picture (lambda () #f))))
  (values (string-trim (get-output-string port)) picture))

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
