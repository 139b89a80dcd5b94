#lang racket/base
;; How each of many values is typeset, in every format, as it was found good by looking at it.
;;
;; `racket tests/mechanics/show/display/golden/golden.rkt` writes the files anew; the changes are to
;; be looked at.

(require mechanics
         (only-in mechanics/pict ->pict)
         (only-in mechanics/show/plot/on-demand why-not)
         "../../../support/checks.rkt"
         "../../../support/golden/values.rkt" "../../../support/skip.rkt"
         (only-in racket/file file->string)
         racket/runtime-path
         (only-in racket/string string-join))

(define-runtime-path here ".")

;; file -> what it has of a value
(define formats
  (list (list "infix.txt" ->infix)
        (list "text.txt" ->text)
        (list "text-40.txt" (lambda (x) (->text x #:width 40)))
        (list "TeX.txt" ->TeX)
        (list "TeX-40.txt" (lambda (x) (->TeX x #:width 40)))
        (list "MathML.txt" ->MathML)
        (list "pict.txt" (lambda (x) (drawn-texts (->pict x))))))

;; Loaded only where there is something that draws.
(define-runtime-path glyphs "../../../support/golden/glyphs.rkt")
(define (drawn-texts p) ((dynamic-require glyphs 'drawn-texts) p))

(define (possible? f) (not (and (equal? (car f) "pict.txt") (why-not))))

(define (all-of render)
  (for/list ([entry (in-list values-to-typeset)])
    (format "## ~a\n~a\n" (car entry) (render (cdr entry)))))

(define (golden file) (file->string (build-path here file)))

(define (without-end text) (regexp-replace #rx"\n+$" text ""))
(define (entries text) (regexp-split #rx"\n(?=## )" text))

(test-case "there are many values"
  (check-true (>= (length values-to-typeset) 120)))

(for ([f (in-list formats)])
  (skip-unless (possible? f) "nothing can be drawn here"
    (test-case (format "values are as in ~a" (car f))
      (for ([now (in-list (all-of (cadr f)))] [kept (in-list (entries (golden (car f))))])
        (check-equal? (without-end now) (without-end kept)))
      (check-equal? (length (entries (golden (car f)))) (length values-to-typeset)))))

(module+ main
  (for ([f (in-list formats)])
    (call-with-output-file* (build-path here (car f)) #:exists 'truncate
      (lambda (port) (write-string (string-join (all-of (cadr f)) "") port)))))
