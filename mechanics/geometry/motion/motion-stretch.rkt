#lang racket/base
;; A stretch of a motion, followed in one chart and read in another, its home.

(require "chart-choice.rkt" "continuous-angles.rkt" "Lagrangian-in-chart.rkt"
         "../manifold-chart.rkt"
         "../../calculus/derivative.rkt"
         "../../compile/compile-function.rkt"
         "../../error/complain.rkt"
         "../../generic/describe.rkt" "../../generic/up-down.rkt"
         "../../lagrangian/coordinate-transformation.rkt" "../../lagrangian/local-tuple.rkt"
         "../../motion/trajectory.rkt"
         "../../numeric/finite-number.rkt" "../../numeric/flvector.rkt"
         "../../value/shape.rkt")

(provide (struct-out stretch) make-stretch cut-at
         stretch-chart stretch-home stretch-start
         home-state-at home-coordinates-at local-state-at stretch-nodes
         (struct-out passage) passages-to compiled-at)

;; The way from states in a chart to home: flonum code.
;; coordinates : state -> coordinates at home;  state : state -> state at home
;; fitness : flvector of a state, flvector for the chart's fitness there and its rate -> void
(struct passage (chart home coordinates state fitness) #:authentic)

;; home -> chart, state there -> passage, made once a chart
(define (passages-to home)
  (define known (make-hasheq))
  (lambda (B example)
    (hash-ref! known (coordinate-system-symbols B) (lambda () (make-passage B home example)))))

(define (make-passage B home example)
  (define fitness (fitness-code B example))
  (if (same-chart? B home)
      (passage B home coordinate values fitness)
      (passage B home
               (compiled-at (transition B home) example)
               (compiled-at (F->C (transition B home)) example)
               fitness)))

(define (fitness-code B example)
  (define (along local)
    (define-values (w rate)
      (value-and-derivative-along (chart-fitness B) (coordinate local) (velocity local)))
    (up w rate))
  (compiled-function-runner (compile-function along example)))

(define (compiled-at f example)
  (define code (compile-function f example))
  (define shape (compiled-function-value-shape code))
  (lambda (x) (flvector->structure shape (code (structure->flvector x void)))))

;; ---------------------------------------------------------------------------

;; angles : a track of the coordinates at home, or #f where the chart is home
;; end : the time where it ends, perhaps before its trajectory does;  occurrences : of events
(struct stretch (way trajectory angles end occurrences) #:authentic)

(define (stretch-chart s) (passage-chart (stretch-way s)))
(define (stretch-start s) (trajectory-start (stretch-trajectory s)))
(define (stretch-home s) (passage-home (stretch-way s)))

;; q : coordinates at home where it begins
(define (make-stretch way tr q)
  (define home (passage-home way))
  (define (q-at t) ((passage-coordinates way) (tr t)))
  (define angles
    (and (not (same-chart? home (passage-chart way)))
         (follow-angles home q-at (regular-at-home way q) (sampled-times tr) q)))
  (stretch way tr angles (trajectory-end tr) '()))

;; Are the coordinates at home more than 10⁻⁸ from where this is singular?
(define (regular-at-home way example)
  (define fitness (compiled-at (chart-fitness (passage-home way)) example))
  (lambda (q) (and (andmap finite? (scalars q)) (> (fitness q) 1e-16))))

(define (cut-at s end occurrences)
  (struct-copy stretch s [end end] [occurrences occurrences]))

;; Eight to a step
(define (sampled-times tr)
  (define steps (trajectory-steps tr))
  (cons (step-from (vector-ref steps 0))
        (for*/list ([s (in-vector steps)] [k (in-range 1 9)])
          (define-values (a b) (values (step-from s) (step-to s)))
          (if (= k 8) b (+ a (* (/ k 8) (- b a)))))))

(define (stretch-nodes s) (vector->list (track-nodes (stretch-angles s))))

;; ---------------------------------------------------------------------------
;; Reading one

;; The time may be off by rounding.
(define (local-state-at s t)
  (define tr (stretch-trajectory s))
  (define-values (a b) (values (trajectory-start tr) (trajectory-end tr)))
  (tr (if (between? a t b) t (if (between? a b t) b a))))

(define (home-coordinates-at s t)
  (if (stretch-angles s)
      (track-coordinates (stretch-angles s) t)
      (coordinate (local-state-at s t))))

;; Where home is singular, with the velocities a moment later or, at the end, before
(define (home-state-at s t)
  (define (velocities t) (velocity ((passage-state (stretch-way s)) (local-state-at s t))))
  (define (regular? v) (andmap finite? (scalars v)))
  (cond [(stretch-angles s)
         (define v (velocities t))
         (define moment (* 1e-8 (- (stretch-end s) (stretch-start s))))
         (define beside (+ t (if (<= (abs (- (stretch-end s) t)) (abs moment)) (- moment) moment)))
         (up t (home-coordinates-at s t)
             (cond [(regular? v) v]
                   [else (define near (velocities beside))
                         (if (regular? near) near (raise-singular-home s t))]))]
        [else (local-state-at s t)]))

(define (raise-singular-home s t)
  (complain 'trajectory
            (string-append "the coordinates ~a are singular where the motion is at the time ~a"
                           "\n  its point there: (trajectory-point trajectory ~a)")
            (value->text (stretch-home s)) t t))
