#lang racket/base
;; Frames that a cell draws in, as it should be seen: a frame that changed is shown at the end of
;; its cell, once; where it was shown before, it is shown anew in its place.

(require "mime-bundle.rkt"
         "../generic/on-demand.rkt"
         "../show/display/program-end.rkt"
         "../show/interact/live-result.rkt")

(require-on-demand ["live-interaction.rkt" interaction-message])

(provide make-changed-pictures call-showing-changes result-message note-shown! note-explored!)

;; names : picture -> the name of its display; changed : those to be shown, the latest first;
;; shown : picture -> #t; explored : picture -> maker of the message of its exploration, once;
;; prefix, count : of names, which no other process and picture has
(struct changed-pictures (names [changed #:mutable] shown explored prefix [count #:mutable]))

(define (make-changed-pictures)
  (changed-pictures (make-weak-hasheq) '() (make-weak-hasheq) (make-weak-hasheq)
                    (format "picture-~a-" (inexact->exact (floor (current-inexact-milliseconds))))
                    0))

(define (note-change! p x)
  (define names (changed-pictures-names p))
  (unless (hash-ref names x #f)
    (set-changed-pictures-count! p (add1 (changed-pictures-count p)))
    (hash-set! names x (format "~a~a" (changed-pictures-prefix p) (changed-pictures-count p))))
  (unless (memq x (changed-pictures-changed p))
    (set-changed-pictures-changed! p (cons x (changed-pictures-changed p)))))

;; x : a frame in which a map is to be explored where it is shown next; make : -> message
(define (note-explored! p x make)
  (hash-set! (changed-pictures-explored p) x make)
  (note-change! p x))

(define (note-shown! p x)
  (hash-set! (changed-pictures-shown p) x #t)
  (set-changed-pictures-changed! p (remq x (changed-pictures-changed p))))

;; (f), and then shows the pictures that changed meanwhile.  show! : picture -> any
(define (call-showing-changes p f show!)
  (parameterize ([current-picture-watcher (lambda (x) (note-change! p x))])
    (begin0 (f)
            (for-each show! (reverse (changed-pictures-changed p))))))

;; x : a value -> message.  in-place? : where it was shown before, if it was
(define (result-message p x in-place?)
  (define explored (changed-pictures-explored p))
  (define m
    (parameterize ([current-picture-watcher #f])
      (cond [(live? x) (interaction-message x)]
            [(hash-ref explored x #f) => (lambda (make)
                                           (hash-remove! explored x)
                                           (make))]
            [else (hasheq 'kind "shown" 'data (value->bundle x))])))
  (define name (hash-ref (changed-pictures-names p) x #f))
  (if name
      (hash-set* m 'display name
                 'update (and in-place? (hash-ref (changed-pictures-shown p) x #f)))
      m))
