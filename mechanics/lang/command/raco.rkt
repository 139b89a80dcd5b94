#lang racket/base
;; What `raco mechanics` runs (../../info.rkt), and `make show` and `make tex` in a checkout.

(require "run-command.rkt")

(module+ main (exit (run-command-line (vector->list (current-command-line-arguments)))))
