#lang racket/base
;; The program of a submission's process (teaching/class/evaluate.rkt): it reads a request from one
;; port and answers on the other.

(require "../../notebook/cell-session.rkt"
         "../../teaching/class/evaluate.rkt")

(evaluate-request (current-input-port) (current-output-port) cell-failure)
