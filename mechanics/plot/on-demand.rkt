#lang racket/base
;; The drawing library, loaded when the first picture is made.

(require "../generic/on-demand.rkt")

(require-on-demand ["picture.rkt" loaded? color-name? make-picture picture-bytes])

(provide can-draw? why-not color-name? make-picture picture-bytes)

;; Are the shared libraries there that racket/draw calls?
(define (can-draw?) (not (why-not)))

;; -> string, which ends with what to install, or #f.  A library that is missing is looked for
;; once; nothing but the loading can fail here, in whatever way.
(define (why-not)
  (when (eq? (unbox reason) 'unknown)
    (set-box! reason
              (with-handlers ([exn:fail? (lambda (e) (string-append (exn-message e) remedy))])
                (loaded?)
                #f)))
  (unbox reason))

;; Cairo and the other libraries come with these.
(define remedy
  (string-append
   "\n  pictures are drawn by the libraries Cairo and Pango; to install them:"
   "\n  Debian: apt install libpangocairo-1.0-0 libjpeg62-turbo"
   "\n  Ubuntu: apt install libpangocairo-1.0-0 libjpeg-turbo8"
   "\n  Fedora: dnf install pango libjpeg-turbo; Arch: pacman -S pango libjpeg-turbo"
   "\n  macOS, Windows: Racket's package draw-lib brings them: raco pkg install draw-lib"))

(define reason (box 'unknown))
