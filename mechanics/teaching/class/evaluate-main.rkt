#lang racket/base
;; The program of the process of a submission (evaluate.rkt): asked on one port, it answers on
;; the other.

(require "evaluate.rkt")

(evaluate-request (current-input-port) (current-output-port))
