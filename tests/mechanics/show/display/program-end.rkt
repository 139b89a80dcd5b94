#lang racket/base
;; The end of a program: windows stay, and frames that nobody has seen are shown or told.  It is
;; tested in processes that have a display, made up by Xvfb, or none.

;; for-label: compiled with this file, for processes that run it.
(require (for-label "../../runner/fixture/windows-at-the-end.rkt")
         racket/runtime-path
         racket/string
         "../../support/checks.rkt" "../../support/display.rkt" "../../support/skip.rkt")

(define-runtime-path program "../../runner/fixture/windows-at-the-end.rkt")

(define waiting
  "; the program has ended; its windows stay until they are closed, or until Ctrl-C")
(define unseen
  (string-append "; never shown: (frame x from 0.0 to 1.0, y from 0.0 to 1.0: 1 line), \"drawn\"; "
                 "(graphics-save f \"picture.png\") writes it to a file"))

(define (without-display . arguments)
  (define env (environment-with #""))
  (environment-variables-set! env #"WAYLAND_DISPLAY" #f)
  (string-split (apply run-program program env arguments) "\n"))

(skip-unless (eq? (system-type) 'unix) "this system has no displays that could be missing"
  (test-case "without a display a frame that nobody has seen is told, in one line"
    (check-equal? (without-display "unseen") (list "the last line" unseen)))
  (test-case "not one that was saved, or whose points were asked for"
    (check-equal? (without-display "numbers") '("the last line"))
    (define saved (without-display "saved"))
    (skip-unless (not (regexp-match? #rx"cannot be drawn" (string-join saved)))
                 "the libraries that draw are not installed: nothing is saved"
      (check-equal? saved '("the last line"))))
  (test-case "not behind an error"
    (check-false (member unseen (without-display "error"))))
  (test-case "`make run` tells the same"
    (define env (environment-with #""))
    (check-not-false
     (member unseen
             (string-split (run-program (string->path "-l") env "mechanics/lang/run-file"
                                        (path->string program) "unseen")
                           "\n")))))

(define shown (list "the last line" waiting "shown, and drawn and not shown" "one closed"))

(test-windows "the end waits until all are closed, also of a frame that was only drawn in"
              program shown "closed")
(test-windows "and so under `make run`"
              (string->path "-l") shown "mechanics/lang/run-file" (path->string program) "closed")
(test-windows "a break ends the waiting" program (list "the last line" waiting) "break")
(test-windows "a call may wait itself" program '("waited" "the last line") "call")
(test-windows "or nobody waits" program '("the last line") "no-wait")
(test-windows "in an editor frames are shown behind the program, not at the prompt" program
              '("drawn" "shown behind the program" "not at the prompt") "editor")
