#lang racket/base
;; Are the shared libraries there that racket/draw calls?

(provide reason-not-to-load)

;; load : -> any, loads what needs them
;; -> a procedure that gives the reason why they cannot be loaded, a string which ends with
;; what to install, or #f.  A library that is missing is looked for once; nothing but the
;; loading can fail here, in whatever way.
(define ((reason-not-to-load load [reason (box 'unknown)]))
  (when (eq? (unbox reason) 'unknown)
    (set-box! reason
              (with-handlers ([exn:fail? (lambda (e) (string-append (exn-message e) remedy))])
                (load)
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
