#lang racket/base
;; The manual's examples as cells of notebooks: where a page is loaded for that, its examples are
;; not evaluated, but stand in the document as they are written, for guide-notebook.rkt.

(require (for-syntax racket/base racket/file)
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
  (define (text-between first-form last-form)
    (define text (file->string (syntax-source first-form)))
    (substring text (- (syntax-position first-form) 1)
               (+ (syntax-position last-form) (syntax-span last-form) -1)))
  (define (heads form) (and (pair? (syntax-e form)) (syntax-e (car (syntax-e form)))))
  (define (written form)
    (case (heads form)
      [(eval:error eval:check eval:alts) (written (cadr (syntax->list form)))]
      [(code:line)
       (define parts (cdr (syntax->list form)))
       (text-between (car parts) (car (reverse parts)))]
      [else (text-between form form)]))
  (define forms
    (let loop ([parts (cdr (syntax->list stx))])
      (cond [(null? parts) '()]
            [(memq (syntax-e (car parts)) '(#:eval #:label)) (loop (cddr parts))]
            [(keyword? (syntax-e (car parts))) (loop (cdr parts))]
            [else (cons (cons (written (car parts)) (eq? 'eval:error (heads (car parts))))
                        (loop (cdr parts)))])))
  #`'#,forms)
