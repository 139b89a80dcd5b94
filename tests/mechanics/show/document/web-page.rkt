#lang racket/base
;; Documents as pages: well-formed, with nothing in them that could be markup of its own.

(require file/convertible
         racket/list
         racket/string
         (only-in xml document-element read-xml xml->xexpr)
         mechanics mechanics/plot
         (prefix-in t: "../../../../mechanics/algebra/notation/tree.rkt")
         "../../support/checks.rkt" "../../../../mechanics/show/document/coloring.rkt"
         "../../../../mechanics/show/document/line-markup.rkt"
         (rename-in "../../../../mechanics/show/document/web-page.rkt" [page markup-page])
         "../../../../mechanics/show/document/document-piece.rkt"
         "../../../../mechanics/show/document/shown-result.rkt"
         (only-in "../../../../mechanics/show/plot/on-demand.rkt" can-draw?)
         "../../support/skip.rkt")

(define (page . pieces) (document->page (document "A title" "#lang mechanics" pieces)))
(define (shown . values) (apply page (map (lambda (x) (result (value->shown x))) values)))

;; The page as an X-expression; fails if it is not well-formed.
(define (parsed text)
  (xml->xexpr
   (document-element
    (read-xml (open-input-string (string-replace text "<!DOCTYPE html>" ""))))))

