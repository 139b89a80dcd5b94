#lang racket/base
;; A Taylor series about a number of higher precision could not be applied: that number
;; was no scalar there, so its increment was of another shape.

(require (prefix-in m: mechanics)
         "../support/checks.rkt" "../support/bigfloats.rkt" "../support/skip.rkt")

(define (series-of-sine x dx n) (m:series:head (((m:Taylor-series m:sin) x) dx) n))

(skip-unless bigfloats? no-bigfloats
  (define one (m:bigfloat 1 200))
  (define tenth (m:bigfloat "0.1" 200))
  (define expected
    (let ([s (m:sin one)] [c (m:cos one)])
      (list s (m:* c tenth) (m:/ (m:* -1 s (m:square tenth)) 2)
            (m:/ (m:* -1 c (m:cube tenth)) 6))))
  (define (close? a b)
    (<= (abs (m:bigfloat->exact (m:- a b))) (expt 2 -195)))

  (test-case "about a bigfloat, with an increment that is one"
    (for ([term (series-of-sine one tenth 4)] [e expected])
      (check-true (close? term e))))

  (test-case "of either sort, about the other"
    (for ([terms (list (series-of-sine one 1/10 4) (series-of-sine one 0.1 4))])
      (for ([term terms] [e expected])
        (check-true (m:bigfloat? term))
        (check-true (< (abs (m:bigfloat->exact (m:- term e))) 1e-16))))
    (check-true (< (abs (- (cadr (series-of-sine 1.0 0.1 2))
                           (m:exact->inexact (cadr (series-of-sine 1.0 tenth 2)))))
                   1e-15))))
