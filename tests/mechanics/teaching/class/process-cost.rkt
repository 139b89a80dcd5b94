#lang racket/base
;; The cost of a process: waiting for a processor is not counted, sleep is, and so is the
;; work that others do for it.

(require mechanics/teaching/class/process-cost
         (only-in racket/file file->string)
         "../../support/checks.rkt" "../../support/skip.rkt")

(define start (reading 100. 7. 3.))

;; The cost if so much passes.
(define (cost passed waited used)
  (cost-between start (reading (+ 100. passed) (+ 7. waited) (+ 3. used))))

(test-case "the time in which a program waits for a processor costs nothing"
  (check-equal? (cost 40. 37. 3.) 3.)
  (check-equal? (cost 600. 600. 0.) 0.))

(test-case "a program that works costs what it works"
  (check-equal? (cost 10. 0. 10.) 10.)
  (check-equal? (cost 20. 10. 10.) 10.))

(test-case "a program that sleeps costs the time in which it does"
  (check-equal? (cost 10. 0. 0.) 10.)
  (check-equal? (cost 12. 2. 0.) 10.))

(test-case "a program that has others work while it waits costs what they work"
  (check-equal? (cost 10. 9.5 20.) 20.))

;; ---------------------------------------------------------------------------
;; The system's figures

;; The number of this process.
(define me
  (and (waits-known?)
       (string->number (car (regexp-match #px"^\\d+" (file->string "/proc/self/stat"))))))

(define (work) (for/fold ([x 0.]) ([i (in-range 20000000)]) (+ x (sin i))))

(define-values (sleeper out in err) (subprocess #f #f #f "/bin/cat"))
(for-each close-input-port (list out err))

(skip-unless (waits-known?) "the system does not tell how long processes wait"
  (test-case "work is seen"
    (define before (read-cost me #f))
    (check-true (real? (work)))
    (define after (read-cost me #f))
    (check-true (> (reading-used after) (reading-used before)))
    (check-true (>= (reading-waited after) (reading-waited before))))
  (test-case "the clock and the waiting are in seconds"
    (define (nanoseconds)
      (string->number (cadr (regexp-match #px" (\\d+) " (file->string "/proc/self/schedstat")))))
    (define (now) (list (current-inexact-milliseconds) (nanoseconds)))
    (define-values (before r after) (values (now) (read-cost me #f) (now)))
    (for ([least before] [part (list reading-clock reading-waited)] [unit '(1e3 1e9)] [most after])
      (check-true (<= least (* unit (+ 1e-12 (part r))) (* (+ 1 1e-9) most)))))
  (test-case "what a process starts is part of it"
    (define own (reading-used (read-cost (subprocess-pid sleeper) #f)))
    (check-true (< own (reading-used (read-cost me #f))))
    (check-true (real? (cost-between (read-cost me #t) (read-cost me #t))))))

(test-case "of a process that has ended what was known stays, and its time passes"
  (subprocess-kill sleeper #t)
  (subprocess-wait sleeper)
  (close-output-port in)
  (define last (reading 1. 50. 20.))
  (define now (read-on last (subprocess-pid sleeper) #f))
  (check-equal? (reading-waited now) 50.)
  (check-equal? (reading-used now) 20.)
  (check-true (> (reading-clock now) 1.)))
