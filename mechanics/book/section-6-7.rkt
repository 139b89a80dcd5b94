#lang racket/base
;; SICM 6.7, Projects (pp. 453–456), in the reader's own language.

(require mechanics
         (only-in "section-3-6.rkt" find-next-crossing section->state)
         "../generic/on-demand.rkt")

(require-on-demand ["../plot.rkt" default-collector plot-point])

(provide HH-collector)

;; The section of Hénon and Heiles, of a motion that is followed in steps of dt by
;; (advance state dt), a map of states such as a symplectic one: n crossings, drawn in win
;; (p. 456).  Between crossings the states at the ends of steps are handed on, so that the motion
;; keeps its rhythm; from points it begins at states of energy E.
(define ((HH-collector win advance E dt sec-eps n) x y done fail)
  (define (monitor crossing beyond)
    (plot-point win (ref (coordinate crossing) 1) (ref (momentum crossing) 1)))
  (define (next-crossing crossing beyond return fail)
    (find-next-crossing beyond advance dt sec-eps return))
  (define collect (default-collector monitor next-crossing n))
  (cond [(and (up? x) (up? y)) (collect x y done fail)]
        [(section->state E x y) => (lambda (start) (collect start start done fail))]
        [else (fail)]))
