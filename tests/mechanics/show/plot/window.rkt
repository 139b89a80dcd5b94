#lang racket/base
;; Windows, where there is a display or a program, Xvfb, that stands for one.
;;
;; They are tested in a process of its own, which has that display.

;; for-label: compiled with this file, for processes that run it.
(require (for-label "../../runner/fixture/window.rkt")
         racket/list
         racket/runtime-path
         "../../support/checks.rkt" "../../support/display.rkt" "../../support/skip.rkt")

(define-runtime-path program "../../runner/fixture/window.rkt")

;; ---------------------------------------------------------------------------

(skip-unless (eq? (system-type) 'unix) "this system has no displays that could be missing"
  (test-case "without a display there is a message, the same every time, and no window"
    (define-values (output refusals) (run-without-display program 'graphics-show))
    (check-equal? (length refusals) 3)
    (check-equal? (remove-duplicates refusals) (list (car refusals)))
    (check-regexp-match
     (string-append
      "\n  to a file it goes with \\(graphics-save frame \"picture.png\"\\)"
      "\n  windows need a display and the library GTK 3: .*apt install libgtk-3-0\n")
     output)))

(test-windows
 "a window follows what is drawn, and is closed with its frame"
 program
 '("shown, drawn in and closed" "(0 300 200)" "follows" "rests"
   "is drawn again for another size" "looks no more"))
