#lang racket/base
;; A pendulum that begins upright stays for some ten swings, and then falls to a side that rounding
;; chose, without a word: π is no flonum.

(require mechanics
         mechanics/error/note
         (only-in mechanics/book L-pendulum)
         "../support/checks.rkt")

(define swing (Lagrangian->state-derivative (L-pendulum 9.8 1 1)))

;; The notes while it is followed, in a session of its own
(define (noted start end #:method [method 'auto])
  (define port (open-output-string))
  (thread-wait
   (thread (lambda ()
             (parameterize ([current-error-port port])
               (start-session-of-notes!)
               (for ([_ 2]) (evolve-trajectory swing start end #:method method))))))
  (get-output-string port))

(test-case "it is noted once"
  (for ([method '(auto Taylor Dormand-Prince-853)])
    (check-equal?
     (noted (up 0 pi 0) 20 #:method method)
     (string-append
      "; evolve-trajectory: the motion begins at rest but for rounding, which decides when it "
      "leaves\n; and where to; to see how an equilibrium is left, begin beside it\n"))))

(test-case "not where it stays, nor where it moves, nor where it rests exactly"
  (check-equal? (noted (up 0 pi 0) 2) "")
  (check-equal? (noted (up 0 (* 2 pi) 0) 20) "")
  (check-equal? (noted (up 0 0 0) 20) "")
  (check-equal? (noted (up 0 3.14 0) 20) "")
  (check-equal? (noted (up 0 pi 1e-9) 20) ""))
