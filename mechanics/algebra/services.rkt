#lang racket/base
;; What finding kernels asks of the simplifier above it: arguments of kernels
;; are simplified first.

(provide (struct-out services))

;; simplify : expression -> expression
;; terms    : expression -> ((rational . expression) ...), its sum
;; split-root : expression degree -> (values outer inner): the root is outer · inner^(1/degree)
(struct services (simplify terms split-root)
  #:authentic)
