#lang racket/base
;; Work that takes too long is stopped, and nothing that others need is broken by it.

(require mechanics/teaching/class/within-limits
         "../../support/checks.rkt" "../../support/patience.rkt")

(define (forever) (let loop () (loop)))

(define (value-within seconds megabytes thunk)
  (define-values (value took) (call-within seconds megabytes thunk))
  value)

(test-case "what ends in time has its value, and is told what it took"
  (check-equal? (value-within 10 500 (lambda () 'value)) 'value)
  (define-values (value took) (call-within 10 500 void))
  (check-true (and (void? value) (real? took))))

(test-case "memory within the limit is left to it"
  (define (keep)
    (define kept (make-bytes 20000000))
    (collect-garbage)
    (sleep 0.2)
    (bytes-length kept))
  (check-equal? (value-within 10 100 keep) 20000000))

(test-case "what does not is stopped, and so is what takes too much memory"
  (check-false (value-within 1/4 500 forever))
  (check-false (value-within 10 100 (lambda () (let loop ([l '()])
                                                (loop (cons (make-bytes 1000000) l)))))))

(test-case "what takes no break is done to its end, and tables stay whole"
  (define table (make-hash))
  (define (fill-without-end)
    (let loop ([i 0])
      (parameterize-break #f (hash-set! table (list (modulo i 1000)) i))
      (loop (+ i 1))))
  (check-false (value-within 1/2 500 fill-without-end))
  (define reader (thread (lambda () (hash-set! table '(7) 'read))))
  (check-equal? (sync/patience 30 reader) reader)
  (check-equal? (hash-ref table '(7)) 'read))
