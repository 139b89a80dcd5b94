#lang racket/base
;; Values that are computed when they are first asked for.
;;
;; A promise that a break interrupts raises that break for ever; here the next who asks
;; begins anew.  Two threads may both compute.

(provide once at-last)

;; f : -> values; -> a procedure that gives the same, calling f when it is first called
(define (once f)
  (define known #f)                     ; a list
  (lambda ()
    (unless known (set! known (call-with-values f list)))
    (apply values known)))

;; x : a procedure of no arguments, called for its values, or a value itself
(define (at-last x) (if (procedure? x) (x) x))
