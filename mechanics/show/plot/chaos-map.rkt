#lang racket/base
;; Where orbits of a map, or motions, are chaotic: an indicator of a grid of starts, in colours.

(require racket/flonum
         racket/future
         "color-map.rkt" "frame.rkt" "picture-layer.rkt" "style.rkt"
         "../../error/complain.rkt"
         "../../generic/describe.rkt" "../../generic/on-demand.rkt"
         "../../generic/printed-function.rkt" "../../generic/wrong-argument.rkt"
         "../../dynamics/map/map-of-the-plane.rkt")

(require-on-demand ["../../dynamics/map-indicator.rkt" indicator-grid]
                   ["motion-indicators.rkt" motion-indicators]
                   ["../../dynamics/chaos-indicator.rkt" check-kind check-no-tolerance]
                   ["../../dynamics/map/plane-points.rkt" part-middle])

(provide chaos-map)

;; system : a map of the plane; or, with #:state, a state derivative
;; n : steps of each orbit, or the duration of each motion
;; samples : number of starts to a side, or (list across up)
;; -> the frame
(define (chaos-map f system [n 1000] #:samples [samples 200]
                   #:state [state-at #f] #:indicator [kind 'FLI] #:tolerance [tolerance #f]
                   #:jobs [jobs (processor-count)] #:checkpoint [file #f]
                   #:colors [colors 'dusk] #:bar? [bar? #f])
  (define who 'chaos-map)
  (check-plain who f)
  (unless state-at
    (check-no-motion who system)
    (check-map who system)
    (check-kind who kind)
    (check-no-tolerance who tolerance)
    (when file
      (complain who "a checkpoint is for motions, with #:state\n  file: ~a" file)))
  (check-argument who (lambda (c) (memq c color-map-names)) colors
                  (format "a colour map, one of ~a" color-map-names))
  (define-values (across up) (numbers-of-samples who samples))
  (define-values (x-min x-max y-min y-max) (apply values (frame-bounds f)))
  ;; rows from above, as those of a raster
  (define-values (xs ys) (values (middles x-min x-max across) (middles y-max y-min up)))
  (define bar (indicator-bar kind n (not state-at) colors))
  (define (image indicators)
    (raster across up (colored indicators bar (shown-as kind)) (and bar? bar)))
  (define-values (show! grown) (growing-image who f up image))
  (show!
   (if state-at
       (motion-indicators who system state-at xs ys n #:indicator kind #:grown grown
                          #:tolerance tolerance #:jobs jobs #:checkpoint file)
       (indicator-grid who system xs ys n kind #:grown grown)))
  f)

;; At most so many pictures are made while an image grows.
(define most-pictures 50)

;; image : indicators -> raster
;; -> a procedure that shows indicators; and one that is called with them after each row, and shows
;; them now and then
(define (growing-image who f up image)
  (define style (make-style who 'image 0 0 'solid #f))
  (define rows (quotient (+ up most-pictures -1) most-pictures))
  (define calls 0)
  (define shown #f)
  (define (show! indicators)
    (define new (layer style (image indicators)))
    (define layers (frame-layers f))
    (replace-layers! who f (if (memq shown layers)
                               (for/list ([l (in-list layers)]) (if (eq? l shown) new l))
                               (cons new layers)))
    (set! shown new))
  (values show!
          (lambda (indicators)
            (set! calls (+ calls 1))
            (when (eqv? 0 (modulo calls rows)) (show! indicators)))))

(define (check-no-motion who system)
  (when (memq (made-by system) '(stroboscopic-map Poincare-map))
    (complain who
              (string-append "motions are followed by their state derivative, with their variations"
                             "\n  given: ~a\n  (chaos-map frame derivative duration "
                             "#:state (lambda (q p) (up 0 q p)))")
              (value->text system))))

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

;; shown : indicator -> number on the bar.  An indicator not known yet, -inf.0, is transparent.
(define (colored indicators bar shown)
  (define bytes (make-bytes (* 4 (flvector-length indicators)) 255))
  (define-values (from to) (values (color-bar-from bar) (color-bar-to bar)))
  (define (color x) (color-between (color-bar-colors bar) (/ (- (shown x) from) (- to from))))
  (for ([value (in-flvector indicators)] [k (in-naturals)])
    (if (eqv? value -inf.0)
        (bytes-set! bytes (* 4 k) 0)
        (for ([c (in-list (color value))] [i (in-naturals 1)])
          (bytes-set! bytes (+ (* 4 k) i) c))))
  bytes)

;; Colors go from regular to chaotic.  FLI is about log n for a regular orbit; three
;; times that is chaos beyond doubt.  MEGNO is 2 for a regular motion.  SALI, shown by its
;; logarithm, falls to nothing for a chaotic one; of a map of the plane it is about 1/n² for a
;; regular orbit.
(define (indicator-bar kind n map? colors)
  (define regular (log (max n 2) 10))
  (case kind
    [(FLI) (color-bar colors (* 0.5 regular) (* 3.0 regular) "FLI")]
    [(MEGNO) (color-bar colors 1.0 6.0 "MEGNO")]
    [(SALI) (let ([from (if map? (* -2.0 regular) 0.0)])
              (color-bar colors from (- from 8.0) "log SALI"))]))

(define (shown-as kind)
  (if (eq? kind 'SALI) (lambda (x) (if (= x 0.0) -20.0 (log x 10))) values))
