#lang racket/base
;; Are the shared libraries there that racket/draw calls?

(require "../../error/machine-limits.rkt")

(provide reason-not-to-load check-drawing)

;; load : loads a module that needs them
;; -> a procedure that returns #f, or the reason why they cannot be loaded: a string that ends
;; with the remedy.  Loading is tried once; every failure in it counts as a missing library.
(define ((reason-not-to-load load [reason (box 'unknown)]))
  (when (eq? (unbox reason) 'unknown)
    (set-box! reason
              (with-handlers ([exn:fail? (lambda (e) (string-append (exn-message e) remedy))])
                (load)
                #f)))
  (unbox reason))

;; reason : a procedure made by reason-not-to-load
(define (check-drawing who reason)
  (define text (reason))
  (when text
    (raise-unavailable who "pictures cannot be drawn on this machine\n  reason: ~a" text)))

;; Cairo and the other libraries come with these.
(define remedy
  (string-append
   "\n  pictures are drawn by the libraries Cairo and Pango; to install them:"
   "\n  Debian: apt install libpangocairo-1.0-0 libjpeg62-turbo"
   "\n  Ubuntu: apt install libpangocairo-1.0-0 libjpeg-turbo8"
   "\n  Fedora: dnf install pango libjpeg-turbo; Arch: pacman -S pango libjpeg-turbo"
   "\n  macOS, Windows: Racket's package draw-lib brings them: raco pkg install draw-lib"))
