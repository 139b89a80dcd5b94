#lang racket/base
;; Between which numbers the value of a constant lies, such as 10¹³ π - 31415926535897: flonums
;; would not tell, of which large numbers leave few digits when they cancel.

(require "../ball/ball.rkt" "../ball/ball-tape.rkt"
         "../expression/flat-graph.rkt")

(provide constant-bounds)

;; e : an expression of numbers and π; decided? : low high -> anything
;; -> the first true value of decided? at exact bounds that get closer; #f if there is none
(define (constant-bounds e decided?)
  (define t (expression->tape e))
  (for/or ([p (in-list precisions)])
    (define v (tape-value t (lambda (leaf arguments) (raise unknown)) p))
    (cond [(ball? v)
           (define unit (expt 2 (ball-scale v)))
           (decided? (* unit (ball-lower v)) (* unit (ball-upper v)))]
          [(number? v) (decided? v v)]
          [else #f])))

;; Bits, doubled until the budget ends.
(define precisions '(128 256 512 1024 2048))
