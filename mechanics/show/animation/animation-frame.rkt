#lang racket/base
;; Single pictures of an animation, and files of all of them.

(require "animation.rkt" "drawing.rkt" "film.rkt" "on-demand.rkt" "pictures-on-demand.rkt"
         "../../generic/output-file.rkt")

(provide animation-frame animation-save)

(define (animation-frame a t)
  (define who 'animation-frame)
  (check-animation who a)
  (define time (check-time-within who (film-schedule (animation-film a)) t))
  (check-drawing-library who)
  (scenery->pict ((animation-pictures a)) time))

;; extension -> the procedure that makes the bytes
(define formats
  (list (cons #".gif" scenery->gif) (cons #".html" scenery->page) (cons #".htm" scenery->page)))

;; All is drawn before anything is written.
(define (animation-save a file)
  (define who 'animation-save)
  (check-animation who a)
  (define make (format-of-file who file formats ".gif or .html"))
  (check-file who file why-no-pictures)
  (define bytes (make who ((animation-pictures a))))
  (write-file who file bytes))
