#lang racket/base
;; A list among the starts of an ensemble was said to be made of no finite numbers, and it was.

(require mechanics
         "../support/messages.rkt")

(define (free s) (up 1 (ref s 2) 0))

(says
 [(evolve-ensemble free (list (up 0 1 0) '(0 1 0)) 1)
  "evolve-ensemble: start 1 is not made of finite real numbers\n  start: (0 1 0)\n"
  "  a list is not a tuple; use (up t q v)"]
 [(evolve-ensemble free (list (up 0 1 0) (up 0 'a 0)) 1)
  "evolve-ensemble: start 1 is not made of finite real numbers\n  start: (up 0 a 0)"])
