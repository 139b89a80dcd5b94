#lang racket/base
;; Curves on which a function of the plane has given values: zero-velocity curves of an
;; effective potential, orbits in phase space as levels of the energy.

(require "plotted-number.rkt" "frame.rkt" "picture-layer.rkt" "style.rkt"
         (only-in "../../error/progress.rkt" call-counting)
         "../../generic/define-plain.rkt" "../../generic/wrong-argument.rkt")

(provide plot-contours nodes)

;; The function is evaluated here, once, at the nodes of a grid over the frame; so its
;; errors are raised where it is drawn, and pictures are quick.
(define-plain (plot-contours f function levels
                             #:samples [samples 101]
                             #:color [color 0] #:width [width 1] #:style [dash 'solid]
                             #:label [label #f])
  (define who 'plot-contours)
  (check-plain who f)
  (check-function who function 2)
  (define all (if (list? levels) levels (list levels)))
  (for ([level (in-list all)]) (check-number who "a level" level))
  (unless (and (exact-integer? samples) (<= 2 samples 2000))
    (complain-of-argument who "a number of samples from 2 to 2000" samples))
  (define rows (sample who function (frame-bounds f) samples))
  (for ([level (in-list all)] [first? (in-sequences '(#t) (in-cycle '(#f)))])
    (add-layer! who f
                (make-style who 'level color width dash (and first? label))
                (field rows samples (real->double-flonum level)))))

(define (sample who function bounds n)
  (define-values (x-min x-max y-min y-max) (apply values bounds))
  (define xs (nodes x-min x-max n))
  (call-counting
   who "rows" n
   (lambda (count!)
     (for/vector #:length n ([y (in-list (nodes y-min y-max n))] [k (in-naturals)])
       (count! k)
       (for/vector #:length n ([x (in-list xs)])
         (coordinate-of who (lambda () (format "the value at ~a, ~a" x y)) (function x y)))))))

;; -> n numbers from one to another, at equal distances
(define (nodes low high n)
  (for/list ([k (in-range n)])
    (if (= k (- n 1)) high (+ low (* (- high low) (/ k (- n 1.0)))))))
