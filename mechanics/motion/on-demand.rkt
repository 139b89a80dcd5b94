#lang racket/base
;; Integration, loaded when it is first used.

(require "method-names.rkt"
         "../generic/on-demand.rkt")

(provide set-ode-integration-method! ode-integration-method integration-method? ode-precision)

(provide-on-demand
 ["evolution.rkt" state-advancer evolve linearized-flow]
 ["single-step.rkt" free-run-state-advancer ode-advancer advance-beyond]
 ["evolve-trajectory.rkt" evolve-trajectory]
 ["trajectory.rkt" trajectory? trajectory-start trajectory-end trajectory-final-state
                   trajectory-states trajectory-events trajectory-method trajectory-so-far]
 ["event/event.rkt" event event? occurrence? occurrence-event occurrence-time occurrence-state
              occurrence-grazing?]
 ["find-path.rkt" find-path]
 ["method.rkt" leapfrog Yoshida-4 Yoshida-6 Yoshida-8 Gauss-Legendre-2 Gauss-Legendre-4
               Gauss-Legendre-6])
