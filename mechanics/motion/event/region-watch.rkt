#lang racket/base
;; Watching whether a motion stays in a region, beside its events: roughly, at little cost.
;;
;; The region is where a positive function, the fitness of a chart, is not below a limit.  Along a
;; step it is looked at in a few places, and between two of them in more where its rate of change
;; says that it may change by much; so a step of any length finds the way out.

(require racket/flonum
         "event.rkt")

(provide (struct-out region) watch-region)

;; look : flvector of a state, whose first scalar is the time; flvector of 2, where it puts value and
;;        rate of change of the function -> void
;; limit : its least value inside;  boundary : the event that occurs where it falls below
;; whole : the trajectory so far -> what an exception carries
(struct region (look limit boundary whole) #:authentic)

;; At a place within a step
(struct view (place time value rate) #:authentic)

;; watch : of event-watch.rkt, of states of n scalars
;; -> interpolant, times where the step begins and ends -> its crossings, that of the boundary too
(define (watch-region r watch n)
  (define point (make-flvector n))
  (define seen (make-flvector 2))
  (define last-view #f)
  (define safe 0.0)                     ; for so long after it there is no need to look
  (define ((look-by at) place)
    (at place point)
    ((region-look r) point seen)
    (view place (flvector-ref point 0) (flvector-ref seen 0) (flvector-ref seen 1)))
  ;; One look, at the end, where the step is no longer than what was thought to be safe
  (define (plainly-inside? look from to)
    (and last-view
         (fl<= (flabs (fl- to from)) (flabs safe))
         (let ([end (look 1.0)])
           (and (fl>= (view-value end) (region-limit r))
                (not (rough? last-view end))
                (note! last-view end)))))
  (define (note! a b)
    (set! safe (safe-time a b (region-limit r)))
    (set! last-view b)
    #t)
  (lambda (at from to)
    (define found (watch at))
    (define look (look-by at))
    (cond [(and last-view (fl<= (flabs (fl- to (view-time last-view))) (flabs safe))) found]
          [(plainly-inside? look from to) found]
          [else
           (define a (look 0.0))
           (define-values (out end) (way-out look (region-limit r) a))
           (when end (note! a end))
           (if out
               (sort (cons (crossing out (region-boundary r) #f) found) < #:key crossing-at)
               found)])))

;; For which time after the view b, that follows a, the function stays above the limit: with a rate
;; that goes on to change as it did, and for no more than some such steps
(define (safe-time a b limit)
  (define step (fl- (view-time b) (view-time a)))
  (define bend (flabs (fl/ (fl- (view-rate b) (view-rate a)) step)))
  (define far (fl* 0.7 (fl- (view-value b) limit)))
  (define safe (fl/ far (fl+ (flabs (view-rate b)) (flsqrt (fl* far bend)))))
  (fl* step (flmin 16.0 (fl/ safe (flabs step)))))

;; Not the middle, lest a motion goes round once to each.
(define places '(0.53 1.0))

;; a : where the step begins -> the first place outside, or #f; and the view of its end
(define (way-out look limit a)
  (let loop ([a a] [places places])
    (cond [(null? places) (values #f a)]
          [else
           (define b (look (car places)))
           (define out (way-out-between look limit a b most-halvings))
           (if out (values out #f) (loop b (cdr places)))])))

(define most-halvings 12)

(define (way-out-between look limit a b halvings)
  (cond [(and (rough? a b) (> halvings 0))
         (define middle (look (fl* 0.5 (fl+ (view-place a) (view-place b)))))
         (or (way-out-between look limit a middle (- halvings 1))
             (way-out-between look limit middle b (- halvings 1)))]
        [(fl>= (view-value b) limit) #f]
        [else (view-place b)]))

;; May the function change by half of itself between the two?
(define (rough? a b)
  (define rate (flmax (flabs (view-rate a)) (flabs (view-rate b))))
  (fl> (fl* rate (flabs (fl- (view-time b) (view-time a))))
       (fl* 0.5 (flmin (view-value a) (view-value b)))))
