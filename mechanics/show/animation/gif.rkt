#lang racket/base
;; Pictures that follow each other, as an animated GIF.
;;
;; A picture is stored as the rectangle in which it differs from the one before.  Racket's
;; mrlib/gif would do, but needs a display; file/gif, beneath it, needs none.

(require file/gif
         racket/class
         racket/draw
         (only-in pict draw-pict)
         "palette.rkt")

(provide write-gif)

;; pictures : vector of -> pict; sizes in pixels; delay : hundredths of a second
(define (write-gif pictures width height delay port)
  (define palette
    (make-palette (for/list ([i (in-list (sample (vector-length pictures)))])
                    (pixels-of ((vector-ref pictures i)) width height))))
  (define gif (gif-start port width height 0 (palette-colors palette)))
  (gif-add-loop-control gif 0)
  (for/fold ([before #f]) ([picture (in-vector pictures)])
    (define now (indexed (pixels-of (picture) width height) palette))
    (define-values (left top right bottom) (changed before now width height))
    (gif-add-control gif 'keep #f delay #f)
    (gif-add-image gif left top (- right left) (- bottom top) #f #f
                   (part now width left top right bottom))
    now)
  (gif-end gif))

;; Returns the indices of the pictures from which the palette is made.
(define (sample n)
  (define count (min n 12))
  (for/list ([k (in-range count)]) (quotient (* k (- n 1)) (max 1 (- count 1)))))

;; Returns the ARGB bytes of a picture on white paper.
(define (pixels-of picture width height)
  (define bitmap (make-object bitmap% width height #f #f))
  (define canvas (new bitmap-dc% [bitmap bitmap]))
  (send canvas set-smoothing 'smoothed)
  (draw-pict picture canvas 0 0)
  (define pixels (make-bytes (* 4 width height)))
  (send bitmap get-argb-pixels 0 0 width height pixels)
  pixels)

(define (indexed pixels palette)
  (define n (quotient (bytes-length pixels) 4))
  (define indices (make-bytes n))
  (for ([k (in-range n)]) (bytes-set! indices k (palette-index palette pixels (* 4 k))))
  indices)

;; ---------------------------------------------------------------------------
;; What changes

;; Finds the smallest rectangle, of one pixel at least, outside of which both are equal.
;; Returns left, top, right, bottom; the last two are just beyond it.
(define (changed before now width height)
  (cond [(not before) (values 0 0 width height)]
        [else
         (define (differ? i) (not (eq? (bytes-ref before i) (bytes-ref now i))))
         (define (row? y) (for/or ([i (in-range (* y width) (* (+ y 1) width))]) (differ? i)))
         (define top (for/first ([y (in-range height)] #:when (row? y)) y))
         (define bottom (for/first ([y (in-range (- height 1) -1 -1)] #:when (row? y)) y))
         (define (column? x) (for/or ([y (in-range top (+ bottom 1))]) (differ? (+ (* y width) x))))
         (if top
             (values (for/first ([x (in-range width)] #:when (column? x)) x)
                     top
                     (for/first ([x (in-range width 0 -1)] #:when (column? (- x 1))) x)
                     (+ bottom 1))
             (values 0 0 1 1))]))

(define (part indices width left top right bottom)
  (define wide (- right left))
  (define out (make-bytes (* wide (- bottom top))))
  (for ([y (in-range top bottom)])
    (define from (+ (* y width) left))
    (bytes-copy! out (* (- y top) wide) indices from (+ from wide)))
  out)
