#lang racket/base
;; Is there a screen to open windows on?

(require "../../error/machine-limits.rkt")

(provide check-screen)

;; Racket's library of windows asks for the screen when it is loaded.
;; load : loads it; instead : a call that needs no screen; whither : words before that call
(define (check-screen who load instead [whither "to a file it goes with "])
  (with-handlers ([exn:fail? (lambda (e) (raise-no-screen who e (string-append whither instead)))])
    (load)))

(define (raise-no-screen who e instead)
  (raise-unavailable
   who "no window can be opened here\n  reason: ~a\n  ~a\n  ~a"
   (exn-message e)
   instead
   "windows need a display and the library GTK 3: on Debian and Ubuntu, apt install libgtk-3-0"))
