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

(define folder (make-temporary-file "pages~a" 'directory))
(define (of-page width expression)
  (car (measure folder '("page.html") width expression)))

(display-to-file page (build-path folder "page.html"))

(test-case "a page is as wide as the screen, on a desk and on a phone"
  (skip-unless (browser?) "pages in a browser: Chromium is not here"
    (for ([width '(1200 390 320)])
      (check-equal? (of-page width "d.documentElement.scrollWidth") width))))

(test-case "no line of a program is cut"
  (skip-unless (browser?) "pages in a browser: Chromium is not here"
    (for ([width '(1200 390 320)])
      (define beyond
        (of-page width (string-append "[...d.querySelectorAll('pre.code')]"
                                      ".map(e => e.scrollWidth - e.clientWidth)")))
      (check-equal? beyond '(0)))))

(test-case "brackets stretch, for the page has its font"
  (skip-unless (browser?) "pages in a browser: Chromium is not here"
    (define heights
      (of-page 1200 (string-append "[d.querySelector('math'), d.querySelector('math mo')]"
                                   ".map(e => e.getBoundingClientRect().height)")))
    (check-true (> (cadr heights) (* 0.8 (car heights))) (format "~s" heights))
    (check-true (> (car heights) 60))))

(test-case "the formula for which there is room is shown"
  (skip-unless (browser?) "pages in a browser: Chromium is not here"
    (define shown-class
      "[...d.querySelectorAll('.wide, .narrow')].filter(e => e.offsetParent).map(e => e.className)")
    (check-equal? (of-page 1200 shown-class) '("formula wide"))
    (check-equal? (of-page 390 shown-class) '("formula narrow"))))

(delete-directory/files folder)
