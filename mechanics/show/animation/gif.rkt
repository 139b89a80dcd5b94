#lang racket/base
;; Pictures that follow each other, as an animated GIF.
;;
;; A picture is stored as the rectangle in which it differs from the one before.  Racket's
;; mrlib/gif would do, but needs a display; file/gif, beneath it, needs none.

(require file/gif
         racket/class
         racket/draw
         racket/list
         (only-in pict draw-pict))

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

;; ---------------------------------------------------------------------------
;; The colors, at most 256 for all of the pictures
;;
;; Colors are told apart by their five leading bits in red, green and blue: 32,768 bins.  The
;; fullest bins of some sample pictures make the palette, each with the mean of its colors, and
;; every other bin takes the nearest of those.  Line drawings, which have few colors and the
;; shades on edges between them, look as they did.

;; colors : vectors of three bytes, as many as a power of 2
;; indices : for each bin the index of its color, or #f until it is first asked for
(struct palette (colors indices))

(define bins 32768)

;; samples : ARGB bytes, one after the other
(define (make-palette samples)
  (define counts (make-vector bins 0))
  (define sums (build-vector 3 (lambda (k) (make-vector bins 0))))
  (for* ([pixels (in-list samples)] [i (in-range 0 (bytes-length pixels) 4)])
    (define bin (bin-at pixels i))
    (increase! counts bin 1)
    (for ([k (in-range 3)]) (increase! (vector-ref sums k) bin (bytes-ref pixels (+ i k 1)))))
  (define used (filter (lambda (bin) (> (vector-ref counts bin) 0)) (range bins)))
  (define chosen
    (take (sort used > #:key (lambda (bin) (vector-ref counts bin))) (min 256 (length used))))
  (define (mean bin)
    (for/vector #:length 3 ([sum (in-vector sums)])
      (quotient (vector-ref sum bin) (vector-ref counts bin))))
  (define indices (make-vector bins #f))
  (for ([bin (in-list chosen)] [i (in-naturals)]) (vector-set! indices bin i))
  (palette (padded (map mean chosen)) indices))

(define (increase! v i by) (vector-set! v i (+ by (vector-ref v i))))

;; GIF wants 2, 4, 8, ... colors.
(define (padded colors)
  (define size (expt 2 (max 1 (integer-length (- (length colors) 1)))))
  (append colors (make-list (- size (length colors)) (vector 0 0 0))))

(define (bin-at pixels i)
  (define (leading-bits k) (arithmetic-shift (bytes-ref pixels (+ i k)) -3))
  (bitwise-ior (arithmetic-shift (leading-bits 1) 10) (arithmetic-shift (leading-bits 2) 5)
               (leading-bits 3)))

;; The number of the color of the pixel that begins at i.
(define (palette-index p pixels i)
  (define bin (bin-at pixels i))
  (define indices (palette-indices p))
  (or (vector-ref indices bin)
      (let ([found (nearest (palette-colors p) (subbytes pixels (+ i 1) (+ i 4)))])
        (vector-set! indices bin found)
        found)))

;; Returns the index of the color nearest to three bytes.
(define (nearest colors rgb)
  (define (distance color)
    (for/sum ([a (in-vector color)] [b (in-bytes rgb)]) (* (- a b) (- a b))))
  (index-of colors (argmin distance colors) eq?))
