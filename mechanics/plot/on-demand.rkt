#lang racket/base
;; The drawing library, loaded when the first picture is made.

(require "../generic/on-demand.rkt")

(require-on-demand ["picture.rkt" loaded? color-name? make-picture picture-bytes])

(provide can-draw? why-not color-name? make-picture picture-bytes)

;; Are the shared libraries there that racket/draw calls?
(define (can-draw?) (not (why-not)))

;; -> string or #f.  A library that is missing is looked for once; nothing but the loading
;; can fail here, in whatever way.
(define (why-not)
  (when (eq? (unbox reason) 'unknown)
    (set-box! reason
              (with-handlers ([exn:fail? exn-message])
                (loaded?)
                #f)))
  (unbox reason))

(define reason (box 'unknown))
