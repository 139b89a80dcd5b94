#lang racket/base
;; Pages of the manual, their sections, and the libraries that they describe, as the search can find
;; them.  Those of the guide come before those of the reference, whose names are found themselves.

(require racket/list
         racket/string
         "document.rkt" "finding.rkt" "page.rkt" "prose.rkt")

(provide page-documents)

(define prior-of-page 40)
(define prior-of-section 32)

(define (page-documents p)
  (define sections (page-sections p))
  (define tag (section-tag (car sections)))
  (define place (or tag "index"))
  (cons (page-document p (or tag (place-of-section place (car sections) (car sections)))
                       (car sections) (cdr sections))
        (append (for/list ([s (in-list (cdr sections))])
                  (section-document p s (place-of-section place (car sections) s)))
                (libraries place (car sections)))))

(define (page-document p place head sections)
  (document (finding 'page (page-title p) place (opening head))
            (append (heading-fields (page-title p) (guide? p))
                    (list (cons in-heading (string-join (map section-heading sections)))
                          (cons in-sentence (opening head))
                          (cons in-text (string-join (map all-text (cons head sections))))))
            (if (guide? p) prior-of-page 0)))

(define (section-document p s place)
  (document (finding 'section (section-heading s) place (page-title p))
            (append (heading-fields (section-heading s) (guide? p))
                    (list (cons in-page-title (page-title p))
                          (cons in-sentence (opening s))
                          (cons in-text (all-text s))))
            (if (guide? p) prior-of-section 0)))

(define (guide? p)
  (not (regexp-match? #rx"[/\\]mechanics[/\\]reference([/\\].*)?[.]scrbl$"
                      (path->string (page-file p)))))

;; A library of several pages is described on the one that declares it.
(define (libraries place head)
  (for/list ([part (in-list (section-parts head))]
             #:when (and (pair? part) (eq? (car part) 'defmodule)
                         (not (memq '#:no-declare part))))
    (define name (symbol->string (cadr part)))
    (document (finding 'library name place "") (list (title-field name)) 0)))

;; On the page, or a page of its own.
(define (place-of-section page head s)
  (define tag (or (section-tag s) (made-tag (section-heading s))))
  (if (section-own-pages? head) tag (string-append page "#" tag)))

;; As Scribble makes it.
(define (made-tag heading) (regexp-replace* #rx"[^-a-zA-Z0-9_=]" heading "_"))

;; ---------------------------------------------------------------------------
;; Headings, of which some name a place in the book: "Along with chapter 4 of the book",
;; "3.2 Poisson brackets", "2.3 to 2.6 Moments of inertia"

(define (heading-fields heading guide?)
  (define weight (if guide? in-title in-lesser-title))
  (define chapter (regexp-match #rx"chapter ([0-9])" heading))
  (define section (regexp-match #px"^(\\d[.]\\d+)(?: (?:to|and) (\\d[.]\\d+))?(.*)$" heading))
  (cond [section (list (title-field (fourth section) weight)
                       (cons in-section-number
                             (string-append (second section) " " (or (third section) "")))
                       (cons in-title "section"))]
        [chapter (list (title-field heading weight)
                       (cons in-number (string-append "chapter " (second chapter))))]
        [else (list (title-field heading weight))]))

;; ---------------------------------------------------------------------------
;; Texts

;; The first sentence, or "" where it names another page, whose title is not at hand.
(define (opening s)
  (define sentence (or (first-sentence (content s)) ""))
  (if (regexp-match? #rx" [.,;:)]" sentence) "" sentence))

;; All strings, however deep, but for those of examples; and names in code.
(define (all-text s) (string-join (texts (content s) #t)))

(define (texts x strings?)
  (cond [(symbol? x) (list (symbol->string x))]
        [(string? x) (if strings? (list x) '())]
        [(list? x)
         (define told? (and strings? (not (and (pair? x) (memq (car x) examples)))))
         (append-map (lambda (part) (texts part told?)) x)]
        [else '()]))

(define examples '(examples bigfloat-examples picture-examples))

(define (content s)
  (filter (lambda (part) (not (and (pair? part) (memq (car part) directions))))
          (section-parts s)))

(define directions
  '(require define defmodule declare-exporting include-section next-pages))
