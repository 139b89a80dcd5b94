#lang racket/base
;; Motions drawn: one function of the state against another, or against the time.

(require "plotted-number.rkt" "draw.rkt"
         "../../generic/compare.rkt" "../../generic/wrong-argument.rkt"
         "../../motion/on-demand.rkt")

(provide plot-trajectory)

;; Points for each step of the integration, which is longer where the motion is smoother; and the
;; least and greatest number of points.
(define points-per-step 16)
(define least-points 200)
(define most-points 50000)

;; (plot-trajectory f tr y) or (plot-trajectory f tr x y), x and y functions of the state
(define-line (plot-trajectory f tr a [b #f]) who style 'curve
  (check-argument who trajectory? tr "a trajectory, such as evolve-trajectory gives")
  (for ([f (in-list (if b (list a b) (list a)))])
    (check-function-of-state who f ", such as coordinate"))
  (define x (if b (lambda (t state) (a state)) (lambda (t state) t)))
  (define y (or b a))
  (draw-curve who f style (sample-times tr)
              (lambda (t what)
                (define state (tr t))
                (values (coordinate-of who (lambda () (component "x" t)) (x t state))
                        (coordinate-of who (lambda () (component "y" t)) (y state))))))

(define (component name t) (format "~a at the time ~a" name t))

(define (sample-times tr)
  (define start (comparand (trajectory-start tr)))
  (define end (comparand (trajectory-end tr)))
  (define steps (- (length (trajectory-states tr)) 1))
  (define count (max least-points (min most-points (* points-per-step steps))))
  (for/list ([k (in-range (+ count 1))])
    (if (= k count) end (+ start (* (- end start) (/ k count 1.0))))))
