#lang racket/base
;; Pictures of where orbits are chaotic.

(require mechanics
         mechanics/book
         mechanics/plot
         (only-in mechanics/show/plot/frame frame-now)
         (only-in mechanics/show/plot/picture-layer
                  layer-data raster-bytes raster-height raster-width)
         racket/serialize
         "../../support/checks.rkt" "../../support/messages.rkt")

(define (section) (frame 0 :2pi 0 :2pi))

;; Row and column, from above on the left -> three bytes
(define (color-at f row column)
  (define r (layer-data (car (frame-now f))))
  (define k (* 4 (+ column (* row (raster-width r)))))
  (for/list ([i '(1 2 3)]) (bytes-ref (raster-bytes r) (+ k i))))

(define (blue? c) (> (caddr c) (car c)))

(test-case "islands are blue and the sea is yellow; rows begin above"
  (define win (section))
  (check-eq? (chaos-map win (standard-map 1.0) 300 #:samples '(12 16)) win)
  (define r (layer-data (car (frame-now win))))
  (check-equal? (list (raster-width r) (raster-height r)) '(12 16))
  (check-true (blue? (color-at win 13 5)))             ; (2.9, 1.0)
  (check-false (blue? (color-at win 15 0)))            ; (0.3, 0.2)
  (check-equal? (format "~a" win)
                (string-append "(frame x from 0.0 to 6.283185307179586, "
                               "y from 0.0 to 6.283185307179586: 1 image)")))

(test-case "where an orbit ends it is grey; what is drawn afterwards is there, too"
  (define win (section))
  (define (falls x y return fail) (if (> y 3) (return x y) (fail)))
  (chaos-map win falls 10 #:samples 2)
  (check-equal? (color-at win 1 0) '(190 190 190))
  (check-true (blue? (color-at win 0 0)))
  (plot-point win 1 1)
  (check-equal? (length (frame-points win)) 1))

(test-case "an image is kept with its frame"
  (define win (section))
  (chaos-map win (standard-map 1.0) 50 #:samples 4)
  (define again (deserialize (serialize win)))
  (check-equal? (color-at again 1 2) (color-at win 1 2)))

(define decades (frame 1 10 0 1 #:x-scale 'log))
(says
 [(frame 0 1 0 1 #:y-scale 'log)
  "frame: a logarithmic axis begins above 0\n  least y: 0"]
 [(frame 0 1 0 1 #:x-scale 'ln)
  "frame: expected a scale, 'linear or 'log\n  given: the symbol ln"]
 [(plot-function decades sin -1 1)
  "plot-function: expected a positive end, for a logarithmic axis,\n  given: the number -1"]
 [(plot-contours decades (lambda (x y) x) 1)
  "plot-contours: this is drawn on plain axes; the frame has logarithmic ones\n"
  "  frame: (frame x from 1.0 to 10.0, y from 0.0 to 1.0: empty)"]
 [(chaos-map (section) (standard-map 1.0) 5 #:colors 'jet)
  "chaos-map: expected a colour map, one of (dusk viridis cividis plasma grey)\n"
  "  given: the symbol jet"])

(says
 [(chaos-map (section) (standard-map 1.0) 100 #:samples 0)
  "chaos-map: expected "
  "how many starts to a side, from 1 to 5000, or a list of two such numbers\n"
  "  given: the number 0"]
 [(chaos-map 3 (standard-map 1.0))
  "chaos-map: expected a frame, such as (frame 0 1 -1 1)\n  given: the number 3"])
