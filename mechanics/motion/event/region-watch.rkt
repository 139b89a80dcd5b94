#lang racket/base
;; Watching whether a motion stays in a region, beside its events: roughly, at little cost.
;;
;; The region is where a positive function, the fitness of a chart, is not below a limit.  Along a
;; step it is looked at in a few places, and between two of them in more where its rate of change
;; says that it may change by much; so a step of any length finds the way out.

(require racket/flonum
         "event.rkt")

(provide (struct-out region) watch-region)

;; look : flvector of a state, whose first scalar is the time; flvector of 2, where it puts the
;;        value and the rate of change of the function -> void
;; limit : its least value inside;  boundary : the event that occurs where it falls below
;; whole : the trajectory so far -> the value that an exception carries
(struct region (look limit boundary whole) #:authentic)

;; At a place within a step
(struct view (place time value rate) #:authentic)

;; A watch in the course of a motion of states of n scalars.  point, seen : room for a state, and
;; for the value there;  last-view : #f at first;  safe : for so long after that there is no need
;; to look
(struct guard (region point seen [last-view #:mutable] [safe #:mutable]) #:authentic)

;; watch : of event-watch.rkt
;; -> interpolant, times where the step begins and ends -> its crossings, that of the boundary too
(define (watch-region r watch n)
  (define g (guard r (make-flvector n) (make-flvector 2) #f 0.0))
  (lambda (at from to)
    (define found (watch at))
    (define out (and (not (safe-until? g to)) (leaving g at from to)))
    (if out
        (sort (cons (crossing out (region-boundary r) #f) found) < #:key crossing-at)
        found)))

(define (safe-until? g to)
  (define seen (guard-last-view g))
  (and seen (fl<= (flabs (fl- to (view-time seen))) (flabs (guard-safe g)))))

;; -> the first place of the step that is outside, or #f
(define (leaving g at from to)
  (define limit (region-limit (guard-region g)))
  (define (look place) (look-at g at place))
  (cond [(and (guard-last-view g) (fl<= (flabs (fl- to from)) (flabs (guard-safe g)))
              (plainly-inside? g (look 1.0) (fl- to from) limit))
         #f]
        [else
         (define a (look 0.0))
         (define-values (out end) (way-out look limit a))
         (if (and end (not (rough? a end)))
             (note! g a end (fl- to from))
             (set-guard-last-view! g #f))
         out]))

(define (look-at g at place)
  (define-values (point seen) (values (guard-point g) (guard-seen g)))
  (at place point)
  ((region-look (guard-region g)) point seen)
  (view place (flvector-ref point 0) (flvector-ref seen 0) (flvector-ref seen 1)))

;; Enough where a step is no longer than the time thought to be safe: one look, at its end
(define (plainly-inside? g end step limit)
  (define before (guard-last-view g))
  (and (fl>= (view-value end) limit) (note! g before end step)))

(define (note! g a b step)
  (set-guard-safe! g (safe-time a b step (region-limit (guard-region g))))
  (set-guard-last-view! g b)
  #t)

;; For which time after the view b, that follows a, the function stays above the limit: with a rate
;; that falls four times as fast as it changed between the two, and for no more than three steps of
;; the length that the last one had
(define (safe-time a b step limit)
  (define value (view-value b))
  (define forth (if (fl> step 0.0) 1.0 -1.0))
  (define rate (fl* forth (view-rate b)))
  (define bend
    (flmax (fl/ (fl* 0.1 value) (fl* step step))
           (fl* 4.0 (flabs (fl/ (fl- (view-rate b) (view-rate a))
                                (fl- (view-time b) (view-time a)))))))
  (define far (fl* 0.7 (fl- value limit)))
  ;; −rate τ + bend τ²/2 = far
  (define safe (fl/ (fl+ rate (flsqrt (fl+ (fl* rate rate) (fl* 2.0 (fl* bend far))))) bend))
  (fl* forth (flmin (fl* 3.0 (flabs step)) safe)))

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
