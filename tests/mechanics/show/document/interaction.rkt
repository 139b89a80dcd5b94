#lang racket/base
;; Interactions in documents: frames computed beforehand, a page that moves through them by its own
;; script, and shows the first without one; LaTeX with the first.

(require json
         racket/file
         racket/list
         racket/string
         mechanics mechanics/plot
         "../../../../mechanics/show/document/TeX-document.rkt"
         "../../../../mechanics/show/document/document-piece.rkt"
         "../../../../mechanics/show/document/shown-result.rkt"
         "../../../../mechanics/show/document/web-page.rkt"
         (only-in "../../../../mechanics/show/plot/on-demand.rkt" can-draw?)
         "../../support/browser.rkt" "../../support/checks.rkt" "../../support/skip.rkt")

(define (document-of . shown) (document "A title" "#lang mechanics" (map result shown)))
(define (page-of . interactions)
  (document->page (apply document-of (map value->shown interactions))))

;; The data of the scripts of a page
(define (data-in page)
  (define data #rx"<script type=\"application/json\">(.*?)</script>")
  (map string->jsexpr (regexp-match* data page #:match-select cadr)))

(define (frame-count data) (length (hash-ref data 'frames)))
(define (frame-text data k)
  (string-append* (for/list ([e (in-list (list-ref (hash-ref data 'frames) k))])
                    (list-ref (hash-ref data 'elements) e))))

;; ---------------------------------------------------------------------------
;; Which frames there are

(test-case "an interaction has a frame for each combination, in order"
  (define data (car (data-in (page-of (interact ([k 1 6] [b #t]) (list "x" k b))))))
  (check-equal? (frame-count data) 12)
  (check-equal? (hash-ref data 'labels) '(("1" "2" "3" "4" "5" "6") ("#f" "#t")))
  (check-true (string-contains? (frame-text data 0) "#f"))
  (check-true (string-contains? (frame-text data 11) "6 #t")))

(test-case "at most sixty frames, and the page says which values are not there"
  (define page (page-of (interact ([a 0 1] [title "words"]) (* a 'x))))
  (check-equal? (frame-count (car (data-in page))) 51)
  (check-true (string-contains? page "a takes 51 of its 101 values here"))
  (check-true (string-contains? page "title is fixed here")))

(test-case "what is too long for a page has fewer frames"
  (define (long k) (make-string 2000 (integer->char (+ 96 k))))
  (define (within room . interactions)
    (data-in (document->page (apply document-of (map value->shown interactions)) #:room room)))
  (define data (within 20000 (interact ([k 1 26]) (long k)) (interact ([k 1 6]) k)))
  (check-equal? (map frame-count data) '(4 6))
  (check-equal? (map frame-count (within 1000 (interact ([k 1 26] [b #t]) (long k)))) '(1))
  (check-equal? (map frame-count (within 5000000 (interact ([k 1 26]) (long k)))) '(26)))

;; Frames are numbered as a number is written, the first control its first digit.
(test-case "a frame is that of its labels, and the still one that of the start, however few"
  (define (long k b) (string-append (format "<~a ~a>" k b) (make-string 2000 #\.)))
  (for ([room '(5000000 30000)])
    (define i (interact ([k 1 12 #:start 3] [b #t]) (long k b)))
    (define page (document->page (document-of (value->shown i)) #:room room))
    (define data (car (data-in page)))
    (define-values (ks bs) (apply values (hash-ref data 'labels)))
    (for ([k ks] [i (in-naturals)])
      (for ([b bs] [j (in-naturals)])
        (check-true (string-contains? (frame-text data (+ (* (length bs) i) j))
                                      (format "&lt;~a ~a&gt;" k b)))))
    (define still (cadr (regexp-match #rx"<div class=\"still\">(.*?)</div><div" page)))
    (check-true (string-contains? still "&lt;3 #t&gt;"))
    (check-true (string-contains? still "at k = 3, b = #t"))))

;; ---------------------------------------------------------------------------
;; The page

(define evil "</script><script>alert(1)</script><!--")

(test-case "nothing of the user's breaks out of the data, and no other script may run"
  (define page (page-of (interact ([s (list evil "b")]) (list s (string->symbol s)))))
  (check-equal? (length (regexp-match* "</script>" page)) 2)
  (check-false (string-contains? page "<!--"))
  (check-true (string-contains? page "alert(1)"))
  (check-regexp-match "script-src 'sha256-[A-Za-z0-9+/=]*'\"" page))

(test-case "a page without interactions has no script"
  (define page (document->page (document-of (value->shown (up 'a 'b)))))
  (check-false (regexp-match? #rx"<script|script-src" page)))

(test-case "the first frame stands in the page, and an error in its place"
  (define page (page-of (interact ([k 0 5]) (/ 1 k))))
  (define still (cadr (regexp-match #rx"<div class=\"still\">(.*?)</div><div" page)))
  (check-true (string-contains? still "<pre class=\"failure\">/: division by zero</pre>"))
  (check-true (string-contains? still "at k = 0"))
  (check-false (regexp-match? #rx"failure" (frame-text (car (data-in page)) 1))))

(define (set-intersection . lists)
  (for/list ([x (in-list (remove-duplicates (car lists)))]
             #:when (andmap (lambda (l) (memv x l)) (cdr lists)))
    x))

(skip-unless (can-draw?) "the shared libraries of racket/draw are not installed: no pictures"
  (define (wave k)
    (define f (frame 0 10 -2 2 #:x-label "t"))
    (plot-function f (lambda (t) (cos (* k t))) 0 10)
    f)
  (test-case "axes stand in the page once"
    (define data (car (data-in (page-of (interact ([k 1 40]) (wave k))))))
    (check-equal? (frame-count data) 40)
    (define common (apply set-intersection (hash-ref data 'frames)))
    (with-check-info ([(quote common) (length common)]) (check-true (> (length common) 12))))
  (test-case "lines of one look that one frame has are one element, and many points an image"
    (define ((lines count) k)
      (define f (frame 0 10 0 10))
      (for ([n (in-range count)]) (plot-line f 0 n 10 (/ n k)))
      f)
    (define-values (one many) (values (lines 1) (lines 60)))
    (define (scattered k)
      (define f (frame 0 10 0 10))
      (for ([n (in-range 2000)]) (plot-point f (/ n 200) (modulo (* k n) 10)))
      f)
    (define (longest-frame i)
      (apply max (map length (hash-ref (car (data-in (page-of i))) 'frames))))
    (check-true (< (longest-frame (interact ([k 2 9]) (many k)))
                   (+ 5 (longest-frame (interact ([k 2 9]) (one k))))))
    (define-values (hline vl-append)
      (values (dynamic-require 'pict 'hline) (dynamic-require 'pict 'vl-append)))
    (define (rungs k) (apply vl-append (for/list ([n 30]) (hline (* n k) 5))))
    (check-true (< (longest-frame (interact ([k 2 9]) (rungs k))) 10))
    (check-true (< (longest-frame (interact ([k 2 9]) (scattered k))) 5))
    (check-true (string-contains? (page-of (interact ([k 2 9]) (scattered k))) "data:image/png")))
  (test-case "LaTeX has the first picture, and says where"
    (define-values (text pictures)
      (document->TeX (document-of (value->shown (interact ([k 1 40]) (wave k)))) "out"))
    (check-equal? (map car pictures) (list (string->path "out-1.pdf")))
    (check-regexp-match "includegraphics\\[width=0.6\\\\textwidth\\]{out-1.pdf}.*at k = 1\n" text)))

(test-case "LaTeX has the first formula, or its error"
  (define (TeX i)
    (define-values (text pictures) (document->TeX (document-of (value->shown i)) "o"))
    text)
  (check-regexp-match "shown{x\\^{2}}\n\nat k = 2, s = a\\\\_b\n"
                      (TeX (interact ([k 2 9] [s "a_b"]) (expt 'x k))))
  (check-regexp-match "division by zero" (TeX (interact ([k 0 9]) (/ 1 k)))))

;; ---------------------------------------------------------------------------
;; In a browser

(define folder (make-temporary-file "interactions~a" 'directory))

(define (in-browser page expression)
  (display-to-file page (build-path folder "page.html") #:exists 'truncate)
  (car (measure folder '("page.html") 390 expression)))

(define (move control position)
  (format "(() => { const i = ~a[~a].querySelector('input, select'); ~a; ~a })()"
          "d.querySelectorAll('.control')"
          control
          (if (boolean? position)
              (format "i.checked = ~a" (if position "true" "false"))
              (format "i.value = '~a'" position))
          "i.dispatchEvent(new Event('input')); return d.querySelector('.live').textContent"))

(define (in-turn . expressions) (format "[~a]" (string-join expressions ", ")))

(test-case "its own script moves it: slider, menu, check box, error and on"
  (skip-unless (browser?) "pages in a browser: Chromium is not here"
    (define page
      (page-of (interact ([k 0 5 #:start 1] [n (list "one" "two")] [b #t])
                 (list (symbol->string 'told) n b (/ 6 k)))))
    (check-equal?
     (in-browser page
                 (in-turn "d.querySelector('.live').textContent.trim()"
                          (string-append (move 0 3) ".trim()") (string-append (move 1 1) ".trim()")
                          (string-append (move 2 #f) ".trim()") (string-append (move 0 0) ".trim()")
                          (string-append (move 0 2) ".trim()")
                          "d.querySelectorAll('.control output')[0].textContent"
                          "w.getComputedStyle(d.querySelector('.still')).display"
                          "d.documentElement.scrollWidth"))
     '("'(\"told\" \"one\" #t 6)" "'(\"told\" \"one\" #t 2)" "'(\"told\" \"two\" #t 2)"
       "'(\"told\" \"two\" #f 2)" "/: division by zero" "'(\"told\" \"two\" #f 3)"
       "2" "none" 390))))

(delete-directory/files folder)