;; All elements of that name.
(define (elements name x)
  (cond [(and (pair? x) (list? x))
         (append (if (eq? (car x) name) (list x) '())
                 (append-map (lambda (y) (elements name y)) (cdr x)))]
        [else '()]))

(define (text-in x)
  (cond [(string? x) x]
        [(symbol? x) ""]
        [(pair? x)
         (string-append* (for/list ([y (in-list (cddr x))] #:when (or (string? y) (element? y)))
                           (text-in y)))]
        [else ""]))
(define (element? y) (and (pair? y) (symbol? (car y))))

(define evil "</mi><script>alert(1)</script>&<!--")
(define evil-symbol (string->symbol evil))

(test-case "no name, string, comment, output or message breaks out of the page"
  (define p
    (parsed
     (page (prose (list (list evil (string-append evil "θ\u307")))) (heading evil) (code evil 0)
           (folded evil evil) (output evil) (failure evil)
           (result (value->shown evil-symbol))
           (result (value->shown (* 2 evil-symbol)))
           (result (value->shown ((literal-function evil-symbol) evil-symbol)))
           (result (value->shown evil))
           (result (value->shown (list evil (sqrt evil-symbol))))
           (result (value->shown (verify-equal evil-symbol 'x)))
           (result (shown-table
                    (list "a")
                    (list (list (shown-formula-tree (value->shown (* 2 evil-symbol))))))))))
  (check-equal? (elements 'script p) '())
  (check-true (> (length (elements 'math p)) 3)))

(test-case "characters that XML has no place for are replaced"
  (check-not-exn (lambda () (parsed (page (output "a\u0\u1\uFFFE") (code "\u0" 0)))))
  (check-not-exn (lambda () (parsed (shown (string->symbol "a\u0") "\u1")))))

(test-case "the page asks for nothing, runs nothing, and says so"
  (define text (shown (* 'a 'b) (sqrt 'x)))
  (check-false (regexp-match? #rx"<script|<link|src=\"http|@import" text))
  (check-false (regexp-match? #rx"url[(](?!data:|#)" text))
  (for ([part '("default-src 'none'" "name=\"viewport\"" "prefers-color-scheme: dark" "@media print"
                "font/woff2;base64")])
    (check-true (string-contains? text part) part)))

(test-case "a page ends with the language of its program, if it is of one"
  (define (footers text) (map text-in (elements 'footer (parsed text))))
  (check-equal? (footers (page)) '("A program in #lang mechanics, and its results."))
  (check-equal? (footers (document->page (document "A title" #f '()))) '())
  (check-equal? (footers (apply markup-page (list "A title" '()))) '()))

(test-case "a long formula is there twice, a short one once"
  (define long (apply + (for/list ([i 12]) (* 'amplitude (sin (* i 'omega 't))))))
  (check-equal? (length (elements 'math (parsed (shown (* 'a 'b))))) 1)
  (check-equal? (length (elements 'math (parsed (shown long)))) 2))

(test-case "assumptions are told beneath, verdicts have their colour"
  (check-regexp-match #rx"assuming " (text-in (parsed (shown (sqrt (square 'x))))))
  (check-regexp-match #rx"class=\"[a-z]+ proved\"" (shown (verify-equal 'x 'x)))
  (check-regexp-match #rx"class=\"[a-z]+ refuted\"" (shown (verify-equal 'x 'y))))

(define a-report
  (t:report (list (t:report-line 0 "refuted: the residual is not zero" '())
                  (t:report-line 1 "zero if:" (list (t:relation (t:name 'k) "=" (t:name 'theta_1))))
                  (t:report-line 2 "at:" (list (t:row (list (t:name 'a) (t:word ",")))
                                               (t:plain "<b>"))))))

(test-case "a report is text with formulas in it, indented as it is"
  (define r (parsed (page (result (shown-formula a-report '())))))
  (define lines (filter (lambda (p) (assq 'style (cadr p))) (elements 'p r)))
  (check-equal? (map (lambda (p) (cadr (assq 'style (cadr p)))) lines)
                '("margin:0.15em 0 0.15em 0em" "margin:0.15em 0 0.15em 1.5em"
                  "margin:0.15em 0 0.15em 3.0em"))
  (check-equal? (map (lambda (p) (length (elements 'math p))) lines) '(0 1 1))
  (check-equal? (text-in (third lines)) "at: a, <b>")
  (check-equal? (map text-in (elements 'math (third lines))) '("a"))
  (define nested (t:report (list (t:report-line 0 "why:" (list a-report)))))
  (check-equal? (length (elements 'p (parsed (page (result (shown-formula nested '())))))) 4)
  (check-equal? (length (elements 'math (parsed (page (result (shown-formula
                                                               (t:listing (list a-report a-report))
                                                               '()))))))
                4))

(test-case "what a result is shown as"
  (define (kind x)
    (define s (value->shown x))
    (cond [(shown-formula? s) 'formula] [(shown-table? s) 'table]
          [(shown-picture? s) 'picture] [else (shown-text-text s)]))
  (for ([x (list (* 'a 'b) 1/2 'theta_1 (up 'a 1) (matrix-by-rows (list 'a))
                 (list 'a (sqrt 'b)) D)])
    (check-equal? (kind x) 'formula (format "~s" x)))
  (for ([(x text) (hash "text" "\"text\"" 'proved "proved" #t "#t" '(a b) "'(a b)"
                        '(= k 3) "'(= k 3)" '() "'()")])
    (check-equal? (kind x) text))
  (check-equal? (kind (list (list 1 2) (list 3 4))) 'table)
  (check-equal? (kind (list (up 0 1.5) (up 1 2.5) (up 2 4))) 'table)
  (check-equal? (kind (list (list 1 2) (list 3))) "'((1 2) (3))")
  (define cycle (make-vector 1 0))
  (vector-set! cycle 0 cycle)
  (check-pred string? (kind cycle)))

(test-case "events are a table"
  (define motion
    (evolve-trajectory (lambda (s) (up 1 (velocity s) 0.)) (up 0. -1. 1.) 2.
                       #:events (list (event coordinate #:name 'passes)
                                      (event (lambda (s) (- (coordinate s) 0.5)) #:name 'half))))
  (define s (value->shown (trajectory-events motion)))
  (check-equal? (shown-table-header s) '("event" "time" "state"))
  (check-equal? (length (shown-table-rows s)) 2)
  (define texts (map text-in (elements 'td (parsed (page (result s))))))
  (check-equal? (list (first texts) (fourth texts)) '("passes" "half")))

(test-case "colors leave the text as it is"
  (for ([text '("(define (f x) ; é\n  (* 1/2 \"s\" #;(a) 'x #| b |# |c d|))"
                "" "(" "#lang x" "\"open")])
    (check-equal? (string-append* (map cdr (colored text))) text))
  (check-not-false (member '(form . "define") (colored "(define x 1)")))
  (check-not-false (member '(constant . "1.5") (colored "(f 1.5)")))
  (check-false (assq 'form (colored "(f define)"))))

(test-case "lines of a program stand by themselves, and hang by where they begin"
  (check-equal? (colored-lines "(define x\n\n  1)")
                '(((#f . "(") (form . "define") (#f . " x\n")) ((#f . "\n"))
                  ((#f . "  ") (constant . "1") (#f . ")"))))
  (define long (string-append "(a\n  b\n" (make-string 30 #\space) "c)"))
  (define lines
    (filter (lambda (x) (assq 'style (cadr x))) (elements 'span (parsed (page (code long 0))))))
  (check-equal? (map (lambda (x) (cadr (assq 'style (cadr x)))) lines)
                '("--hang:4ch" "--hang:6ch" "--hang:12ch"))
  (check-equal? (string-append* (map text-in lines)) long))

(test-case "markup for a line has no blocks, and texts and numbers have none"
  (check-equal? (value->line-markup 75) #f)
  (check-equal? (value->line-markup "a") #f)
  (define m (value->line-markup (verify-equal (* 'a 'b) 'c)))
  (for ([m (filter values (list m (value->line-markup (* 'a 'b))))])
    (check-false (regexp-match? #rx"<(div|p|pre)[ >]" m))))

(test-case "pictures are in place, each with names of its own"
  (skip-unless (can-draw?) "pictures on pages: the libraries that draw are not here"
    (define (picture)
      (define f (frame 0 1 0 1 #:title "x"))
      (plot-line f 0 0 1 1)
      f)
    (define text (shown (picture) (picture)))
    (define ids (regexp-match* #rx" id=\"([^\"]*)\"" text #:match-select cadr))
    (check-true (> (length ids) 2))
    (check-equal? (length ids) (length (remove-duplicates ids)))
    (define used
      (regexp-match* #rx"(?:href=\"#|url[(]#)([^\")]*)" text #:match-select cadr))
    (check-equal? (remove* ids (remove-duplicates used)) '())
    (check-equal? (length (elements 'svg (parsed text))) 2)))

(test-case "a frame is shown as it was when it came"
  (skip-unless (can-draw?) "pictures on pages: the libraries that draw are not here"
    (define f (frame 0 1 0 1))
    (define before (value->shown f))
    (define-values (svg png) (values (convert f 'svg-bytes) (convert f 'png-bytes)))
    (plot-line f 0 0 1 1)
    (check-equal? (shown-picture-svg before) svg)
    (check-equal? (shown-picture-png before) png)
    (check-not-equal? svg (shown-picture-svg (value->shown f)))))

(test-case "a picture is drawn in the formats that are asked for, once in each"
  (define asked '())
  (struct drawing ()
    #:property prop:convertible
    (lambda (d format default)
      (set! asked (cons format asked))
      (case format [(svg-bytes) #"<svg/>"] [(png-bytes) #"PNG"] [else default])))
  (define shown (value->shown (drawing)))
  (check-equal? (filter (lambda (format) (memq format '(png-bytes pdf-bytes))) asked) '())
  (for ([_ 2])
    (check-equal? (shown-picture-svg shown) #"<svg/>")
    (check-equal? (shown-picture-png shown) #"PNG")
    (check-false (shown-picture-pdf shown)))
  (check-equal? (sort (remq* '(picture-for-later text) asked) symbol<?)
                '(pdf-bytes png-bytes svg-bytes)))
