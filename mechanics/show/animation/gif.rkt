#lang racket/base
;; Pictures that follow each other, as an animated GIF.
;;
;; A picture is stored as the rectangle in which it differs from the one before, with colors
;; of its own.  Racket's mrlib/gif would do, but needs a display; file/gif, beneath it, needs none.

(require file/gif
         racket/class
         racket/draw
         (only-in racket/list take)
         (only-in pict draw-pict))

(provide write-gif)

;; pictures : vector of -> pict; sizes in pixels; delay : hundredths of a second
(define (write-gif pictures width height delay port)
  (define gif (gif-start port width height 0 '(#(255 255 255) #(0 0 0))))
  (gif-add-loop-control gif 0)
  (for/fold ([before #f]) ([picture (in-vector pictures)])
    (define now (pixels-of (picture) width height))
    (define-values (left top right bottom) (changed before now width height))
    (define-values (indices colors _) (quantize (part now width left top right bottom)))
    (gif-add-control gif 'keep #f delay #f)
    (gif-add-image gif left top (- right left) (- bottom top) #f
                   (used-colors colors indices) indices)
    now)
  (gif-end gif))

;; -> the first 2, 4, 8 ... colors, as GIF wants, up to the last that an index names.
(define (used-colors colors indices)
  (take colors (expt 2 (integer-length (for/fold ([m 1]) ([i (in-bytes indices)]) (max m i))))))

;; -> the ARGB bytes of a picture on white paper
(define (pixels-of picture width height)
  (define bitmap (make-object bitmap% width height #f #f))
  (define canvas (new bitmap-dc% [bitmap bitmap]))
  (send canvas set-smoothing 'smoothed)
  (draw-pict picture canvas 0 0)
  (define pixels (make-bytes (* 4 width height)))
  (send bitmap get-argb-pixels 0 0 width height pixels)
  pixels)

;; ---------------------------------------------------------------------------
;; The part that changes

;; Finds the smallest rectangle, of one pixel at least, outside of which both are equal.
;; -> left, top, right, bottom; the last two are just beyond it
(define (changed before now width height)
  (cond [(not before) (values 0 0 width height)]
        [else
         (define (differ? from to)
           (for/or ([a (in-bytes before from to)] [b (in-bytes now from to)]) (not (eq? a b))))
         (define (row? y) (differ? (* 4 y width) (* 4 (+ y 1) width)))
         (define top (for/first ([y (in-range height)] #:when (row? y)) y))
         (define bottom (for/first ([y (in-range (- height 1) -1 -1)] #:when (row? y)) y))
         (define (column? x)
           (for/or ([y (in-range top (+ bottom 1))])
             (define i (* 4 (+ (* y width) x)))
             (differ? i (+ i 4))))
         (if top
             (values (for/first ([x (in-range width)] #:when (column? x)) x)
                     top
                     (for/first ([x (in-range width 0 -1)] #:when (column? (- x 1))) x)
                     (+ bottom 1))
             (values 0 0 1 1))]))

(define (part pixels width left top right bottom)
  (apply bytes-append
         (for/list ([y (in-range top bottom)])
           (subbytes pixels (* 4 (+ (* y width) left)) (* 4 (+ (* y width) right))))))
