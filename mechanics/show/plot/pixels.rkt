#lang racket/base
;; Points of a part of the plane as pixels: marking one is a few stores into a byte string, which
;; is put on a bitmap as a whole.

(require racket/math
         racket/unsafe/ops)

(provide make-pixels pixels-bytes mark! pixels-width pixels-height pixels-bounds
         pixel->point point->pixel)

;; bounds : (list x-min x-max y-min y-max), flonums; bytes : alpha, red, green and blue of each
;; pixel, row by row from above
(struct pixels (bounds width height bytes) #:authentic)

;; Nothing is marked at first: all is transparent.
(define (make-pixels bounds width height)
  (pixels bounds width height (make-bytes (* 4 width height) 0)))

;; -> the point in the middle of a pixel
(define (pixel->point p i j)
  (define-values (x-min x-max y-min y-max) (apply values (pixels-bounds p)))
  (values (+ x-min (* (- x-max x-min) (/ (+ i 0.5) (pixels-width p))))
          (- y-max (* (- y-max y-min) (/ (+ j 0.5) (pixels-height p))))))

;; -> the pixel of a point, perhaps outside of the picture
(define (point->pixel p x y)
  (define-values (x-min x-max y-min y-max) (apply values (pixels-bounds p)))
  (values (exact-floor (* (pixels-width p) (/ (- x x-min) (- x-max x-min))))
          (exact-floor (* (pixels-height p) (/ (- y-max y) (- y-max y-min))))))

;; Marks the first `count` points of two flvectors, in a colour of three bytes; dots are squares.
(define (mark! p xs ys count color [wide 2])
  (define-values (x-min x-max y-min y-max) (apply values (pixels-bounds p)))
  (define-values (width height) (values (pixels-width p) (pixels-height p)))
  (define-values (x-scale y-scale)
    (values (/ width (- x-max x-min)) (/ height (- y-max y-min))))
  (define dot! (dot-marker p color))
  (define back (unsafe-fxquotient (unsafe-fx- wide 1) 2))
  (let loop ([k 0])
    (when (unsafe-fx< k count)
      (define-values (x y) (values (unsafe-flvector-ref xs k) (unsafe-flvector-ref ys k)))
      (when (and (unsafe-fl<= x-min x) (unsafe-fl<= x x-max)
                 (unsafe-fl<= y-min y) (unsafe-fl<= y y-max))
        (define i (unsafe-fx- (unsafe-fl->fx (unsafe-fl* x-scale (unsafe-fl- x x-min))) back))
        (define j (unsafe-fx- (unsafe-fl->fx (unsafe-fl* y-scale (unsafe-fl- y-max y))) back))
        (for* ([b (in-range j (unsafe-fx+ j wide))] [a (in-range i (unsafe-fx+ i wide))])
          (dot! a b)))
      (loop (unsafe-fx+ k 1)))))

;; -> a procedure that marks pixel i, j, if the picture has it
(define (dot-marker p color)
  (define-values (red green blue) (apply values color))
  (define-values (width height bytes) (values (pixels-width p) (pixels-height p) (pixels-bytes p)))
  (lambda (i j)
    (when (and (unsafe-fx<= 0 i) (unsafe-fx< i width) (unsafe-fx<= 0 j) (unsafe-fx< j height))
      (define k (unsafe-fx* 4 (unsafe-fx+ i (unsafe-fx* j width))))
      (unsafe-bytes-set! bytes k 255)
      (unsafe-bytes-set! bytes (unsafe-fx+ k 1) red)
      (unsafe-bytes-set! bytes (unsafe-fx+ k 2) green)
      (unsafe-bytes-set! bytes (unsafe-fx+ k 3) blue))))
