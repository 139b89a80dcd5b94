#lang racket/base
;; From a point of a question to one where all holds that is assumed of it.
;;
;; Four relations that each hold at one point in five hold together at one in six hundred, and
;; random points miss them.  So one number is changed at a time, and kept where the point stays
;; in the question and no fewer relations hold.

(require "../statement.rkt")

(provide climb)

(define steps 1500)

;; numbers : symbol -> rational, a point of the question
;; holding : numbers -> how many relations hold there, or #f outside of the question
;; wanted : how many are to hold
;; -> numbers, or #f
(define (climb numbers holding wanted)
  (define symbols (hash-keys numbers))
  (let loop ([k 0] [numbers numbers] [count (or (holding numbers) 0)])
    (cond [(= count wanted) numbers]
          [(or (= k steps) (null? symbols)) #f]
          [else
           (define next (hash-set numbers (pick symbols) (near-a-number numbers)))
           (define next-count (holding next))
           (if (and next-count (>= next-count count))
               (loop (+ k 1) next next-count)
               (loop (+ k 1) numbers count))])))

;; Relations compare: so what another symbol has, or nearly, is of use.
(define (near-a-number numbers)
  (define x (pick (hash-values numbers)))
  (case (random 4)
    [(0) (pick '(1/2 -1/2 1 -1 2 -2 1/9 -1/9 7 -7))]
    [(1) (- x)]
    [(2) (* x (pick '(1/2 2 9/10 11/10 -9/10 -11/10)))]
    [else (+ x (pick '(1/8 -1/8 3/2 -3/2 5 -5)))]))
