#lang racket/base
;; Work that may not end is given up, and what it gives or raises is passed on.

(require "support/checks.rkt" "support/patience.rkt")

(define (value thunk [seconds 1/5]) (value-within seconds 200 thunk 'given-up))

(test-case "a value comes back, also a false one, and an error is raised again"
  (check-equal? (value (lambda () 5) 10) 5)
  (check-equal? (value (lambda () #f) 10) #f)
  (check-exn #rx"^oh$" (lambda () (value (lambda () (error "oh")) 10))))

(test-case "work without end is given up, whether it uses a processor, takes memory or waits"
  (check-equal? (value (lambda () (let loop () (loop)))) 'given-up)
  (check-equal? (value (lambda () (let loop ([l '()]) (loop (cons (make-bytes 1000000) l)))) 10)
                'given-up)
  (check-equal? (value (lambda () (sync never-evt))) 'given-up))
