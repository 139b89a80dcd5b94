#lang racket/base
;; Memory that is run: it stays as long as a procedure of it does, whatever ends meanwhile, and is
;; given back after that; threads, futures, places and collections of garbage do not disturb it.

(require racket/future
         mechanics/numeric/machine/executable
         "../../support/checks.rkt" "../../support/machine-counter.rkt" "../../support/patience.rkt"
         "../../support/skip.rkt")

(define (collect!)
  (for ([_ (in-range 3)])
    (collect-garbage)
    (sleep 0.05)))

;; -> what (make) gives to a thread of a custodian that is then shut down
(define (made-and-shut-down make)
  (define c (make-custodian))
  (define made (make-channel))
  (parameterize ([current-custodian c])
    (thread (lambda () (channel-put made (make)))))
  (begin0 (channel-get made)
          (custodian-shutdown-all c)))

;; -> counters, until there is memory for no more
(define (all-counters)
  (let loop ([all '()] [n 0])
    (define counter (and (< n 20000) (make-counter)))
    (if counter (loop (cons counter all) (+ n 1)) all)))

(define (check-memory)
  (test-case "it outlives the custodian that it was made under"
    (define counter (made-and-shut-down make-counter))
    (collect!)
    (define others (for/list ([_ (in-range 50)]) (make-counter)))
    (check-equal? (count-to 5 counter) 5.0)
    (check-equal? (length others) 50))

  (test-case "collections of garbage do not disturb it"
    (define counter (make-counter))
    (define collecting
      (thread (lambda () (let loop () (collect-garbage 'minor) (sleep 0) (loop)))))
    (define counting
      (for/list ([_ (in-range 2)]) (future (lambda () (count-to 300000 counter)))))
    (check-equal? (count-to 300000 counter) 300000.0)
    (for ([f (in-list counting)]) (check-equal? (touch f) 300000.0))
    (kill-thread collecting))

  (test-case "places have their own, and end while it is run"
    (define counter (make-counter))
    (for ([_ (in-range 2)]) (check-equal? (count-in-place) 10.0))
    (collect!)
    (check-equal? (count-to 5 counter) 5.0))

  (test-case "there is an end to it, and what is dropped is given back"
    (define all (all-counters))
    (check-true (< 5000 (length all) 20000))
    (check-false (make-counter))
    (check-equal? (count-to 5 (car all)) 5.0)
    (set! all '())
    (define another (eventually (begin (collect!) (make-counter))))
    (check-equal? (count-to 5 another) 5.0))

  (test-case "threads that are killed while they ask for it leave it to others"
    (for ([_ (in-range 100)])
      (define t (thread (lambda () (let loop () (make-counter) (loop)))))
      (sleep 0)
      (kill-thread t))
    (check-equal? (count-to 5 (make-counter)) 5.0)))

(skip-unless (machine?) "no processor that machine code is written for" (check-memory))
