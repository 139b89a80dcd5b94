#lang racket/base
;; Integration, loaded when it is first used.

(require racket/lazy-require)

(lazy-require
 ["evolution.rkt" (state-advancer evolve)]
 ["trajectory.rkt" (evolve-trajectory
                    trajectory? trajectory-start trajectory-end trajectory-final-state
                    trajectory-states trajectory-events)]
 ["event.rkt" (event event? occurrence? occurrence-event occurrence-time occurrence-state)]
 ["method.rkt" (set-ode-integration-method! ode-integration-method integration-method?)])

(provide
 state-advancer evolve
 evolve-trajectory
 trajectory? trajectory-start trajectory-end trajectory-final-state
 trajectory-states trajectory-events
 event event? occurrence? occurrence-event occurrence-time occurrence-state
 set-ode-integration-method! ode-integration-method integration-method?)
