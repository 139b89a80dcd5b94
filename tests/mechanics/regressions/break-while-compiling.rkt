#lang racket/base
;; A break while the derivatives of a system were compiled was kept with it: each later
;; use of the advancer ended in that break again.

(require mechanics "../support/checks.rkt")

;; A system whose n-th evaluation breaks its thread, and how often it was evaluated.
(define (breaking n)
  (define count 0)
  (define ((system k) s)
    (set! count (+ count 1))
    (when (= count n) (break-thread (current-thread)))
    (up 1 (* -1 k (ref s 1))))
  (values system (lambda () count)))

;; -> was it broken?
(define (broken? thunk)
  (with-handlers ([exn:break? (lambda (e) #t)])
    (thunk)
    #f))

(test-case "an advancer that was broken off works the next time, wherever that was"
  (for ([arguments '((1) (one))])
    (define-values (breaks last)
      (let loop ([n 1] [breaks 0])
        (define-values (system count) (breaking n))
        (define (maker k) (system (if (symbol? k) 1 k)))
        (define advance (apply state-advancer maker arguments))
        (define (run) (advance (up 0. 1.) 1 #:method 'Radau-IIA-5))
        (cond [(and (broken? run) (< n 60))
               (check-= (ref (run) 1) (exp -1) 1e-9 (format "broken at evaluation ~a" n))
               (loop (+ n 1) (+ breaks 1))]
              [else (values breaks n)])))
    (check-true (<= 4 breaks 59))))
