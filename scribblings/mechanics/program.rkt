#lang racket/base
;; The example programs as they are in the source, with what they print.

(require racket/file
         racket/list
         racket/runtime-path
         racket/string
         scribble/base
         (only-in scribble/manual typeset-code filepath))

(provide program)

(define-runtime-path examples "../../examples/mechanics")

;; The text of a program, without its opening comment and its tests, and what it
;; prints when it is run.  context : syntax whose bindings the code is linked by.
(define (program name context)
  (define path (build-path examples name))
  (list (para "This is " (filepath (format "examples/mechanics/~a" name)) ":")
        (typeset-code #:context context (program-text path))
        (para "It prints")
        (apply verbatim #:indent 2 (add-between (string-split (output-of path) "\n" #:trim? #f)
                                                "\n"))))

(define (program-text path)
  (define lines (file->lines path))
  (define body
    (takef (dropf (cdr lines) (lambda (l) (string-prefix? l ";;")))
           (lambda (l) (not (string-prefix? l "(module+ test")))))
  (string-append (car lines) "\n\n" (string-trim (string-join body "\n")) "\n"))

(define (output-of path)
  (define port (open-output-string))
  (parameterize ([current-output-port port]
                 [current-namespace (make-base-empty-namespace)])
    (dynamic-require path #f))
  (string-trim (get-output-string port)))
