#lang racket/base
;; Is there a screen to open windows on?

(require "../error/machine.rkt")

(provide check-screen)

;; Racket's library of windows asks for the screen when it is loaded.
;; load : -> any, loads it; instead : what saves the picture to a file
(define (check-screen who load instead)
  (with-handlers ([exn:fail? (lambda (e) (raise-no-screen who e instead))]) (load)))

(define (raise-no-screen who e instead)
  (raise-unavailable
   who "no window can be opened here\n  reason: ~a\n  ~a\n  ~a"
   (exn-message e)
   (string-append "to a file it goes with " instead)
   "windows need a display and the library GTK 3: on Debian and Ubuntu, apt install libgtk-3-0"))
