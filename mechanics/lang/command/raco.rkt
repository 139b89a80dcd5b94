#lang racket/base
;; What `raco mechanics` runs (../../info.rkt), and `make show` and `make tex` in a checkout.

(require "dispatch.rkt")

(module+ main (exit (run-command-line (vector->list (current-command-line-arguments)))))
