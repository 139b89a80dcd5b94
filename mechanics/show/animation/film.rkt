#lang racket/base
;; A film: the motion that an animation shows, its drawing, and when its pictures are taken.

(require "../../generic/compare.rkt" "../../generic/wrong-argument.rkt"
         "../../error/complain.rkt"
         "../plot/plotted-number.rkt")

(provide (struct-out film) film-state
         (struct-out schedule) make-schedule
         schedule-span schedule-seconds schedule-count schedule-time
         time-at-share check-time-within)

;; motion : time -> state; drawing : state -> pict
;; trail : state -> points, or #f; trail-time : its duration on the picture, or #f for all of it
;; plane : phase-plane or #f; title : string
(struct film (motion drawing schedule trail trail-time plane title))

(define (film-state f t) ((film-motion f) t))

;; ---------------------------------------------------------------------------

;; from, to : times as they were given, and `start` and `end` as flonums, which may be in
;; either order; speed : units of time in a second; rate : pictures in a second
(struct schedule (from to start end speed rate))

(define (make-schedule who from to speed rate)
  (define start (check-number who "the first time" from))
  (define end (check-number who "the last time" to))
  (when (= start end)
    (complain-showing who "the animation would take no time" "from" from "to" to))
  (unless (> (check-number who "the speed" speed) 0.0)
    (complain-of-argument who "a positive speed, in units of time per second" speed))
  (unless (and (real? rate) (<= 1 rate 100))
    (complain-of-argument who "from 1 to 100 frames per second" rate))
  (schedule from to start end (real->double-flonum (comparand speed)) rate))

(define (schedule-span s) (- (schedule-end s) (schedule-start s)))
(define (schedule-seconds s) (/ (abs (schedule-span s)) (schedule-speed s)))

;; The number of pictures, the first and the last included.
(define (schedule-count s)
  (+ 1 (max 1 (inexact->exact (ceiling (- (* (schedule-seconds s) (schedule-rate s)) 1e-6))))))

;; The time of picture i; the first and the last are those that were given.
(define (schedule-time s i)
  (time-at-share s (/ i (- (schedule-count s) 1.0))))

;; share : of the whole time, from 0 to 1
(define (time-at-share s share)
  (cond [(<= share 0.0) (schedule-from s)]
        [(>= share 1.0) (schedule-to s)]
        [else (+ (schedule-start s) (* (schedule-span s) share))]))

;; -> t if it is a time within the schedule; else complains
(define (check-time-within who s t)
  (define x (check-number who "the time" t))
  (define-values (low high)
    (values (min (schedule-start s) (schedule-end s)) (max (schedule-start s) (schedule-end s))))
  (unless (<= low x high)
    (complain-showing who "the time is outside the animation"
                      "time" t
                      "from" (schedule-from s)
                      "to" (schedule-to s)))
  t)
