#lang racket/base
;; A document as one page of HTML, which asks the network for nothing and needs no script.
;; Formulas are MathML; a subset of a font with a MATH table is part of the page, without which
;; brackets and roots would not stretch in most browsers (font/README.md).
;;
;; The page is built as XML throughout, so that names and strings are always text.

(require net/base64
         racket/file
         racket/list
         racket/runtime-path
         (only-in xml empty-tag-shorthand html-empty-tags write-xexpr)
         "coloring.rkt" "page-value.rkt" "document-piece.rkt"
         (only-in "../../algebra/notation/tree.rkt" dotted name))

(provide document->page page)

(define-runtime-path style-sheet "web-page.css")
(define-runtime-path math-font "font/math.woff2")

;; -> string
(define (document->page d)
  (define language (document-language d))
  (page (document-title d) (pieces->body (document-pieces d))
        #:footer (and language (format "A program in ~a, and its results." language))))

;; body : list of xexprs, in which text is visible (page-value.rkt); footer : text or #f;
;; style : rules beyond those of every page
(define (page title body #:footer [footer #f] #:style [style ""])
  (string-append "<!DOCTYPE html>\n" (markup (page-xexpr title body footer style)) "\n"))

(define (markup x)
  (define port (open-output-string))
  (parameterize ([empty-tag-shorthand html-empty-tags]) (write-xexpr x port))
  (get-output-string port))

(define (page-xexpr title body footer style)
  `(html ([xmlns "http://www.w3.org/1999/xhtml"] [lang "en"])
    (head
     (meta ([charset "utf-8"]))
     (meta ([name "viewport"] [content "width=device-width, initial-scale=1"]))
     (meta ([name "color-scheme"] [content "light dark"]))
     (meta ([http-equiv "Content-Security-Policy"] [content ,policy]))
     (title ,(visible title))
     (style ,(raw (string-append (font-rule) (file->string style-sheet) style))))
    (body
     (main (h1 ,(visible title)) ,@body)
     ,@(if footer `((footer ,(visible footer))) '()))))

;; Nothing is fetched and nothing is run, even if a script got into the page.
(define policy
  "default-src 'none'; style-src 'unsafe-inline'; font-src data:; img-src data:")

(define (font-rule)
  (format "@font-face{font-family:\"Mechanics Math\";src:url(data:font/woff2;base64,~a) ~a}\n"
          (base64-encode (file->bytes math-font) #"") "format(\"woff2\")"))

;; ---------------------------------------------------------------------------
;; Pieces

;; Pictures are numbered from 0.
(define (pieces->body pieces)
  (define pictures 0)
  (define (next-number) (begin0 pictures (set! pictures (+ pictures 1))))
  (for/list ([p (in-list pieces)]) (piece->xexpr p next-number)))

(define (piece->xexpr p number)
  (cond [(heading? p) `(h2 ,(visible (heading-text p)))]
        [(prose? p) `(div ([class "prose"]) ,@(map paragraph->xexpr (prose-paragraphs p)))]
        [(code? p) (code->xexpr (code-text p))]
        [(folded? p)
         `(details (summary ,(visible (folded-label p))) ,(code->xexpr (folded-text p)))]
        [(output? p) `(pre ([class "output"]) ,(visible (output-text p)))]
        [(failure? p) `(pre ([class "failure"] [role "alert"]) ,(visible (failure-text p)))]
        [else `(div ([class "result"]) ,@(shown->xexprs (result-shown p) number))]))

(define (paragraph->xexpr lines)
  `(p ,@(append* (add-between (map words->xexprs lines) '((br))))))

;; Few fonts have a letter with the dot of a time derivative; formulas do.
(define (words->xexprs text)
  (define dotted-letter #px"\\p{L}[\u307\u308\u20DB]")
  (define texts (map visible (regexp-split dotted-letter text)))
  (define letters
    (for/list ([found (in-list (regexp-match* dotted-letter text))])
      (define dots (cdr (assv (string-ref found 1) '((#\u307 . 1) (#\u308 . 2) (#\u20DB . 3)))))
      (car (inline-xexprs (dotted (name (string->symbol (substring found 0 1))) dots)))))
  (cons (car texts) (append-map list letters (cdr texts))))

(define (code->xexpr text)
  `(pre ([class "code"])
        (code ,@(for/list ([part (in-list (colored text))])
                  (if (car part)
                      `(span ([class ,(symbol->string (car part))]) ,(visible (cdr part)))
                      (visible (cdr part)))))))
