#lang racket/base
;; How long a test waits for an event that may never come, and how much of a processor it grants
;; to work that may never end.  Seconds are those of an idle machine: on a slow or busy one they
;; last longer, in the ratio of what a fixed piece of work takes there.
;;
;; A guard of this kind is needed where the others in a process are to go on; a file that hangs
;; alone is ended by the runner.

(require mechanics/error/computed-once
         mechanics/teaching/class/within-limits)

(provide
 value-within         ; (value-within seconds megabytes thunk otherwise) : a syntax
 sync/patience        ; (sync/patience seconds event ...) : as sync/timeout
 eventually           ; (eventually condition) : its value once it is true, or #f; a syntax
 processor-seconds    ; (processor-seconds n) -> as many seconds of this processor's time
 clock-seconds)       ; (clock-seconds n) -> as many seconds of the clock

(define (sync/patience seconds . events)
  (patiently seconds (lambda () (apply sync/timeout 1 events))))

(define-syntax-rule (eventually condition)
  (patiently 30 (lambda () (seen-within-a-second (lambda () condition)))))

(define (seen-within-a-second true?)
  (for/or ([_ (in-range 20)])
    (or (true?) (begin (sleep 0.05) #f))))

;; look : -> any, #f after a second in vain.  The machine is measured anew after each.
(define (patiently seconds look)
  (or (look)
      (and (> seconds 0)
           (patiently (- seconds (/ 1 (slowness current-inexact-monotonic-milliseconds))) look))))

;; The value of the thunk, with what it raises; that of `otherwise` if it takes too many seconds of
;; a processor, too much memory, or waits in vain for ten times as long.
(define-syntax-rule (value-within seconds megabytes thunk otherwise)
  (let ([ending (ending-within seconds megabytes thunk)])
    (if ending (ending) otherwise)))

;; -> thunk of the value, or that raises; #f if there is none
(define (ending-within seconds megabytes thunk)
  (define ending #f)
  (define (run)
    (define-values (found _)
      (call-within (processor-seconds seconds) megabytes
                   (lambda ()
                     (with-handlers ([exn:fail? (lambda (e) (lambda () (raise e)))])
                       (define value (thunk))
                       (lambda () value)))))
    (set! ending found))
  (define runner (thread run))
  (unless (sync/patience (* 10 seconds) runner) (kill-thread runner))
  ending)

(define (processor-seconds n) (* n (processor-slowness)))

;; The least of three, for one may meet a collection of garbage.  A processor stays what it is.
(define processor-slowness
  (once
   (lambda ()
     (for/fold ([least +inf.0]) ([_ (in-range 3)])
       (min least (slowness current-process-milliseconds))))))

(define (clock-seconds n) (* n (slowness current-inexact-monotonic-milliseconds)))

;; ---------------------------------------------------------------------------

;; clock : -> milliseconds
;; -> how many times as long as on an idle machine the work takes, at least 1
(define (slowness clock)
  (define start (clock))
  (work)
  (max 1.0 (/ (- (clock) start) work-milliseconds)))

(define work-milliseconds 30.0)

;; Pseudo-random numbers, which take no memory.
(define (work)
  (for/fold ([x 1]) ([_ (in-range 16000000)])
    (bitwise-and (+ 12345 (* 69069 x)) #xFFFFFFF)))
