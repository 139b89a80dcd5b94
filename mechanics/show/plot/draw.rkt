#lang racket/base
;; Drawing in frames (SICM 1.4, p. 23; 1.7, p. 76; 4.3, p. 308).

(require racket/flonum
         "plotted-number.rkt" "frame.rkt" "points.rkt" "style.rkt" "view.rkt"
         "../../error/complain.rkt" (only-in "../../error/progress.rkt" call-counting)
         "../../generic/define-plain.rkt" "../../generic/describe.rkt"
         "../../generic/wrong-argument.rkt")

(provide plot-point plot-line plot-function plot-parametric plot-parametric-fill
         ;; for the curves of motions
         define-line draw-curve)

(define-plain (plot-point f x y #:color [color 0] #:size [size #f] #:label [label #f])
  (define who 'plot-point)
  (check-frame who f)
  (add-dot! who f (make-style who 'points color size 'solid label)
            (coordinate-of who "x" x)
            (coordinate-of who "y" y)))

;; A procedure that draws lines in the frame f; its keywords, and its name, are in the style.
(define-syntax-rule (define-line (name f argument ...) who style kind body ...)
  (define-plain (name f argument ...
                      #:color [color 0] #:width [width 1] #:style [dash 'solid]
                      #:label [label #f])
    (define who 'name)
    (check-frame who f)
    (define style (make-style who kind color width dash label))
    body ...))

(define-line (plot-line f x1 y1 x2 y2) who style 'lines
  (add-line! who f style
             (coordinate-of who "x1" x1) (coordinate-of who "y1" y1)
             (coordinate-of who "x2" x2) (coordinate-of who "y2" y2)))

(define-line (plot-function f function from to [step #f]) who style 'curve
  (check-function who function 1)
  (draw-curve who f style (abscissas who f from to step)
              (lambda (x what) (values x (coordinate-of who what (function x))))))

(define-line (plot-parametric f curve from to [step #f]) who style 'curve
  (check-function who curve 1)
  (draw-curve who f style (range who from to step)
              (lambda (t what) (plane-point who what (curve t)))))

;; On a logarithmic axis all of them without a step have one ratio.
(define (abscissas who f from to step)
  (if (and (not step) (eq? 'log (car (view-scales (frame-view f)))))
      (map exp (range who (log (positive who from)) (log (positive who to)) #f))
      (range who from to step)))

(define (positive who x)
  (define number (check-number who "an end" x))
  (unless (> number 0)
    (complain-of-argument who "a positive end, for a logarithmic axis," x))
  number)

;; Without a step there are 500 steps.
(define (range who from to step)
  (define a (check-number who "the start" from))
  (define b (check-number who "the end" to))
  (parameters who a b
              (cond [step (check-number who "the step" step)]
                    [(= a b) 1.0]
                    [else (/ (abs (- b a)) 500)])))

;; at : takes a number and a thunk of its description, returns two flonums.  All points are computed
;; before the first is drawn.
(define (draw-curve who f style numbers at)
  (check-open who f)
  (define points (make-points))
  (call-counting
   who "points" (length numbers)
   (lambda (count!)
     (for ([t (in-list numbers)] [k (in-naturals)])
       (count! k)
       (define-values (x y) (at t (lambda () (format "the value at ~a" t))))
       (add-point! points x y))))
  (add-layer! who f style points))

;; ---------------------------------------------------------------------------

;; Points of a curve, as close as `near?` demands: the gap between two that are not
;; near is filled in by halving, until there is no number between.
(define-plain (plot-parametric-fill f curve from to [near? (near-in f)]
                                    #:color [color 0] #:size [size 1.5] #:label [label #f])
  (define who 'plot-parametric-fill)
  (check-open who f)
  (check-function who curve 1)
  (check-function who near? 2)
  (define style (make-style who 'points color size 'solid label))
  (define-values (a b)
    (values (check-number who "the start" from) (check-number who "the end" to)))
  (call-counting who "points" #f
                 (lambda (count!) (draw-near who f style curve near? a b count!))))

(define (draw-near who f style curve near? a b count!)
  (define drawn 0)
  (define (at t)
    (define point (curve t))
    (define-values (x y) (plane-point who (lambda () (format "the value at ~a" t)) point))
    (set! drawn (+ drawn 1))
    (count! drawn)
    (when (> drawn most-points) (raise-never-near who near?))
    (add-dot! who f style x y)
    (and (rational? x) (rational? y) point))
  (define (together? p q) (if (and p q) (near? p q) (eq? p q)))    ; nothing is near nothing
  (let fill ([a a] [at-a (at a)] [b b] [at-b (at b)])
    (define m (fl* 0.5 (fl+ a b)))
    (unless (or (fl= m a) (fl= m b))
      (define at-m (at m))
      (unless (and (together? at-a at-m) (together? at-m at-b))
        (fill a at-a m at-m)
        (fill m at-m b at-b)))))

;; A nearness that no two points have asks for more points, which would fill the memory.
(define most-points 1000000)

(define (raise-never-near who near?)
  (complain who
            (string-append "the curve has more than ~a points before all neighbours are near"
                           "\n  near: ~a\n  (plane-near? 0.01) takes points for near that are less "
                           "than 0.01 apart")
            most-points (value->text near?)))

;; Are two points closer than about a pixel?
(define (near-in f)
  (check-frame 'plot-parametric-fill f)
  (define-values (x-min x-max y-min y-max) (apply values (frame-bounds f)))
  (define dx (/ (- x-max x-min) 300))
  (define dy (/ (- y-max y-min) 300))
  (define (point p) (plane-point 'plot-parametric-fill "a point" p))
  (lambda (p q)
    (define-values (x1 y1) (point p))
    (define-values (x2 y2) (point q))
    (and (<= (abs (- x1 x2)) dx) (<= (abs (- y1 y2)) dy))))
