#lang racket/base
;; Frames that a cell draws in, as it should be seen: a frame that changed is shown at the end of
;; its cell, once; where it was shown before, it is shown anew in its place.

(provide make-changed-pictures note-change! shown-before? display-name note-shown! show-changed!)

;; names : picture -> the name of its display; changed : those to be shown, the latest first;
;; shown : picture -> #t; prefix, count : of names, which no other process and picture has
(struct changed-pictures (names [changed #:mutable] shown prefix [count #:mutable]))

(define (make-changed-pictures)
  (changed-pictures (make-weak-hasheq) '() (make-weak-hasheq)
                    (format "picture-~a-" (inexact->exact (floor (current-inexact-milliseconds))))
                    0))

(define (note-change! p x)
  (define names (changed-pictures-names p))
  (unless (hash-ref names x #f)
    (set-changed-pictures-count! p (add1 (changed-pictures-count p)))
    (hash-set! names x (format "~a~a" (changed-pictures-prefix p) (changed-pictures-count p))))
  (unless (memq x (changed-pictures-changed p))
    (set-changed-pictures-changed! p (cons x (changed-pictures-changed p)))))

;; The name of the display of a picture that changed, #f of other values
(define (display-name p x) (hash-ref (changed-pictures-names p) x #f))

(define (note-shown! p x)
  (hash-set! (changed-pictures-shown p) x #t)
  (set-changed-pictures-changed! p (remq x (changed-pictures-changed p))))

(define (shown-before? p x) (hash-ref (changed-pictures-shown p) x #f))

;; show! : picture -> any
(define (show-changed! p show!)
  (for-each show! (reverse (changed-pictures-changed p))))
