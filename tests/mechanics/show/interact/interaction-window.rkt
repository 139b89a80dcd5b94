#lang racket/base
;; The window of an interaction, where there is a display or a program, Xvfb, that stands for one.
;; It is tested in a process of its own, which has that display.

;; for-label: compiled with this file, for processes that run it.
(require (for-label "../../runner/fixture/interaction.rkt")
         racket/list
         racket/runtime-path
         "../../support/checks.rkt" "../../support/display.rkt" "../../support/skip.rkt")

(define-runtime-path program "../../runner/fixture/interaction.rkt")

(skip-unless (eq? (system-type) 'unix) "this system has no displays that could be missing"
  (test-case "without a display there is a message, the same every time, and the first value"
    (define-values (output refusals) (run-without-display program 'interaction-show))
    (check-equal? (length refusals) 2 output)
    (check-equal? (remove-duplicates refusals) (list (car refusals)))
    (check-regexp-match "\n  a page with its sliders is made by raco mechanics show FILE\n" output)
    (check-regexp-match
     (string-append "\n4; at k = 2; controls: in a window, with a display; "
                    "on a page, by raco mechanics show\n$")
     output)))

(test-windows
 "controls move the picture, the newest values first; errors stand in its place"
 program
 '("shown" "the first picture" "named" "the slider moves it" "the menu" "the check box" "the text"
   "no error" "an error in its place" "and the next move works" "no place beyond the last"
   "the newest value is next"
   "what has begun is finished" "drawn again for another size" "closed"
   "a body without end stops no other window" "a formula is as large as on a page"
   "a broad picture fits" "and is on the screen"
   "and is ended with its window"
   "the program waits for it" "done"))
