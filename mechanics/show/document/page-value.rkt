#lang racket/base
;; A result as elements of a page.
;;
;; A formula too wide for a narrow screen is there a second time, broken for 40 columns; the style
;; sheet shows the version that fits.  Reports are text with formulas in it, whose lines break as
;; those of a paragraph.
;;
;; A picture is SVG as elements of the page, or else data of an image.  Names that Cairo gives to
;; parts of a picture, glyph0-1 and the like, are the same in every picture; on one page each
;; needs its own.

(require net/base64
         racket/list
         (only-in xml cdata empty-tag-shorthand html-empty-tags write-xexpr)
         "../../algebra/notation/tree.rkt"
         "../typesetting/MathML.rkt" "../typesetting/break.rkt"
         "shown-result.rkt")

(provide shown->xexprs tree->xexprs inline-xexprs inline-formula visible raw markup png->URL)

(define wide 80)
(define narrow 40)

;; text : well-formed markup
(define (raw text) (cdata #f #f text))

;; -> string
(define (markup xexpr)
  (define port (open-output-string))
  (parameterize ([empty-tag-shorthand html-empty-tags]) (write-xexpr xexpr port))
  (get-output-string port))

;; number : -> number of the picture on the page
(define (shown->xexprs s number)
  (cond [(shown-formula? s)
         (append (tree->xexprs (shown-formula-tree s))
                 (map note->xexpr (shown-formula-notes s)))]
        [(shown-table? s) (list (table->xexpr s))]
        [(shown-picture? s)
         (list `(figure ([aria-label ,(visible (shown-picture-text s))])
                        ,(raw (picture->markup s (number)))))]
        [else (list (text->xexpr (shown-text-text s)))]))

(define (text->xexpr text) `(pre ([class ,(string-append "text" (verdict-class text))])
                                 ,(visible text)))

(define (note->xexpr tree) `(p ([class "note"]) ,@(inline-xexprs tree)))

;; ---------------------------------------------------------------------------
;; Trees

(define (tree->xexprs t)
  (cond [(report? t) (list (report->xexpr t))]
        [(plain? t) (list (text->xexpr (plain-text t)))]
        [(and (listing? t) (ormap report? (listing-items t)))
         (append-map tree->xexprs (listing-items t))]
        [else (formula->xexprs t)]))

(define (fitted t width) (fit t width #:typeset? #t))

(define (formula->xexprs t)
  (define-values (for-wide for-narrow) (values (fitted t wide) (fitted t narrow)))
  (define (block tree class) `(div ([class ,class]) ,(raw (tree->MathML tree #t))))
  (if (equal? for-wide for-narrow)
      (list (block for-wide "formula"))
      (list (block for-wide "formula wide") (block for-narrow "formula narrow"))))

(define (report->xexpr t)
  `(div ([class ,(string-append "report" (report-class t))])
        ,@(for/list ([l (in-list (report-lines t))])
            `(p ([style ,(format "margin:0.15em 0 0.15em ~aem" (* 1.5 (report-line-depth l)))])
                (span ([class "label"]) ,(visible (report-line-label l)))
                ,@(append-map (lambda (part) (cons " " (inline-xexprs part)))
                              (report-line-parts l))))))

;; tree -> element: a formula within a line
(define inline-formula
  (make-parameter
   (lambda (t) `(span ([class "inline"]) ,(raw (tree->MathML (fitted t wide) #f))))))

;; Words stand in the font of the text, and so does a comma after a formula.
(define (inline-xexprs t)
  (cond [(word? t) (list (visible (word-text t)))]
        [(plain? t) (list `(code ,(visible (plain-text t))))]
        [(and (row? t) (ormap word? (row-items t))) (append-map inline-xexprs (row-items t))]
        [(report? t) (list (report->xexpr t))]
        [else (list ((inline-formula) t))]))

(define (report-class t)
  (define lines (report-lines t))
  (if (null? lines) "" (verdict-class (report-line-label (car lines)))))

(define (verdict-class text)
  (define m (regexp-match #px"^(proved|refuted|undecided)\\b" text))
  (if m (string-append " " (cadr m)) ""))

;; ---------------------------------------------------------------------------
;; Pictures

;; An SVG of more bytes is replaced by its PNG, which is drawn only then.
(define largest-svg 1000000)

(define (picture->markup p number)
  (define svg (shown-picture-svg p))
  (define small? (and svg (< (bytes-length svg) largest-svg)))
  (define png (and (not small?) (shown-picture-png p)))
  (if png
      (format "<img alt=\"\" src=\"~a\"/>" (png->URL png))
      (svg->markup (bytes->string/utf-8 svg #\?) (format "\\1p~a-" number))))

;; A picture as an address that holds it
(define (png->URL png) (format "data:image/png;base64,~a" (base64-encode png #"")))

(define (svg->markup text prefixed)
  (regexp-replaces text `([#rx"^.*?(?=<svg)" ""]
                          [#rx"( id=\")" ,prefixed] [#rx"(href=\"#)" ,prefixed]
                          [#rx"(url[(]#)" ,prefixed]
                          [#px"^<svg[^>]*>" ,in-pixels])))

;; Points would be a third larger than the size that was asked for.
(define (in-pixels tag)
  (regexp-replace* #px" (width|height)=\"([\\d.]+)pt\"" tag " \\1=\"\\2\""))

;; ---------------------------------------------------------------------------
;; Tables

(define (table->xexpr s)
  `(div ([class "table"])
        (table
         ,@(if (shown-table-header s)
               `((thead (tr ,@(for/list ([h (in-list (shown-table-header s))]) `(th ,h)))))
               '())
         (tbody
          ,@(for/list ([row (in-list (shown-table-rows s))])
              `(tr ,@(for/list ([t (in-list row)]) `(td ,@(inline-xexprs t)))))))))
