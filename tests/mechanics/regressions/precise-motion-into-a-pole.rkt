#lang racket/base
;; In numbers of higher precision a motion into a pole went on for ever, in shorter and
;; shorter steps.

(require mechanics
         "../support/checks.rkt" "../support/bigfloats.rkt" "../support/skip.rkt")

;; y = log |t - pole|
(define ((logarithm pole) s) (up 1 (/ 1 (- (time s) pole))))

(define (follow pole start end bits)
  ((state-advancer logarithm pole) (up start 1) (- end start)
                                   #:precision bits #:most-steps 2000))

(skip-unless bigfloats? no-bigfloats
  (test-case "the motion ends at the pole, also where that is at the time 0, and backwards"
    (for ([run '((1 0 2) (0 -1 1) (1 2 0))] [bits '(60 100 60)])
      (check-exn #rx"^state-advancer: the motion cannot be followed any further\n  time: "
                 (lambda () (apply follow (append run (list bits)))))))

  (test-case "near it, it is followed"
    (define y (ref (follow 1 0 (- 1 (expt 10 -12)) 100) 1))
    (check-true (< (abs (- y (+ 1 (log (bigfloat (expt 10 -12) 200))))) 1e-12))))
