#lang mechanics
;; One twin stays at home, the other travels for 24 light years and comes back younger.

(require mechanics/geometry)

;; Years are the unit of ct; the speed is 24/25 of that of light.
(define speed 24/25)
(define home (base-frame-maker 'home))
(define (at frame ct x) (make-SR-coordinates frame (up ct x 0 0)))
(define (event frame ct x) ((point frame) (at frame ct x)))
(define start (event home 0 0))
(define turning (event home 25 24))
(define end (event home 50 0))

;; Two frames for the traveller: one that goes, one that comes.
(define going (make-SR-frame 'going home (up 1 0 0) speed ((chart home) start)))
(define coming (make-SR-frame 'coming home (up -1 0 0) speed ((chart home) turning)))

;; The time by a clock from one event to another, whatever the frame in which it is worked out
(define (shown a b [frame home])
  (proper-time-interval (- ((chart frame) b) ((chart frame) a))))
(define at-home (shown start end))
(define travelling (+ (shown start turning) (shown turning end)))
(list at-home travelling)
(list (shown start turning going) (shown turning end coming))

;; Each sees the other's clock go slow, so who is younger?  Before the traveller turns it is early
;; at home, in his frame: it is less than two years since he left.
(define home-before (event going 7 (* 7 (- speed))))
((chart home) home-before)

;; When he has turned, it is late: the frames do not agree about what is now at home.
(define home-after (event coming 0 (* 7 (- speed))))
((chart home) home-after)

;; The years that neither of his frames counts
(define skipped (shown home-before home-after))
(list skipped (+ (shown start home-before) skipped (shown home-after end)))

;; At any speed v, of T years at home it is T sqrt(1 - v^2) for the traveller.
(define (age v T) (* 2 (proper-time-interval (up (/ T 2) (* v (/ T 2)) 0 0))))
(define younger (verify-equal (age 'v 'T) (* (abs 'T) (sqrt (- 1 (square 'v))))))
younger

(module+ test
  (require rackunit)
  (test-case "fifty years at home are fourteen on the way"
    (check-equal? (list at-home travelling) '(50 14))
    (check-equal? (list (shown start turning going) (shown turning end coming)) '(7 7)))
  (test-case "the moment of turning is early at home, and late"
    (check-equal? ((chart home) home-before) (up 49/25 0 0 0))
    (check-equal? ((chart home) home-after) (up 1201/25 0 0 0))
    (check-equal? skipped 1152/25))
  (test-case "at any speed"
    (check-pred proved? younger)))
