#lang racket/base
;; Work of our own that may take too long, or too much memory: it is stopped by a break.

(require "../../generic/own-thread.rkt")

(provide call-within)

;; thunk : -> any
;; -> its value, or #f if it had to be stopped; and the seconds of a processor that it took
(define (call-within seconds megabytes thunk)
  (define-values (own full) (values (make-custodian) (make-custodian)))
  (define result #f)
  (define worker
    (parameterize ([current-custodian own])
      (parameterize-break #t
        (thread (lambda ()
                  (with-handlers ([exn:break? void]) (set! result (box (thunk)))))))))
  (custodian-limit-memory own (* megabytes 1048576) full)
  (dynamic-wind
   void
   (lambda ()
     (unless (ends-within? worker seconds (make-custodian-box full #t)) (stop-thread worker))
     (values (and result (unbox result)) (seconds-of worker)))
   (lambda () (custodian-shutdown-all own))))

;; full : an event, ready when the worker has no memory left
(define (ends-within? worker seconds full)
  (let wait ()
    (define first-event (sync/timeout pulse worker full))
    (cond [(thread-dead? worker) #t]
          [(or first-event (> (seconds-of worker) seconds)) #f]
          [else (wait)])))

(define pulse 1/10)              ; seconds, how often its time is looked at

(define (seconds-of worker) (/ (current-process-milliseconds worker) 1000.))
