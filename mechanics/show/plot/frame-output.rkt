#lang racket/base
;; Frames shown: as picts, in files, and on the screen, where there is one.
;;
;; A pict and a file hold the picture as it is now, which later drawing does not change; a window
;; follows later drawing.

(require "frame.rkt" "on-demand.rkt" "../../generic/output-file.rkt"
         "../display/drawing-library.rkt"
         "../../generic/define-plain.rkt" "../../generic/wrong-argument.rkt")

(provide frame->pict graphics-save graphics-show)

(define-plain (frame->pict f)
  (check-frame 'frame->pict f)
  (check-drawing 'frame->pict why-not)
  (make-picture (frame-view f) (frame-now (seen f))))

;; extension -> format
(define formats
  '((#".png" . png-bytes) (#".svg" . svg-bytes) (#".pdf" . pdf-bytes)))

;; f : a frame, or a list of frames side by side, or a list of such rows
;; centimeters : the width of all on paper, with letters of that size in points; #f for pixels
(define-plain (graphics-save f file #:centimeters [centimeters #f] #:font-size [points 9]
                             #:font [font #f])
  (define who 'graphics-save)
  (define rows (checked-rows who f))
  (check-size who "a width in centimeters, from 1 to 200, or #f" 200 (or centimeters 1))
  (check-size who "a size of letters in points, from 1 to 100" 100 points)
  (check-argument who (lambda (x) (or (not x) (string? x))) font "the name of a typeface, or #f")
  (define format (format-of-file who file formats ".png, .svg or .pdf"))
  (check-file who file why-not)
  (define panels
    (for/list ([row (in-list rows)])
      (for/list ([f (in-list row)]) (cons (frame-view f) (frame-now (seen f))))))
  (write-file who file (draw-figure panels format centimeters points font)))

(define (check-size who expected most x)
  (check-argument who (lambda (x) (and (real? x) (<= 1 x most))) x expected))

(define (checked-rows who f)
  (define rows
    (cond [(not (pair? f)) (list (list f))]
          [(andmap pair? f) f]
          [else (list f)]))
  (for* ([row (in-list rows)] [f (in-list row)]) (check-frame who f))
  rows)

;; Opens a window at once.  wait? : until it is closed; 'at-end : at the end of the program
(define-plain (graphics-show f #:wait? [wait? 'at-end])
  (check-open 'graphics-show f)
  (show-frame f wait?))
