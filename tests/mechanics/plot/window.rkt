#lang racket/base
;; Windows, where there is a display or a program, Xvfb, that stands for one.
;;
;; They are tested in a process of its own, which has that display.

(require racket/list
         racket/runtime-path
         racket/string
         rackunit
         "../support/display.rkt" "../support/skip.rkt")

(define-runtime-path program "../runner/fixture/window.rkt")

;; ---------------------------------------------------------------------------

(skip-unless (eq? (system-type) 'unix) "this system has no displays that could be missing"
  (test-case "without a display there is a message, the same every time, and no window"
    (define output (run-program program (environment-with #"nowhere:99")))
    (define refusals
      (regexp-match* #px"(?m:^)graphics-show: no window can be opened here\n  reason: [^\n]+\n"
                     output))
    (check-equal? (length refusals) 3)
    (check-equal? (remove-duplicates refusals) (list (car refusals)))
    (check-regexp-match
     (string-append
      "\n  to a file it goes with \\(graphics-save frame \"picture.png\"\\)"
      "\n  windows need a display and the library GTK 3: .*apt install libgtk-3-0\n")
     output)))

;; What the program says, one line each, all of them and in this order; libraries may
;; complain in between, as they do where there is no home to keep their settings in.
(define expected
  '("shown, drawn in and closed" "(0 300 200)" "follows" "rests" "looks no more"))

(define (said output)
  (filter (lambda (line) (member line expected)) (string-split output "\n")))

(skip-unless (display-server)
             "Xvfb (Debian: apt install xvfb) is not installed: windows are not opened"
  (define output
    (call-with-display (lambda (display) (run-program program (environment-with display)))))
  (skip-unless (not (regexp-match? #rx"ffi-lib: " output))
               "the shared libraries of racket/gui are not installed: windows are not opened"
    (test-case "a window follows what is drawn, and is closed with its frame"
      (check-equal? (said output) expected output))))
