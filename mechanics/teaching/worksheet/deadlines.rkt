#lang racket/base
;; Deadlines: when answers are due, and the cost of lateness.
;;
;; A time is written 2026-11-20 18:00, in the zone of the machine, or with its zone after it,
;; 2026-11-20 18:00 +01:00; learning platforms also write 20 November 2026, 6:00 PM.

(require racket/date
         "exercise.rkt" (only-in "judgment-words.rkt" number->text)
         "../../error/complain.rkt" "../../error/message-words.rkt"
         "../../generic/describe.rkt")

(provide make-deadline percents text->seconds)

(define (make-deadline time #:grace [grace 0] #:per-day [per-day #f] #:days [days #f])
  (define (check good? keyword expected given)
    (unless good?
      (complain 'deadline "~a takes ~a\n  given: ~a" keyword expected (value->text given))))
  (define seconds (and (string? time) (text->seconds time)))
  (when (and (not seconds) (string? time) (regexp-match? digits-first time))
    (complain 'deadline "there is no such day, or no such hour of it\n  given: ~a"
              (value->text time)))
  (unless seconds
    (complain 'deadline "expected a time, as in (deadline \"2026-11-20 18:00\")\n  given: ~a"
              (value->text time)))
  (check (and (real? grace) (>= grace 0)) '#:grace "a number of minutes" grace)
  (check (or (not per-day) (and (real? per-day) (<= 0 per-day 1))) '#:per-day
         "a share of the points, from 0 to 1" per-day)
  (check (or (not days) (exact-nonnegative-integer? days)) '#:days "a whole number of days" days)
  (deadline (deadline-text time grace per-day days) seconds grace per-day days))

(define (deadline-text time grace per-day days)
  (string-append
   (format "Due: ~a." time)
   (if (> grace 0) (format " Up to ~a later counts as in time." (counted grace "minute")) "")
   (if per-day
       (format " Each day late, begun or whole, costs ~a % of the points." (percents per-day))
       "")
   (if days (format " What comes more than ~a late does not count." (counted days "day")) "")))

(define (percents share) (number->text (* 100 share)))

;; ---------------------------------------------------------------------------
;; Times

(define digits-first
  (pregexp (string-append "^\\s*(\\d{4})-(\\d\\d?)-(\\d\\d?)[ T]+(\\d\\d?):(\\d\\d)"
                          "(?::(\\d\\d)(?:[.]\\d*)?)?"
                          "\\s*(?:(Z)|([+-])(\\d\\d):?(\\d\\d))?\\s*$")))
(define words-first
  #px"^\\D*(\\d\\d?)[.]? (\\p{L}+) (\\d{4}), (\\d\\d?):(\\d\\d)(?: ?([AP])M)?\\s*$")

;; -> seconds since 1970, or #f
(define (text->seconds text)
  (with-handlers ([exn:fail? (lambda (e) #f)])
    (cond [(regexp-match digits-first text) => digits->seconds]
          [(regexp-match words-first text) => words->seconds]
          [else #f])))

(define (digits->seconds m)
  (define-values (year month day hour minute second zulu sign zone-hours zone-minutes)
    (apply values (cdr m)))
  (define (n text) (if text (string->number text) 0))
  (define zone? (or zulu sign))
  (define seconds
    (find-seconds (n second) (n minute) (n hour) (n day) (n month) (n year) (not zone?)))
  (define offset (* 60 (+ (* 60 (n zone-hours)) (n zone-minutes))))
  (if (equal? sign "-") (+ seconds offset) (- seconds offset)))

(define months '("jan" "feb" "mar" "apr" "may" "jun" "jul" "aug" "sep" "oct" "nov" "dec"))

(define (words->seconds m)
  (define-values (day month year hour minute half) (apply values (cdr m)))
  (define (n text) (string->number text))
  (define name (string-downcase (substring month 0 3)))
  (define number (for/first ([m (in-list months)] [k (in-naturals 1)] #:when (equal? m name)) k))
  (define hours
    (if half (+ (modulo (n hour) 12) (if (equal? half "P") 12 0)) (n hour)))
  (find-seconds 0 (n minute) hours (n day) number (n year)))
