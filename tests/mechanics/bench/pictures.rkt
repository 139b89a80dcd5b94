#lang racket/base
;; Pictures of many points, as a surface of section has them, and of long formulas.

(require file/convertible
         (prefix-in m: mechanics)
         (only-in mechanics/algebra/expression/write make-sizer)
         mechanics/pict
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

;; ---------------------------------------------------------------------------
;; Formulas

;; Typeset, and drawn on a bitmap; -> how many numbers and names it has
(define (formula-picture x)
  ((dynamic-require 'pict 'pict->bitmap) (->pict x))
  ((make-sizer) (m:expression x)))

(define (long-formula)
  (formula-picture (m:/ 'a 'b))
  (for/fold ([sum 0]) ([i (in-range 1 133)])
    (define (indexed name) (string->symbol (format "~a_~a" name i)))
    (m:+ sum (m:/ (m:* (indexed 'm) (m:square (indexed 'thetadot))
                       (m:cos (m:- (indexed 'phi) (m:* 3 (indexed 'theta)))))
                  (m:sqrt (m:+ (indexed 'x) 2))))))

;; ---------------------------------------------------------------------------

(define picture-tasks
  (list
   (make-prepared-task 'G4 "10 000 random points drawn in a frame, and its PNG"
                       square-frame (lambda (f) (point-picture f 10000)) #:size values)
   (make-prepared-task 'G5 "the same of 100 000 points"
                       square-frame (lambda (f) (point-picture f 100000)) #:size values)
   (make-task 'G6 "the first formula typeset and drawn: the libraries are loaded"
              (lambda () (formula-picture (m:/ 'a 'b))) #:size values)
   (make-prepared-task 'G7 "a formula of 2000 numbers and names typeset and drawn"
                       long-formula formula-picture #:size values)))
