#lang racket/base
;; Branches as diagrams: a function of the state over the parameter, solid where the equilibria or
;; orbits are stable and dashed where they are not, with dots at special points.

(require "frame.rkt" "plotted-number.rkt" "points.rkt" "style.rkt"
         "../../dynamics/on-demand.rkt"
         "../../generic/define-plain.rkt" "../../generic/wrong-argument.rkt")

(provide plot-branch)

(define-plain (plot-branch f b ordinate #:color [color 0] #:width [width 1] #:label [label #f])
  (define who 'plot-branch)
  (check-open who f)
  (check-argument who branch? b "a branch, such as continue-equilibrium gives")
  (check-function-of-state who ordinate ", such as coordinate")
  (define (place parameter state)
    (cons parameter
          (coordinate-of who (lambda () (format "the value at the parameter ~a" parameter))
                         (ordinate state))))
  (define places (map place (branch-parameters b) (branch-states b)))
  (define pieces (alike places (branch-stabilities b)))
  (for ([piece (in-list pieces)] [k (in-naturals)])
    (define dash (if (car piece) 'solid 'short-dash))
    (add-layer! who f (make-style who 'curve color width dash (and (eqv? k 0) label))
                (points-of (cdr piece))))
  (for ([s (in-list (branch-special-points b))])
    (define p (place (special-point-parameter s) (special-point-state s)))
    (add-dot! who f (make-style who 'points color 5 'solid #f) (car p) (cdr p)))
  f)

(define (points-of places)
  (define points (make-points))
  (for ([p (in-list places)]) (add-point! points (car p) (cdr p)))
  points)

;; -> pieces of neighbouring places that are alike stable, (cons stable? places); each piece goes on
;; to the first place of the next
(define (alike places stabilities)
  (let loop ([places places] [stabilities stabilities] [piece '()] [pieces '()])
    (define stable? (car stabilities))
    (define so-far (cons (car places) piece))
    (define (ended) (cons (cons stable? (reverse so-far)) pieces))
    (cond [(null? (cdr places)) (reverse (ended))]
          [(eq? stable? (cadr stabilities)) (loop (cdr places) (cdr stabilities) so-far pieces)]
          [else
           (define last (cons (cons stable? (reverse (cons (cadr places) so-far))) pieces))
           (loop (cdr places) (cdr stabilities) '() last)])))
