#lang racket/base
;; Pictures of many points, as a surface of section has them.

(require file/convertible
         mechanics/plot
         "task.rkt")

(provide picture-tasks)

;; The drawing library is loaded before the clock starts.
(define (square-frame)
  (define f (frame 0 1 0 1))
  (convert f 'png-bytes)
  f)

;; -> bytes of the file
(define (point-picture f count)
  (define generator (make-pseudo-random-generator))
  (for ([_ (in-range count)])
    (plot-point f (random generator) (random generator)))
  (bytes-length (convert f 'png-bytes)))

(define picture-tasks
  (list
   (make-prepared-task 'G4 "10 000 random points drawn in a frame, and its PNG"
                       square-frame (lambda (f) (point-picture f 10000)) #:size values)
   (make-prepared-task 'G5 "the same of 100 000 points"
                       square-frame (lambda (f) (point-picture f 100000)) #:size values)))
