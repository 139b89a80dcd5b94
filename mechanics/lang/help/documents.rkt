#lang racket/base
;; All that the search can find, with its texts: names, pages of the manual and their sections,
;; libraries, programs and the exercises of the book.  Read while the table is made.

(require racket/file
         racket/list
         racket/path
         racket/string
         "card.rkt" "exercise-without-program.rkt" "finding.rkt" "page.rkt" "program-heading.rkt"
         "prose.rkt" "words.rkt")

(provide (struct-out document)
         documents)

;; fields : ((weight . text) ...), a word counting as its best field
;; prior : what is added whatever is looked for
(struct document (finding fields prior))

;; Weights of a word, by where it stands.  That of a title is divided among its words.
(define in-number 36)          ; 1.29 of exercise 1.29
(define in-section-number 24)
(define in-title 30)
(define in-lesser-title 20)    ; of what is rarely meant
(define in-heading 9)
(define in-sentence 8)
(define in-page-title 12)
(define in-text 2)

;; pages : of the manual; cards : of its names; folder : of the programs
;; -> documents, those of one kind together
(define (documents pages cards folder)
  (define programs (program-files folder))
  (define used (uses pages (map (lambda (p) (build-path folder p)) programs)))
  (append (append-map page-documents pages)
          (name-documents pages cards used)
          (map (lambda (p) (program-document folder p)) programs)
          (map missing-exercise exercises-without-program)))

;; ---------------------------------------------------------------------------
;; Names

