#lang racket/base
;; Right-hand sides of y' = f(y) with what computes Taylor coefficients of solutions.

(provide (struct-out expandable))

;; run    : y dy -> void
;; expand : order -> expansion (numeric/jet/expansion.rkt), for one thread at a time
(struct expandable (run expand)
  #:authentic
  #:property prop:procedure 0)
