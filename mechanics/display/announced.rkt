#lang racket/base
;; Word of what the prompt is doing, where it takes longer than one waits without asking.

(provide call-announced)

;; (f), and the text as a remark on the error port if that is not done after so many seconds.
(define (call-announced seconds text f)
  (define port (current-error-port))
  (define done (make-semaphore))
  (dynamic-wind
   (lambda ()
     (thread (lambda ()
               (unless (sync/timeout seconds (semaphore-peek-evt done))
                 (write-string (string-append "; " text "\n") port)
                 (flush-output port)))))
   f
   (lambda () (semaphore-post done))))
