#lang racket/base
;; Pages as a browser lays them out: no wider than a phone, brackets as tall as what they hold,
;; the version of a formula for which there is room.

(require racket/file
         mechanics
         "../../support/checks.rkt" "../../../../mechanics/show/document/web-page.rkt"
         "../../../../mechanics/show/document/document-piece.rkt"
         "../../../../mechanics/show/document/shown-result.rkt"
         "../../support/browser.rkt" "../../support/skip.rkt")

(define (shown x) (result (value->shown x)))

(define page
  (document->page
   (document "A title_with_a_very_long_name_that_does_not_fit_on_a_line_of_a_phone"
             "#lang mechanics"
             (list (prose '(("Some words, and more of them, that are broken into lines.")))
                   (code "(define (f x) (g x x x x x x x x x x x x x x x x x x x x x x x x))" 0)
                   (shown (up 'a (/ 'b (/ 'c (+ 1 (/ 'd 'e))))))
                   (shown (apply + (for/list ([i 12]) (* 'amplitude (sin (* i 'omega 't))))))
                   (shown (for/list ([i 3]) (list i (exp (* 1. i)) (exp (* -1. i)))))
                   (failure (make-string 200 #\x))))))

(define script
  (string-append
   "({screen: d.documentElement.scrollWidth,"
   " cut: [...d.querySelectorAll('pre.code')].map(e => e.scrollWidth - e.clientWidth),"
   " heights: [d.querySelector('math'), d.querySelector('math mo')]"
   ".map(e => e.getBoundingClientRect().height),"
   " shown: [...d.querySelectorAll('.wide, .narrow')].filter(e => e.offsetParent)"
   ".map(e => e.className)})"))

(define widths '(1200 390 320))

;; width -> hasheq of what is measured there
(define (measured-pages)
  (define folder (make-temporary-file "pages~a" 'directory))
  (display-to-file page (build-path folder "page.html"))
  (begin0 (for/hasheqv ([width (in-list widths)])
            (values width (car (measure folder '("page.html") width script))))
          (delete-directory/files folder)))

(skip-unless (browser?) "pages in a browser: Chromium is not here"
  (define pages (measured-pages))
  (define (of-page width name) (hash-ref (hash-ref pages width) name))
  (test-case "a page is as wide as the screen, on a desk and on a phone"
    (for ([width widths]) (check-equal? (of-page width 'screen) width)))
  (test-case "no line of a program is cut"
    (for ([width widths]) (check-equal? (of-page width 'cut) '(0))))
  (test-case "brackets stretch, for the page has its font"
    (define heights (of-page 1200 'heights))
    (check-true (> (cadr heights) (* 0.8 (car heights))) (format "~s" heights))
    (check-true (> (car heights) 60)))
  (test-case "the formula for which there is room is shown"
    (check-equal? (of-page 1200 'shown) '("formula wide"))
    (check-equal? (of-page 390 'shown) '("formula narrow"))))
