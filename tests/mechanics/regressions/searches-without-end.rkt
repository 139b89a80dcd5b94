#lang racket/base
;; A tolerance of 0 was never met: a section was refined, and a curve filled with points, for ever.

(require (except-in mechanics time) mechanics/book mechanics/plot
         "../support/checks.rkt" "../support/close.rkt" "../support/messages.rkt")

(define advance (make-advance (state-advancer HHsysder) 1e-12))
(define start (section->state 1/8 0.1 0))

(says
 [(find-next-crossing start advance 0 1e-10 list)
  "find-next-crossing: expected a positive dt\n  given: the number 0"]
 [(find-next-crossing start advance -0.1 1e-10 list)
  "find-next-crossing: expected a positive dt\n  given: the number -0.1"]
 [(find-next-crossing start advance 0.1 0 list)
  "find-next-crossing: expected a positive sec-eps\n  given: the number 0"]
 [(refine-crossing -1 advance start)
  "refine-crossing: expected a positive sec-eps\n  given: the number -1"]
 [(refine-crossing +nan.0 advance start)
  "refine-crossing: expected a sec-eps that is finite\n  given: the number +nan.0"]
 [(plot-parametric-fill (frame 0 1 0 1) (lambda (t) (up t t)) 0 1 (plane-near? 1e-300))
  "plot-parametric-fill: the curve has more than 1000000 points before all neighbours are near\n"
  "  near: plane-near?\n  (plane-near? 0.01) takes points for near that are less than 0.01 apart"])

;; Nearer than rounding is as near as can be; by Poincare-map the same place.
(test-case "a crossing to less than rounding"
  (define crossing (find-next-crossing start advance 0.1 1e-300 (lambda (at beyond) at)))
  (define same
    ((Poincare-map (HHsysder) (event (lambda (s) (ref (coordinate s) 0)) #:direction 'rising))
     start))
  (check-close (ref (coordinate crossing) 0) 0 1e-14)
  (check-close (ref (coordinate crossing) 1) (ref (coordinate same) 1) 1e-9))