;; The more pages and programs use a name, the likelier it is what is looked for.
(define (name-documents pages cards used)
  (define bodies
    (for*/fold ([texts (hash)]) ([p (in-list pages)] [e (in-list (page-entries p))]
                                 [name (in-list (remove-duplicates (map car (entry-names e))))])
      (hash-update texts name (lambda (t) (string-append t " " (distinct-words (entry-body e)))) "")))
  (for/list ([c (in-list cards)])
    (define name (symbol->string (card-name c)))
    (document (finding 'name name (symbol->string (card-library c)) "")
              (list (title-field name (title-weight c))
                    (about-its-page c)
                    (cons in-sentence (or (card-sentence c) ""))
                    (cons in-page-title (card-page c))
                    (cons in-text (hash-ref bodies (card-name c) "")))
              (+ (if (eq? (card-library c) 'mechanics) 10 0)
                 (bonus-of-uses (hash-ref used name 0))))))

;; golden-section-min is no section of a motion; Poincare-map, on the page of maps, is a map.
(define (about-its-page c)
  (define field (title-field (symbol->string (card-name c)) (title-weight c)))
  (define topic (words-of (card-page c)))
  (cons (+ in-page-title (car field))
        (string-join (filter (lambda (w) (member w topic)) (telling-words (cdr field))))))

;; Names that draw are usual words of mechanics, and predicates are called by programs.
(define (title-weight c)
  (cond [(not (memq (card-library c) '(mechanics mechanics/book mechanics/plot))) in-lesser-title]
        [(regexp-match? #rx"[?]$" (symbol->string (card-name c))) in-lesser-title]
        [else in-title]))

(define (bonus-of-uses n) (exact-round (* 3 (/ (log (add1 n)) (log 2)))))
(define (exact-round x) (inexact->exact (round x)))

;; name -> the number of sections and programs that use it
(define (uses pages programs)
  (define in-pages
    (for*/list ([p (in-list pages)] [s (in-list (page-sections p))])
      (map (lambda (x) (format "~a" x)) (flatten (section-parts s)))))
  (define in-programs
    (for/list ([file (in-list programs)]) (string-split (file->string file) #px"[][()\\s'`,]+")))
  (for*/fold ([counts (hash)]) ([names (in-list (append in-pages in-programs))]
                                [name (in-list (remove-duplicates names))])
    (hash-update counts name add1 0)))

;; ---------------------------------------------------------------------------
;; Pages

(define (page-documents p)
  (define sections (page-sections p))
  (define file (or (section-tag (car sections)) "index"))
  (define guide? (guide-page? p))
  (cons (page-document p file (car sections) (cdr sections) guide?)
        (append (for/list ([s (in-list (cdr sections))])
                  (section-document p file s guide?))
                (libraries file (car sections)))))

(define (guide-page? p)
  (regexp-match? #rx"guide" (path->string (page-file p))))

(define (page-document p file head sections guide?)
  (document (finding 'page (page-title p) file (opening head))
            (append (heading-fields (page-title p) guide?)
                    (list (cons in-heading (string-join (map section-heading sections)))
                          (cons in-sentence (opening head))
                          (cons in-text (all-text head))
                          (cons in-text (string-join (map all-text sections)))))
            (if guide? 40 0)))

(define (section-document p file s guide?)
  (document (finding 'section (section-heading s)
                     (string-append file "#" (or (section-tag s) (made-tag (section-heading s))))
                     (page-title p))
            (append (heading-fields (section-heading s) guide?)
                    (list (cons in-page-title (page-title p))
                          (cons in-sentence (opening s))
                          (cons in-text (all-text s))))
            (if guide? 32 0)))

;; As Scribble makes it.
(define (made-tag heading) (regexp-replace* #rx"[^-a-zA-Z0-9_=]" heading "_"))

;; "Along with chapter 4 of the book", "3.2 Poisson brackets", "2.3 to 2.6 Moments of inertia"
(define (heading-fields heading guide?)
  (define weight (if guide? in-title in-lesser-title))
  (define chapter (regexp-match #rx"chapter ([0-9])" heading))
  (define section (regexp-match #px"^(\\d[.]\\d+)(?: (?:to|and) (\\d[.]\\d+))?(.*)$" heading))
  (cond [section (list (title-field (fourth section) weight)
                       (cons in-section-number (format "~a ~a" (second section) (or (third section) "")))
                       (cons in-title "section"))]
        [chapter (list (title-field heading weight)
                       (cons in-number (format "chapter ~a" (second chapter))))]
        [else (list (title-field heading weight))]))

(define (libraries file head)
  (for/list ([part (in-list (section-parts head))]
             #:when (and (pair? part) (eq? (car part) 'defmodule)))
    (define name (symbol->string (cadr part)))
    (document (finding 'library name file "") (list (title-field name)) 0)))

;; The first sentence, or "".
(define (opening s)
  (or (first-sentence (filter text? (section-parts s))) ""))

(define (text? part)
  (not (and (pair? part) (memq (car part) '(require define defmodule declare-exporting include-section)))))

;; All strings, however deep, and names in code.
(define (all-text s)
  (string-join
   (for/list ([x (in-list (flatten (filter text? (section-parts s))))] #:when (or (string? x) (symbol? x)))
     (if (symbol? x) (symbol->string x) x))))

;; ---------------------------------------------------------------------------
;; Programs

(define (program-files folder)
  (for/list ([file (in-list (find-files (lambda (p) (path-has-extension? p #".rkt")) folder))]
             #:unless (member (path->string (file-name-from-path file)) no-programs))
    (path->string (find-relative-path (simple-form-path folder) (simple-form-path file)))))

(define no-programs '("info.rkt" "save.rkt" "screens.rkt"))

(define (program-document folder name)
  (define file (build-path folder name))
  (define heading (program-heading file))
  (define exercise (regexp-match #px"^Exercise (\\d+[.]\\d+) [^:]*: (.*?)(?: Checked: .*)?$" heading))
  (define figure (regexp-match #px"figure-(\\d)-(\\d+)[.]rkt$" name))
  (define title (cond [exercise (format "Exercise ~a" (second exercise))]
                      [figure (format "Figure ~a.~a" (second figure) (third figure))]
                      [else (titled name)]))
  (define subject (cond [exercise (third exercise)]
                        [else (regexp-replace #px" *[(]SICM [^)]*[)]" heading "")]))
  (define weight (if (or figure (regexp-match? #rx"^(figures|worksheets)/" name))
                     in-lesser-title
                     in-title))
  (document (finding (if exercise 'exercise 'program) title name (ending-in-stop subject))
            (list (if (or exercise figure) (cons in-number title) (title-field title weight))
                  (title-field subject weight)
                  (cons in-heading (string-join (opening-comment file)))
                  (cons in-heading (numbered-equations (file->string file)))
                  (cons in-text (string-join (comments file))))
            (cond [exercise 8] [figure 0] [(regexp-match? #rx"^animations|worksheets" name) 4]
                  [else 10])))

;; "constraints/sliding-ladder.rkt" -> "sliding ladder"
(define (titled name)
  (string-replace (regexp-replace #rx"^.*/|[.]rkt$" (regexp-replace #rx"[.]rkt$" name "") "")
                  "-" " "))

(define (ending-in-stop text)
  (regexp-replace #rx"[.]? *$" text "."))

;; (7.88) -> "equation 7.88"
(define (numbered-equations text)
  (define found (regexp-match* #px"[(](\\d[.]\\d+)(?:, (\\d[.]\\d+))*[)]" text))
  (if (null? found) "" (string-join (cons "equation" found))))

(define (comments file)
  (for/list ([l (in-list (file->lines file))] #:when (regexp-match? #px"^;; " l)) l))

(define (missing-exercise e)
  (define number (car e))
  (document (finding 'page (format "Exercise ~a" number) (cadr e) (caddr e))
            (list (cons in-number (format "exercise ~a" number)) (cons in-text (caddr e)))
            8))

;; ---------------------------------------------------------------------------

;; A title of few words is about each of them.
(define (title-field text [weight in-title])
  (cons (/ weight (expt (max 1 (length (telling-words text))) 0.45)) text))
