#lang racket/base
;; Frames that a cell draws in, as it should be seen: a frame that changed is shown at the end of
;; its cell, once; where it was shown before, it is shown anew in its place.

(provide make-changed-pictures note-change! display-name show-changed!)

;; names : picture -> the name of its display; changed : those to be shown, the latest first;
;; shown : picture -> #t
(struct changed-pictures (names [changed #:mutable] shown))

(define (make-changed-pictures) (changed-pictures (make-weak-hasheq) '() (make-weak-hasheq)))

(define (note-change! p x)
  (define names (changed-pictures-names p))
  (unless (hash-ref names x #f)
    (hash-set! names x (format "picture-~a" (hash-count names))))
  (unless (memq x (changed-pictures-changed p))
    (set-changed-pictures-changed! p (cons x (changed-pictures-changed p)))))

;; Of a value that is shown now: the name of its display, or #f if it is no picture that changed
(define (display-name p x)
  (define name (hash-ref (changed-pictures-names p) x #f))
  (when name
    (hash-set! (changed-pictures-shown p) x #t)
    (set-changed-pictures-changed! p (remq x (changed-pictures-changed p))))
  name)

;; show! : picture, whether it was shown before ->
(define (show-changed! p show!)
  (for ([x (in-list (reverse (changed-pictures-changed p)))])
    (show! x (hash-ref (changed-pictures-shown p) x #f))))
