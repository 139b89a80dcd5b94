#lang racket/base
;; Where orbits of a map are chaotic: the fast Lyapunov indicator of a grid of starts, in colours.

(require racket/flonum
         (only-in racket/math exact-floor exact-round)
         "frame.rkt" "picture-layer.rkt" "style.rkt"
         "../../generic/on-demand.rkt" "../../generic/wrong-argument.rkt"
         "../../dynamics/map/map-of-the-plane.rkt")

(require-on-demand ["../../dynamics/fast-Lyapunov-indicator.rkt" indicator-grid]
         ["../../dynamics/map/plane-points.rkt" part-middle])

(provide chaos-map)

;; n : steps of each orbit; samples : number of starts to a side, or (list across up)
;; -> the frame
(define (chaos-map f map [n 1000] #:samples [samples 200])
  (define who 'chaos-map)
  (check-open who f)
  (check-map who map)
  (define-values (across up) (numbers-of-samples who samples))
  (define-values (x-min x-max y-min y-max) (apply values (frame-bounds f)))
  ;; rows from above, as those of a raster
  (define indicators
    (indicator-grid who map (middles x-min x-max across) (middles y-max y-min up) n))
  (add-layer! who f (make-style who 'image 0 0 'solid #f)
              (raster across up (colored indicators n)))
  f)

(define (numbers-of-samples who samples)
  (define (count? k) (and (exact-integer? k) (<= 1 k 5000)))
  (cond [(count? samples) (values samples samples)]
        [(and (list? samples) (= (length samples) 2) (andmap count? samples))
         (values (car samples) (cadr samples))]
        [else
         (complain-of-argument
          who "how many starts to a side, from 1 to 5000, or a list of two such numbers" samples)]))

;; -> the middles of n equal parts of the interval
(define (middles from to n)
  (for/flvector #:length n ([k (in-range n)]) (part-middle from to k n)))

;; ---------------------------------------------------------------------------
;; Colours

;; The indicator of a regular orbit is about log n; three times that is chaos beyond doubt.
(define (colored indicators n)
  (define regular (log (max n 2) 10))
  (define bytes (make-bytes (* 4 (flvector-length indicators)) 255))
  (for ([value (in-flvector indicators)] [k (in-naturals)])
    (define color (color-between (/ (- value (* 0.5 regular)) (* 2.5 regular))))
    (for ([c (in-list color)] [i (in-naturals 1)]) (bytes-set! bytes (+ (* 4 k) i) c)))
  bytes)

;; From dark blue, regular, by red to yellow, chaotic; grey where the orbit ends.
(define stops '((20 20 90) (60 60 160) (200 60 70) (250 160 50) (255 240 150)))
(define nowhere '(190 190 190))

(define (color-between share)
  (cond [(not (= share share)) nowhere]
        [else
         (define at (* (max 0.0 (min 1.0 share)) (- (length stops) 1)))
         (define k (min (- (length stops) 2) (exact-floor at)))
         (for/list ([a (in-list (list-ref stops k))] [b (in-list (list-ref stops (+ k 1)))])
           (exact-round (+ a (* (- at k) (- b a)))))]))
