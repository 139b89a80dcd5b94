#lang racket/base
;; The program of `raco mechanics` (../../info.rkt), and of `make show` and `make tex` in a
;; checkout.

(require "run-command.rkt")

(module+ main (exit (run-command-line (vector->list (current-command-line-arguments)))))
