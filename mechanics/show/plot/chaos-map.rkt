#lang racket/base
;; Where orbits of a map, or motions, are chaotic: an indicator of a grid of starts, in colours.

(require racket/flonum
         racket/future
         (only-in racket/math exact-floor exact-round)
         "frame.rkt" "picture-layer.rkt" "style.rkt"
         "../../error/complain.rkt"
         "../../generic/describe.rkt" "../../generic/on-demand.rkt"
         "../../generic/printed-function.rkt" "../../generic/wrong-argument.rkt"
         "../../dynamics/map/map-of-the-plane.rkt")

(require-on-demand ["../../dynamics/map-indicator.rkt" indicator-grid]
                   ["motion-indicators.rkt" motion-indicators]
                   ["../../dynamics/chaos-indicator.rkt" check-kind]
                   ["../../dynamics/map/plane-points.rkt" part-middle])

(provide chaos-map)

;; system : a map of the plane; or, with #:state, a state derivative
;; n : steps of each orbit, or the duration of each motion
;; samples : number of starts to a side, or (list across up)
;; -> the frame
(define (chaos-map f system [n 1000] #:samples [samples 200]
                   #:state [state-at #f] #:indicator [kind 'FLI] #:tolerance [tolerance 1e-10]
                   #:jobs [jobs (processor-count)] #:checkpoint [file #f])
  (define who 'chaos-map)
  (check-open who f)
  (unless state-at
    (check-no-motion who system)
    (check-map who system)
    (check-kind who kind)
    (when file
      (complain who "a checkpoint is for motions, with #:state\n  file: ~a" file)))
  (define-values (across up) (numbers-of-samples who samples))
  (define-values (x-min x-max y-min y-max) (apply values (frame-bounds f)))
  ;; rows from above, as those of a raster
  (define-values (xs ys) (values (middles x-min x-max across) (middles y-max y-min up)))
  (define show! (growing-image who f across up (chaos-share kind n (not state-at))))
  (show!
   (if state-at
       (motion-indicators who system state-at xs ys n #:indicator kind #:grown show!
                          #:tolerance tolerance #:jobs jobs #:checkpoint file)
       (indicator-grid who system xs ys n kind #:grown show!)))
  f)

;; At most so many pictures are made while an image grows.
(define most-pictures 50)

;; -> a procedure that shows the indicators so far, which it is called with after each row; all of
;; them where it was called so often
(define (growing-image who f across up share)
  (define style (make-style who 'image 0 0 'solid #f))
  (define rows (quotient (+ up most-pictures -1) most-pictures))
  (define calls 0)
  (define last #f)
  (define (exchange! image)
    (define layers (frame-layers f))
    (replace-layers! who f
                     (if last
                         (for/list ([l (in-list layers)]) (if (eq? l last) image l))
                         (cons image layers)))
    (set! last image))
  (lambda (indicators)
    (define whole? (for/and ([x (in-flvector indicators)]) (not (eqv? x -inf.0))))
    (set! calls (+ calls 1))
    (when (or whole? (eqv? 0 (modulo calls rows)))
      (exchange! (layer style (raster across up (colored indicators share)))))))

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

;; share : indicator -> 0 for regular, 1 for chaotic; -inf.0 is not known yet, and transparent
(define (colored indicators share)
  (define bytes (make-bytes (* 4 (flvector-length indicators)) 255))
  (for ([value (in-flvector indicators)] [k (in-naturals)])
    (if (eqv? value -inf.0)
        (bytes-set! bytes (* 4 k) 0)
        (for ([c (in-list (color-between (share value)))] [i (in-naturals 1)])
          (bytes-set! bytes (+ (* 4 k) i) c))))
  bytes)

;; FLI is about log n for a regular orbit; three times that is chaos beyond doubt.  MEGNO is 2 for
;; a regular motion, SALI falls to nothing for a chaotic one; of a map of the plane it is about 1/n²
;; for a regular orbit.
(define (chaos-share kind n map?)
  (define aligned (if map? (* -2.0 (log n 10)) 0.0))
  (define regular (log (max n 2) 10))
  (case kind
    [(FLI) (lambda (x) (/ (- x (* 0.5 regular)) (* 2.5 regular)))]
    [(MEGNO) (lambda (x) (/ (- x 1.0) 5.0))]
    [(SALI) (lambda (x) (if (= x 0) 1.0 (/ (- (log x 10) aligned) -8.0)))]))

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
