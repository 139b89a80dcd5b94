#lang racket/base
;; The program of a submission's process (evaluate.rkt): it reads a request from one port and
;; answers on the other.

(require "evaluate.rkt")

(evaluate-request (current-input-port) (current-output-port))
