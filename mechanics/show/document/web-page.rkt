#lang racket/base
;; A document as one page of HTML, which asks the network for nothing and needs no script; one
;; moves through the frames of interactions (interaction-page.rkt).
;; Formulas are MathML; a subset of a font with a MATH table is part of the page, without which
;; brackets and roots would not stretch in most browsers (font/README.md).
;;
;; The page is built as XML throughout, so that names and strings are always text.

(require net/base64
         racket/file
         racket/list
         racket/runtime-path
         "coloring.rkt" "document-piece.rkt" "interaction-page.rkt" "page-value.rkt"
         "shown-interaction.rkt"
         (only-in "../../algebra/notation/tree.rkt" dotted name))

(provide document->page page)

(define-runtime-path style-sheet "web-page.css")
(define-runtime-path math-font "font/math.woff2")

;; room : how many bytes the frames of all interactions may take -> string
(define (document->page d #:room [room 5000000])
  (define language (document-language d))
  (define interactions (count interaction-piece? (document-pieces d)))
  (page (document-title d) (pieces->body (document-pieces d) (quotient room (max 1 interactions)))
        #:moving? (> interactions 0)
        #:footer (and language (format "A program in ~a, and its results." language))))

;; body : list of xexprs, in which text is visible (page-value.rkt); footer : text or #f;
;; style : rules beyond those of every page; moving? : are there interactions?
(define (page title body #:footer [footer #f] #:style [style ""] #:moving? [moving? #f])
  (string-append "<!DOCTYPE html>\n" (markup (page-xexpr title body footer style moving?)) "\n"))

(define (page-xexpr title body footer style moving?)
  `(html ([xmlns "http://www.w3.org/1999/xhtml"] [lang "en"])
    (head
     (meta ([charset "utf-8"]))
     (meta ([name "viewport"] [content "width=device-width, initial-scale=1"]))
     (meta ([name "color-scheme"] [content "light dark"]))
     (meta ([http-equiv "Content-Security-Policy"]
            [content ,(string-append policy (if moving? (interaction-policy) ""))]))
     (title ,(visible title))
     (style ,(raw (string-append (font-rule) (file->string style-sheet) style))))
    (body
     (main (h1 ,(visible title)) ,@body)
     ,@(if footer `((footer ,(visible footer))) '())
     ,@(if moving? `((script ,(raw (interaction-script)))) '()))))

;; Nothing is fetched and nothing is run, even if another script got into the page.
(define policy
  "default-src 'none'; style-src 'unsafe-inline'; font-src data:; img-src data:")

(define (font-rule)
  (format "@font-face{font-family:\"Mechanics Math\";src:url(data:font/woff2;base64,~a) ~a}\n"
          (base64-encode (file->bytes math-font) #"") "format(\"woff2\")"))

;; ---------------------------------------------------------------------------
;; Pieces

(define (interaction-piece? p) (and (result? p) (shown-interaction? (result-shown p))))

;; Pictures are numbered from 0.  room : for the frames of each interaction
(define (pieces->body pieces room)
  (define pictures 0)
  (define (next-number) (begin0 pictures (set! pictures (+ pictures 1))))
  (for/list ([p (in-list pieces)])
    (if (interaction-piece? p)
        (interaction->xexpr (result-shown p) next-number room)
        (piece->xexpr p next-number))))

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

;; A line that is broken goes on beneath, `--hang` from the left.
(define (code->xexpr text)
  `(pre ([class "code"]) (code ,@(map line->xexpr (colored-lines text)))))

(define (line->xexpr parts)
  (define indentation (string-length (car (regexp-match #rx"^ *" (cdr (car parts))))))
  `(span ([class "line"] [style ,(format "--hang:~ach" (min (+ indentation 4) deepest-hang))])
         ,@(for/list ([part (in-list parts)])
             (if (car part)
                 `(span ([class ,(symbol->string (car part))]) ,(visible (cdr part)))
                 (visible (cdr part))))))

(define deepest-hang 12)
