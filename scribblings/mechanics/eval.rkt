#lang racket/base
;; The prompts that the manual's examples run at.

(require (for-syntax racket/base)
         racket/sandbox (prefix-in s: scribble/example) scribble/manual
         "example-cells.rkt" "look/typeset.rkt"
         (only-in "../../mechanics/numeric/bigfloat/bigfloat-arithmetic.rkt" check-bigfloats)
         (only-in "../../mechanics/show/plot/on-demand.rkt" why-not))

(provide examples bigfloat-examples picture-examples
         make-session make-picture-session make-typeset-session make-racket-session close-session
         missing-pictures)

;; Columns of a page of the manual that a result may fill.
(define page-columns 66)

;; Scribble's, or what makes a cell of a notebook
(define-syntax (examples stx)
  (syntax-case stx ()
    [(_ #:eval session part ...)
     (with-syntax ([forms (datum->syntax stx (list* #'written-forms (cdr (syntax->list stx))) stx)])
       #'(if (cell-session? session)
             (cells-block session forms)
             (s:examples #:eval session part ...)))]))

;; A prompt of `#lang mechanics`, which prints as the prompt of a reader does.
(define (make-session . forms)
  (session-of forms #:pretty-print? #f install-printer choose-expressions))

(define (session-of forms #:lang [lang 'mechanics] #:pretty-print? pretty? . preparations)
  (cond [(examples-as-cells?) (cell-session (and (eq? lang 'mechanics) forms))]
        [else
         (define session (apply s:make-base-eval #:lang lang #:pretty-print? pretty? forms))
         (for ([prepare (in-list preparations)]) (call-in-sandbox-context session prepare))
         session]))

;; The same with `mechanics/plot`, and with Racket's printer for what is no part of
;; mechanics, which puts pictures on the page.
(define (make-picture-session . forms)
  (session-of (cons '(require mechanics/plot) forms)
              #:pretty-print? #t install-printer choose-expressions))

;; A prompt that puts typeset results on the page.
(define (make-typeset-session . forms)
  (session-of forms #:pretty-print? #t install-printer))

;; The session's library typesets, for its values are no others'.
(define (install-printer)
  ((dynamic-require 'racket/pretty 'pretty-print-columns) page-columns)
  ((dynamic-require 'mechanics/lang/printer 'install-printer!))
  (define value->markup (dynamic-require 'mechanics/show/document/line-markup 'value->line-markup))
  (define receiver (dynamic-require 'mechanics/show/display/receiving-printer 'result-receiver))
  (current-print (receiver (typesetting (current-print) value->markup))))

;; As in a terminal: the page would take pictures.
(define (choose-expressions) ((dynamic-require 'mechanics 'display-style) 'expression))

;; The note of a page with pictures where there are none.
(define (missing-pictures)
  (if (why-not)
      (nested #:style 'inset
              "This manual was built on a machine without the libraries that draw: frames are "
              "shown as text, as in a terminal.")
      '()))

;; A prompt of plain Racket: what happens where `mechanics` was forgotten.
(define (make-racket-session)
  (session-of '() #:lang 'racket/base #:pretty-print? #f))

(define (close-session session) (unless (cell-session? session) (s:close-eval session)))

;; Examples in numbers of higher precision, without their results where the manual is
;; built on a machine that cannot compute them.
(define-syntax-rule (bigfloat-examples session form ...)
  (if bigfloats?
      (examples #:eval session form ...)
      (racketblock form ...)))

;; Examples that draw, without their results where nothing can be drawn.
(define-syntax-rule (picture-examples session form ...)
  (if (why-not)
      (racketblock form ...)
      (examples #:eval session form ...)))

(define bigfloats?
  (with-handlers ([exn:fail? (lambda (e) #f)])
    (check-bigfloats 'examples)
    #t))
