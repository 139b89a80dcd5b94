#lang racket/base
;; A trajectory in the making: its steps and the events on the way.

(require "event/event.rkt")

(provide make-recording recorded-steps recorded-occurrences record-step! record-crossings!)

;; Both lists begin with the last.
(struct recording ([steps #:mutable] [occurrences #:mutable]) #:authentic)

(define (make-recording) (recording '() '()))

;; In their order; where there are none, the one that (stay) makes.
(define (recorded-steps r stay)
  (define steps (recording-steps r))
  (if (null? steps) (list (stay)) (reverse steps)))

(define (recorded-occurrences r) (reverse (recording-occurrences r)))

(define (record-step! r step) (set-recording-steps! r (cons step (recording-steps r))))

;; found : the crossings within a step up to the time `to`, with times; (end! t) records the
;; step as far as t; (give-up event t state) does not return
;; -> is the motion to go on?
(define (record-crossings! r found to end! #:state state-at #:shown shown #:give-up give-up)
  (let loop ([found found])
    (cond [(null? found) (end! to) #t]
          [else
           (define-values (t e) (values (crossing-at (car found)) (crossing-event (car found))))
           (define there (state-at t))
           (when (undefined? e)
             (end! t)
             (give-up (undefined-event e) t there))
           (define o (occurrence e (shown t) there (crossing-grazing? (car found))))
           (set-recording-occurrences! r (cons o (recording-occurrences r)))
           (cond [(event-terminal? e) (end! t) #f]
                 [else (loop (cdr found))])])))
