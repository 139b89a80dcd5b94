#lang racket/base
;; Lateness: a submission after the deadline keeps a share of its points.

(require (only-in "../worksheet/deadlines.rkt" percents)
         "../worksheet/exercise.rkt"
         (only-in "../../error/message-words.rkt" counted))

(provide lateness)

;; d : a deadline, or #f; time : seconds since 1970, or #f; extension : days of the student's own
;; -> the share of the points that is kept, and the remark on it, or #f
(define (lateness d time extension)
  (define late (if (and d time) (- time (deadline-seconds d) (* day extension)) 0))
  (cond [(or (not d) (<= late (* 60 (deadline-grace d)))) (values 1 #f)]
        [else
         (define days (ceiling (/ late day)))
         (define share (share-after days d))
         (values share
                 (format "handed in ~a after the deadline: ~a" (duration late)
                         (cond [(= share 0) "it does not count"]
                               [(= share 1) "nothing is taken off"]
                               [else (format "~a % taken off" (percents (- 1 share)))])))]))

(define day 86400)

(define (share-after days d)
  (define per-day (deadline-per-day d))
  (cond [(and (deadline-days d) (> days (deadline-days d))) 0]
        [per-day (max 0 (- 1 (* days per-day)))]
        [else 1]))

;; "2 days 3 hours", "40 minutes"
(define (duration seconds)
  (define minutes (max 1 (quotient (inexact->exact (floor seconds)) 60)))
  (define hours (quotient minutes 60))
  (define days (quotient hours 24))
  (define rest (- hours (* 24 days)))
  (cond [(= hours 0) (counted minutes "minute")]
        [(= days 0) (counted hours "hour")]
        [(= rest 0) (counted days "day")]
        [else (format "~a ~a" (counted days "day") (counted rest "hour"))]))
