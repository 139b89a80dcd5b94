#lang racket/base
;; Results as a front end takes them: a hash from MIME types to texts, of which it shows the richest
;; that it knows.
;;
;; A formula is TeX, and the expression that `read-expression` takes; a report and a table are
;; elements of a page without scripts, with formulas in TeX; a picture SVG and PNG.

(require file/convertible
         net/base64
         (only-in racket/string string-join)
         (only-in xml xexpr->string)
         "../algebra/notation/tree.rkt"
         "../show/display/display-style.rkt" "../show/display/result.rkt"
         "../show/document/page-value.rkt" "../show/document/shown-result.rkt"
         "../show/typesetting/TeX.rkt" "../show/typesetting/break.rkt")

(provide value->bundle words->bundle)

;; formats : of a picture; columns : that fit into a cell
(define (value->bundle x [formats '(svg-bytes png-bytes)] #:columns [columns 80])
  (define see (seen-once))
  (define text (printed x columns see))
  (define s (if (eq? (display-style) 'automatic) (value->shown x see) (shown-text text)))
  (define page (and (shown-picture? s) (convert x 'html-bytes #f)))
  (for/fold ([bundle (hasheq (string->symbol "text/plain") text)])
            ([part (in-list (if page (list (page->part page s)) (shown->parts s columns formats)))])
    (hash-set bundle (string->symbol (car part)) (cdr part))))

;; The words of an error, in the place of a value
(define (words->bundle text)
  (define style "color: #b00020; white-space: pre-wrap")
  (hasheq (string->symbol "text/plain") text
          (string->symbol "text/html") (xexpr->string `(pre ([style ,style]) ,text))))

;; As a prompt prints it.
(define (printed x columns see)
  (define manner (if (eq? (display-style) 'automatic) 'expression (manner-here)))
  (format "~v" (simplified-result x columns manner see)))

;; -> list of pairs of MIME type and text
(define (shown->parts s columns formats)
  (cond [(shown-text? s) '()]
        [(shown-picture? s) (picture->parts s formats)]
        [(and (shown-formula? s) (not (holds-report? (shown-formula-tree s))))
         (list (cons "text/latex" (formula->TeX s columns)))]
        [else (list (cons "text/html" (shown->markup s)))]))

(define (holds-report? t)
  (or (report? t) (and (listing? t) (ormap report? (listing-items t)))))

(define (formula->TeX s columns)
  (string-join
   (cons (format "$\\displaystyle ~a$" (tree->TeX (fit (shown-formula-tree s) columns)))
         (for/list ([n (in-list (shown-formula-notes s))]) (format "$~a$" (tree->TeX n))))
   "\n\n"))

;; Where the picture cannot be drawn there is its text.
(define (picture->parts s formats)
  (define (part type format of-picture encode)
    (define bytes (and (memq format formats) (of-picture s)))
    (if bytes (list (cons type (encode bytes))) '()))
  (append (part "image/svg+xml" 'svg-bytes shown-picture-svg
                (lambda (b) (regexp-replace #rx"^.*?(?=<svg)" (bytes->string/utf-8 b #\?) "")))
          (part "image/png" 'png-bytes shown-picture-png
                (lambda (b) (bytes->string/latin-1 (base64-encode b #""))))))

;; An animation is a page in a frame that may do nothing but run its script.  Where frames are taken
;; out, as in a notebook that is not trusted, the picture in it is left.
(define (page->part page s)
  (define m (regexp-match #rx#"viewBox=\"0 0 [0-9.]+ ([0-9.]+)\"" page))
  (define height (+ 120 (if m (string->number (bytes->string/latin-1 (cadr m))) 360)))
  (cons "text/html"
        (xexpr->string
         `(iframe ([sandbox "allow-scripts"]
                   [style ,(format "width: 100%; height: ~apx; border: 0" height)]
                   [srcdoc ,(bytes->string/utf-8 page)])
                  (img ([alt ,(shown-picture-text s)]
                        [src ,(png->URL (or (shown-picture-png s) #""))]))))))

;; MathJax looks for TeX in the formulas alone, not in a program's output.
(define (shown->markup s)
  (define elements
    (parameterize ([inline-formula formula->xexpr])
      (shown->xexprs s (lambda () 0))))
  (xexpr->string `(div ([class "mechanics mathjax_ignore tex2jax_ignore"]) ,@elements)))

(define (formula->xexpr t)
  `(span ([class "mathjax_process tex2jax_process"])
         ,(format "\\(\\displaystyle ~a\\)" (tree->TeX (fit t 80)))))
