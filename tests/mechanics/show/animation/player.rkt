#lang racket/base
;; The window that plays, where there is a display or a program, Xvfb, that stands for one.
;;
;; It is tested in a process of its own, which has that display.

;; for-label: compiled with this file, for processes that run it.
(require (for-label "../../runner/fixture/player.rkt")
         racket/list
         racket/runtime-path
         "../../support/checks.rkt" "../../support/display.rkt" "../../support/skip.rkt")

(define-runtime-path program "../../runner/fixture/player.rkt")

(skip-unless (eq? (system-type) 'unix) "this system has no displays that could be missing"
  (test-case "without a display there is a message, the same every time, and no window"
    (define-values (output refusals) (run-without-display program 'animation-show))
    (check-equal? (length refusals) 2 output)
    (check-equal? (remove-duplicates refusals) (list (car refusals)))
    (check-regexp-match
     "\n  to a file it goes with \\(animation-save animation \"motion.gif\"\\), or \"motion.html\"\n"
     output)))

(test-windows
 "it plays, pauses, goes where the slider and the keys say, and stops at an error"
 program
 '("named" "plays" "pauses" "t = 1.00" "t = 1.04" "t = 2.00" "plays again" "slowly"
   "other windows do not wait" "says what failed" "closed"))
