#lang racket/base
;; What is asked about a system, loaded when it is first asked.

(require racket/lazy-require)

(lazy-require
 ["small-oscillations.rkt" (mass-matrix stiffness-matrix gyroscopic-matrix
                            normal-modes small-oscillation-frequencies)])

(provide mass-matrix stiffness-matrix gyroscopic-matrix
         normal-modes small-oscillation-frequencies)
