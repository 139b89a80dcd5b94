#lang racket/base
;; A remark on the work that the prompt is doing, printed if that takes long.

(provide call-announced announcement-delay)

;; Seconds before the remark is printed; #f for never.  Libraries are loaded for the first result;
;; on most machines that takes less than one.
(define announcement-delay (make-parameter 1))

;; (f), and the text as a remark if that takes longer than the delay: on the error port, but in an
;; editor, where that is red, beside the result.
(define (call-announced text f)
  (define output (current-output-port))
  (define port (if (port-writes-special? output) output (current-error-port)))
  (define seconds (announcement-delay))
  (define done (make-semaphore))
  (dynamic-wind
   (lambda ()
     (thread (lambda ()
               (unless (sync/timeout seconds (semaphore-peek-evt done))
                 (write-string (string-append "; " text "\n") port)
                 (flush-output port)))))
   f
   (lambda () (semaphore-post done))))
