#lang racket/base
;; Questions about a transformation at any state: at one of symbols, that are no parameters of it.

(require "transformation.rkt"
         "../hamiltonian/H-state.rkt"
         "../lagrangian/generic-state.rkt")

(provide check-for-any-state)

(define (check-for-any-state who C state)
  (check-transformation who C)
  (check-H-state who state)
  (check-symbols who state "state")
  (void (transformed who C state))
  (check-parameters who C state "state"))
