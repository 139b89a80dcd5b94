#lang racket/base
;; The point at which several expressions take open signs is looked for when it is first asked
;; for.

(require mechanics/algebra/assumption/assumption-set
         mechanics/algebra/assumption/reference-point
         mechanics/algebra/expression/read
         "../../support/checks.rkt")

(define large-sum
  (for/fold ([d 'x]) ([k (in-range 60000)])
    `(+ ,d (* ,(string->symbol (format "a~a" k)) (sqrt x)))))

(test-case "a break while the point is looked for leaves it to be found by the next who asks"
  (define sum (datum->expression large-sum))
  ;; The break comes after so many turns of the other thread, at one place or another.
  (for ([turns '(0 1 2 4 8)])
    (define A (at-common-reference no-assumptions (list sum)))
    (define started (make-semaphore))
    (define interrupted
      (thread (lambda ()
                (with-handlers ([exn:break? void])
                  (semaphore-post started)
                  ((assumptions-reference A))))))
    (semaphore-wait started)
    (for ([_ turns]) (sleep 0))
    (break-thread interrupted)
    (thread-wait interrupted)
    (check-pred procedure? ((assumptions-reference A)) (format "~a turns" turns))))
