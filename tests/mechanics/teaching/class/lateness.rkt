#lang racket/base
;; Deadlines: times as they are written, and what lateness costs.

(require mechanics/teaching/class/lateness
         mechanics/teaching/worksheet/deadlines
         mechanics/teaching/worksheet/exercise
         "../../support/checks.rkt" "../../support/messages.rkt")

(define (hours n) (* 3600 n))
(define noon "2026-11-20 12:00 Z")

;; The share kept, and the remark, for a submission so many seconds late
(define (kept d late [extension 0])
  (define-values (share said) (lateness d (+ late (deadline-seconds d)) extension))
  (list share said))

(test-case "times, with a zone and without"
  (check-equal? (text->seconds "2026-11-20 12:00 Z") 1795176000)
  (for ([same '("2026-11-20T13:00:00+01:00" "2026-11-20 07:00 -0500" "2026-11-20T12:00:00.3659Z")])
    (check-equal? (text->seconds same) 1795176000 same))
  (for ([same '("20 November 2026, 6:45 PM" "Friday, 20 November 2026, 6:45 PM"
                "Friday, 20 November 2026, 18:45" "Freitag, 20. November 2026, 18:45")])
    (check-equal? (text->seconds same) (text->seconds "2026-11-20 18:45") same))
  (for ([none '("week 4" "2026-13-20 12:00" "20 Brumaire 2026, 6:45 PM" "" "2026-11-20")])
    (check-false (text->seconds none) none)))

(test-case "each day that has begun costs its share, until nothing is left"
  (define d (make-deadline noon #:grace 15 #:per-day 1/10 #:days 3))
  (check-equal? (kept d (hours -1)) '(1 #f))
  (check-equal? (kept d 900) '(1 #f))
  (check-equal? (kept d 901) '(9/10 "handed in 15 minutes after the deadline: 10 % taken off"))
  (check-equal? (kept d (hours 27))
                '(8/10 "handed in 1 day 3 hours after the deadline: 20 % taken off"))
  (check-equal? (kept (make-deadline noon #:per-day 1/8) (hours 1))
                '(7/8 "handed in 1 hour after the deadline: 12.5 % taken off"))
  (check-equal? (kept d (hours 73))
                '(0 "handed in 3 days 1 hour after the deadline: it does not count"))
  (check-equal? (car (kept (make-deadline noon #:per-day 1/2) (hours 100))) 0))

(test-case "an extension moves the deadline of one"
  (define d (make-deadline noon #:per-day 1/10))
  (check-equal? (kept d (hours 24) 1) '(1 #f))
  (check-equal? (car (kept d (hours 25) 1)) 9/10))

(test-case "without a price lateness is told alone; without a time or a deadline there is none"
  (check-equal? (kept (make-deadline noon) 60)
                '(1 "handed in 1 minute after the deadline: nothing is taken off"))
  (define-values (share said) (lateness #f 10 0))
  (check-equal? (list share said) '(1 #f))
  (define-values (share-of-unknown _) (lateness (make-deadline noon) #f 0))
  (check-equal? share-of-unknown 1))

(test-case "students read what lateness costs"
  (check-equal? (passage-text (make-deadline noon #:grace 1 #:per-day 0.1 #:days 3))
                (string-append "Due: 2026-11-20 12:00 Z. Up to 1 minute later counts as in time. "
                               "Each day late, begun or whole, costs 10 % of the points. "
                               "What comes more than 3 days late does not count.")))

(says
 [(make-deadline "Friday")
  "deadline: expected a time, as in (deadline \"2026-11-20 18:00\")\n  given: \"Friday\""]
 [(make-deadline "2026-11-31 18:00")
  "deadline: there is no such day, or no such hour of it\n  given: \"2026-11-31 18:00\""]
 [(make-deadline noon #:grace -1) "deadline: #:grace takes a number of minutes\n  given: -1"]
 [(make-deadline noon #:per-day 10)
  "deadline: #:per-day takes a share of the points, from 0 to 1\n  given: 10"]
 [(make-deadline noon #:days 1/2) "deadline: #:days takes a whole number of days\n  given: 1/2"])
