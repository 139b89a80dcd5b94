#lang racket/base
;; The pendulum in closed form, loaded when it is first used.

(require "../generic/on-demand.rkt")

(provide-on-demand
 ["pendulum.rkt" Hpendulum pendulum-sysder pendulum-frequency
                 pendulum-oscillating-frequency pendulum-circulating-frequency
                 pendulum-oscillating-angle pendulum-oscillating-angular-momentum
                 pendulum-circulating-angle pendulum-circulating-angular-momentum
                 pendulum-separatrix-angle pendulum-separatrix-angular-momentum
                 pendulum-oscillating-action pendulum-circulating-action
                 pendulum-separatrix-action gudermannian inverse-gudermannian]
 ["phase.rkt" pendulum-oscillating-phase pendulum-circulating-phase
              pendulum-oscillating-dt pendulum-circulating-dt
              pendulum-oscillating-action-to-E pendulum-circulating-action-to-E
              pendulum-oscillating-state-to-aa-state
              pendulum-oscillating-aa-state-to-state
              pendulum-circulating-state-to-aa-state
              pendulum-circulating-aa-state-to-state
              pendulum-state-to-global-aa-state pendulum-global-aa-state-to-state]
 ["motion.rkt" pendulum-advance pendulum-integration pendulum-solution-series])
