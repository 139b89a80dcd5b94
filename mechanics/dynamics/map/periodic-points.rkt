#lang racket/base
;; Periodic points of a map of the plane in a rectangle: those that Newton's method leads to from
;; the nodes of a grid.  What converges slowly, or to outside, is left out; so a finer grid may
;; find more.

(require "fixed-points.rkt" "map-of-the-plane.rkt" "plane-points.rkt"
         "../../error/failure.rkt" "../../error/refusal.rkt"
         "../../generic/compare.rkt" "../../generic/define-plain.rkt"
         "../../generic/up-down.rkt" "../../generic/wrong-argument.rkt"
         "../../numeric/constants.rkt" "../../numeric/finite-number.rkt")

(provide periodic-points)

;; region : (list x-min x-max y-min y-max); -> fixed points of period n and no lesser one
(define-plain (periodic-points map n region #:grid [grid '(20 20)])
  (define who 'periodic-points)
  (check-map who map n region)
  (check-argument who exact-positive-integer? n "a period, a positive integer")
  (define-values (x-min x-max y-min y-max) (checked-region who region))
  (check-grid who grid)
  (define near
    (for*/list ([i (in-range (car grid))] [j (in-range (cadr grid))])
      (point-near who map n (up (part-middle x-min x-max i (car grid))
                                (part-middle y-min y-max j (cadr grid))))))
  (check-some-map near)
  (define all
    (for/fold ([found '()]) ([p (in-list near)])
      (if (and (fixed-point? p) (inside? p x-min x-max y-min y-max)
               (not (member p found same-point?))
               (not (lesser-period? map p n)))
          (cons p found)
          found)))
  (sort all before?))

;; -> a fixed point, or the refusal of the map or of Newton's method
(define (point-near who map n guess)
  (with-handlers ([refusal? values])
    (fixed-point-near who map guess n 1e-13 30)))

;; A map that fails wherever one starts is at fault, not the starts.
(define (check-some-map near)
  (when (for/and ([p (in-list near)]) (and (exn:fail:contract? p) (not (no-value? p))))
    (raise (car near))))

;; Orders points by abscissas, those with equal abscissas by ordinates.
(define (before? p q)
  (define-values (a b) (values (fixed-point-coordinates p) (fixed-point-coordinates q)))
  (or (< (abscissa a) (- (abscissa b) 1e-9))
      (and (<= (abs (- (abscissa a) (abscissa b))) 1e-9) (< (ordinate a) (ordinate b)))))

;; Points on an edge are inside; of two edges a turn apart, only the first counts.
(define (inside? p x-min x-max y-min y-max)
  (define at (fixed-point-coordinates p))
  (define (within? low z high)
    (define whole-turn? (>= (- high low) (- :2pi 1e-9)))
    (<= (- low 1e-9) z (if whole-turn? (- high 1e-9) (+ high 1e-9))))
  (and (within? x-min (abscissa at) x-max) (within? y-min (ordinate at) y-max)))

(define (same-point? p q) (near? p (fixed-point-coordinates q)))

(define (near? p at)
  ((nearness-by-angles (fixed-point-angles p) 1e-7) (fixed-point-coordinates p) at))

(define (lesser-period? map p n)
  (let loop ([k 1] [at (fixed-point-coordinates p)])
    (define image (and (<= k (quotient n 2)) (image-once map at)))
    (and image
         (or (and (zero? (remainder n k)) (near? p image))
             (loop (+ k 1) image)))))

(define (image-once map at)
  (image-of 'periodic-points map (abscissa at) (ordinate at) make-point))

(define (checked-region who region)
  (define bounds (and (list? region) (for/list ([x (in-list region)]) (comparand x))))
  (unless (and bounds (= (length bounds) 4) (andmap finite? bounds)
               (< (car bounds) (cadr bounds)) (< (caddr bounds) (cadddr bounds)))
    (complain-of-argument who "a region, (list x-min x-max y-min y-max)" region))
  (apply values bounds))
