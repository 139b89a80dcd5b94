#lang racket/base
;; The manual's examples as cells of notebooks: where a page is loaded for that, its examples are
;; not evaluated, but stand in the document as they are written, for guide-notebook.rkt.

(require (for-syntax racket/base racket/file
                     (only-in "../../mechanics/lang/help/page.rkt"
                              example-lines line-text line-error?))
         scribble/core)

(provide examples-as-cells? written-forms cells-block block-cells
         (struct-out cell-session) (struct-out example-cells))

(define examples-as-cells? (make-parameter #f))

;; forms : evaluated at its beginning; or #f, if it is no session of mechanics
(struct cell-session (forms))

;; forms : pairs of a text and whether it fails
(struct example-cells (session forms))

(define (cells-block session forms)
  (paragraph (style #f (list (example-cells session forms))) '()))

;; block -> example-cells or #f
(define (block-cells b)
  (and (paragraph? b)
       (for/first ([p (in-list (style-properties (paragraph-style b)))] #:when (example-cells? p))
         p)))

;; (written-forms part ...) : the parts of `examples` -> pairs as above
(define-syntax (written-forms stx)
  (define parts (cdr (syntax->list stx)))
  (define place (syntax-source (car (reverse parts))))
  #`'#,(for/list ([l (in-list (example-lines (cons #'examples parts) (file->string place)))])
         (define text (line-text l))
         (cons (cond [(regexp-match #px"^\\(code:line (.*)\\)$" text) => cadr] [else text])
               (line-error? l))))
