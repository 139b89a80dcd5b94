#lang racket/base
;; The pages of the guide as notebooks: prose as Markdown, examples as cells with code.

(require racket/class
         racket/list
         racket/port
         racket/string
         scribble/base-render
         scribble/core
         (prefix-in markdown: scribble/markdown-render)
         "example-cells.rkt"
         (only-in "../../mechanics/lang/help/page.rkt"
                  manual-pages page-sections section-tag section-heading)
         "../../mechanics/show/notebook/program-cells.rkt")

(provide guide-pages (struct-out guide-page))

;; name : of its file, without extension; title : text
;; cells : of its notebook; failing : those of them whose form is to fail
(struct guide-page (name title cells failing))

;; guide : path of guide.scrbl -> guide-pages
(define (guide-pages guide)
  (define doc (parameterize ([examples-as-cells? #t]) (dynamic-require guide 'doc)))
  (define pages (part-parts doc))
  (define renderer (new (page-mixin (markdown:render-mixin render%))
                        [dest-dir (find-system-path 'temp-dir)]
                        [names (page-names pages)] [titles (section-titles guide)]))
  (define files (list "guide.md"))
  (define traversed (send renderer traverse (list doc) files))
  (define collected (send renderer collect (list doc) files traversed))
  (define resolved (send renderer resolve (list doc) files collected))
  (for/list ([page (in-list pages)]) (page->notebook page renderer resolved)))

;; -> hash from tags of pages to names
(define (page-names pages)
  (for*/hash ([p (in-list pages)] [t (in-list (part-tags p))]) (values (tag-text t) (part-name p))))

;; guide : path -> hash from tags of sections of the whole manual to their titles
(define (section-titles guide)
  (define manual (simplify-path (build-path guide 'up "mechanics.scrbl")))
  (for*/hash ([p (in-list (manual-pages manual))]
              [s (in-list (page-sections p))] #:when (section-tag s))
    (values (section-tag s) (section-heading s))))

(define (part-name p) (tag-text (car (part-tags p))))
(define (tag-text t) (format "~a" (let ([x (cadr t)]) (if (pair? x) (last x) x))))

;; ---------------------------------------------------------------------------
;; Markdown

;; Where cells stand, a line with a mark and their number
(define mark "\u0001")

(define (page-mixin %)
  (class %
    (init-field names titles)
    (define found '())               ; example-cells, the latest first
    (define/public (take-cells) (begin0 (reverse found) (set! found '())))

    (define/override (render-block b part ri starting?)
      (define cells (block-cells b))
      (cond [cells
             (printf "~a~a~a\n" mark (length found) mark)
             (set! found (cons cells found))
             null]
            [else (super render-block b part ri starting?)]))

    ;; Links to other pages lead to their notebooks; of the reference they give titles.
    (define/override (render-content c part ri)
      (define tag (and (link-element? c) (tag-text (link-element-tag c))))
      (define name (hash-ref names tag #f))
      (define title (and (not name) (hash-ref titles tag #f)))
      (if title
          (begin (printf "*~a* (in the manual)" title) null)
          (render-linked c part ri name)))

    (define/private (render-linked c part ri name)
      (define raised (and (element? c) (assq (element-style c) '((superscript . "sup")
                                                                 (subscript . "sub")))))
      (display (cond [name "["] [raised (format "<~a>" (cdr raised))] [else ""]))
      (begin0 (super render-content c part ri)
              (display (cond [name (format "](~a.ipynb)" name)]
                             [raised (format "</~a>" (cdr raised))]
                             [else ""]))))

    ;; A table has no form in Markdown that all of its contents would fit: it stays as it is set.
    (define/override (render-table t part ri inline?)
      (define text (with-output-to-string (lambda () (super render-table t part ri inline?))))
      (display (if (regexp-match? #rx"^```" text) text (set-text text)))
      null)

    (define/override (render-other x part ri)
      (if (string? x)
          (super render-other (regexp-replace* #rx"[$<]" x "\\\\&") part ri)
          (if (symbol? x) (super render-other x part ri) null)))

    (super-new)))

;; Lines as they are, without the signs that Markdown needs elsewhere
(define (set-text text)
  (define lines (regexp-split #rx"\n" (regexp-replace* #rx"\\\\([][#_*`$<])|`" text "\\1")))
  (string-join (for/list ([l (in-list lines)]) (string-append "    " l)) "\n" #:after-last "\n"))

;; ---------------------------------------------------------------------------
;; Cells

(define (page->notebook page renderer ri)
  (define text
    (with-output-to-string (lambda () (send renderer render-part page ri))))
  (define examples (send renderer take-cells))
  (define-values (cells failing)
    (for/fold ([cells '()] [failing '()] #:result (values (reverse cells) failing))
              ([piece (in-list (regexp-split #rx"\u0001" text))] [k (in-naturals)])
      (cond [(odd? k)
             (define new (examples->cells (list-ref examples (string->number piece)) examples))
             (values (append (reverse (map car new)) cells)
                     (append (map car (filter cdr new)) failing))]
            [(string=? "" (string-trim piece)) (values cells failing)]
            [else (values (cons (cell 'markdown (prose piece) #f #f) cells) failing)])))
  (guide-page (part-name page) (content->string (or (part-title-content page) '("")))
              cells failing))

;; Headings without their numbers, which are those of the guide
(define (prose text) (regexp-replace* #px"(?m:^#(#+) (?:\\d+[.])* ?)" (string-trim text) "\\1 "))

;; -> pairs of a cell and whether it fails.  The first examples of a session stand behind what the
;; session begins with.
(define (examples->cells e all)
  (define session (example-cells-session e))
  (define forms (cell-session-forms session))
  (define first? (eq? e (findf (lambda (x) (eq? session (example-cells-session x))) all)))
  (cond [(not forms)
         (define lines (string-join (map car (example-cells-forms e)) "\n"))
         (list (cons (cell 'markdown (format "```racket\n~a\n```" lines) #f #f) #f))]
        [else
         (append (if (and first? (pair? forms)) (list (cons (code-cell (map ~form forms)) #f)) '())
                 (for/list ([group (in-list (grouped (example-cells-forms e)))])
                   (cons (code-cell (map car group)) (ormap cdr group))))]))

(define (~form form) (format "~s" form))
(define (code-cell texts) (cell 'code (string-join texts "\n") #f #f))

;; Definitions stand with the expression behind them; what fails stands alone.
(define (grouped forms)
  (let loop ([forms forms] [group '()])
    (define (close rest) (if (null? group) rest (cons (reverse group) rest)))
    (cond [(null? forms) (close '())]
          [(cdar forms) (close (cons (list (car forms)) (loop (cdr forms) '())))]
          [(regexp-match? #px"^\\((?:define|require|assume)" (caar forms))
           (loop (cdr forms) (cons (car forms) group))]
          [else (cons (reverse (cons (car forms) group)) (loop (cdr forms) '()))])))
