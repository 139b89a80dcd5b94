#lang racket/base
;; What stands under a sine, an exponential or the like: where these leaves are 0, the
;; functions have exact values.

(require "../expression/flat-graph.rkt" "../expression/operation.rkt"
         "../expression/symbols.rkt")

(provide leaves-under-functions)

(define algebraic (list op:+ op:- op:* op:/ op:expt op:sqrt op:abs))

(define (transcendental? head) (not (memq head algebraic)))

;; -> the leaves standing somewhere below a function such as sin, and those that
;; stand nowhere else.  From the root down every item learns whether it is
;; outside (bit 1), below (bit 2) or both; a literal application is a leaf.
(define (leaves-under-functions t)
  (define items (tape-items t))
  (define heads (tape-heads t))
  (define n (vector-length items))
  (define states (make-vector n 0))
  (define leaves (make-hash))
  (vector-set! states (- n 1) 1)
  (for ([k (in-range (- n 1) -1 -1)])
    (define head (vector-ref heads k))
    (define state (vector-ref states k))
    (cond [(eqv? state 0) (void)]
          [(operation? head)
           (define below (if (transcendental? head) 2 state))
           (for ([j (in-list (vector-ref (tape-operands t) k))])
             (vector-set! states j (bitwise-ior below (vector-ref states j))))]
          [(not (unknown? (vector-ref items k))) (void)]
          [else
           (hash-update! leaves (vector-ref items k) (lambda (old) (bitwise-ior old state)) 0)]))
  (define (those test)
    (for/hash ([(leaf state) (in-hash leaves)] #:when (test state)) (values leaf #t)))
  (values (those (lambda (state) (>= state 2)))
          (those (lambda (state) (eqv? state 2)))))
