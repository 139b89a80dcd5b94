#lang racket/base
;; The method of Dormand and Prince of order 5 with an error estimate of order 4
;; (Hairer, Nørsett and Wanner, II.5, table 5.2), the common "RK45".
;;
;; Six slopes lead to the new state z; the slope there, k₆, is the first one of the
;; next step and takes part in the estimate.  Within a step the state is
;;
;;     y(θ) = y + θ (c₀ + (1 − θ) (c₁ + θ (c₂ + (1 − θ) c₃))),
;;
;; of order 4 (II.6).
;;
;; Its numbers are fractions; each is rounded once.

(require racket/flonum
         "method-formulas.rkt" "machine-method.rkt" "vector-formulas.rkt")

(provide dormand-prince-54 dormand-prince-54-formulas)

(define dormand-prince-54-formulas
  (explicit (k0 k1 k2 k3 k4 k5 k6) k6 (h i old y)
   ;; from the slope k0 at y to the others and the new state, where the last one is taken
   (stages
    ([k1 [(fl/ 1.0 5.0) k0]]
     [k2 [(fl/ 3.0 40.0) k0] [(fl/ 9.0 40.0) k1]]
     [k3 [(fl/ 44.0 45.0) k0] [(fl/ -56.0 15.0) k1] [(fl/ 32.0 9.0) k2]]
     [k4 [(fl/ 19372.0 6561.0) k0] [(fl/ -25360.0 2187.0) k1] [(fl/ 64448.0 6561.0) k2]
         [(fl/ -212.0 729.0) k3]]
     [k5 [(fl/ 9017.0 3168.0) k0] [(fl/ -355.0 33.0) k1] [(fl/ 46732.0 5247.0) k2]
         [(fl/ 49.0 176.0) k3] [(fl/ -5103.0 18656.0) k4]]
     [k6 [(fl/ 35.0 384.0) k0] [(fl/ 500.0 1113.0) k2] [(fl/ 125.0 192.0) k3]
         [(fl/ -2187.0 6784.0) k4] [(fl/ 11.0 84.0) k5]])
    w)
   (error-estimate
    ([e [(fl/ 71.0 57600.0) k0] [(fl/ -71.0 16695.0) k2] [(fl/ 71.0 1920.0) k3]
        [(fl/ -17253.0 339200.0) k4] [(fl/ 22.0 525.0) k5] [(fl/ -1.0 40.0) k6]])
    (quotient (fl* (flabs h) e) 1.0))
   (further () #f)
   (coefficients
    [x (at old i)]
    [c0 (fl- (at y i) x)]
    [c1 (fl- (fl* h (at k0 i)) c0)]
    [c2 (fl- (fl- (fl* 2.0 c0) (fl* h (at k0 i))) (fl* h (at k6 i)))]
    [c3 (fl* h (weighted i [(fl/ -12715105075.0 11282082432.0) k0]
                         [(fl/ 87487479700.0 32700410799.0) k2]
                         [(fl/ -10690763975.0 1880347072.0) k3]
                         [(fl/ 701980252875.0 199316789632.0) k4]
                         [(fl/ -1453857185.0 822651844.0) k5]
                         [(fl/ 69997945.0 29380423.0) k6]))])))

(define dormand-prince-54 (explicit-method 'Dormand-Prince-54 5 dormand-prince-54-formulas))
