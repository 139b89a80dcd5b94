#lang racket/base
;; The colors of a GIF, at most 256 for all of its pictures.
;;
;; Colors are told apart by their five leading bits in red, green and blue: 32,768 bins.  The
;; fullest bins of some sample pictures make the palette, each with the mean of its colors, and
;; every other bin takes the nearest of those.  Line drawings, which have few colors and the
;; shades on edges between them, look as they did.

(require racket/list)

(provide make-palette palette-colors palette-index)

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
