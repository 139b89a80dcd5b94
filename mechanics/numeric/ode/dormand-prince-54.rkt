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

(require racket/flonum
         "stepper.rkt" "vectors.rkt"
         "../flvector.rkt")

(provide dormand-prince-54)

(define-syntax-rule (quotients n out y h [p q k] ...)
  (combine! n out y h [(fl/ p q) k] ...))

(define (start f! y0)
  (define n (flvector-length y0))
  (define-vectors n z w e k0)
  (define y (flvector-copy y0))
  (define ks (make-vectors 7 n))
  (define first (vector-ref ks 0))
  (define last (vector-ref ks 6))
  (define (try! h)
    (take-slopes! f! n y z w ks h)
    (fl* (flabs h) (error-of n y z e ks)))
  (define (accepted!)
    (flvector-copy! k0 first)
    (flvector-copy! first last))
  (define (interpolant old h) (polynomial n old y k0 ks h))
  (f! y first)
  (make-stepper y z (lambda () first) try! interpolant #:accepted accepted!))

;; From the slope k0 at y to the others and the new state.
(define (take-slopes! f! n y z w ks h)
  (define-elements ks k0 k1 k2 k3 k4 k5 k6)
  (quotients n w y h [1.0 5.0 k0])
  (f! w k1)
  (quotients n w y h [3.0 40.0 k0] [9.0 40.0 k1])
  (f! w k2)
  (quotients n w y h [44.0 45.0 k0] [-56.0 15.0 k1] [32.0 9.0 k2])
  (f! w k3)
  (quotients n w y h [19372.0 6561.0 k0] [-25360.0 2187.0 k1] [64448.0 6561.0 k2]
             [-212.0 729.0 k3])
  (f! w k4)
  (quotients n w y h [9017.0 3168.0 k0] [-355.0 33.0 k1] [46732.0 5247.0 k2]
             [49.0 176.0 k3] [-5103.0 18656.0 k4])
  (f! w k5)
  (quotients n z y h [35.0 384.0 k0] [500.0 1113.0 k2] [125.0 192.0 k3]
             [-2187.0 6784.0 k4] [11.0 84.0 k5])
  (f! z k6))

;; Divided by the length of the step.
(define (error-of n y z e ks)
  (define-elements ks k0 k1 k2 k3 k4 k5 k6)
  (weighted-sum! n e [(fl/ 71.0 57600.0) k0] [(fl/ -71.0 16695.0) k2] [(fl/ 71.0 1920.0) k3]
                 [(fl/ -17253.0 339200.0) k4] [(fl/ 22.0 525.0) k5] [(fl/ -1.0 40.0) k6])
  (root-mean-square e y z n))

;; Of the step from `old` to y, where the slope, k6, has become the first one.
(define (polynomial n old y k0 ks h)
  (define-elements ks k6 k1 k2 k3 k4 k5)
  (nested-polynomial n i
    [x (at old i)]
    [c0 (fl- (at y i) x)]
    [c1 (fl- (fl* h (at k0 i)) c0)]
    [c2 (fl- (fl- (fl* 2.0 c0) (fl* h (at k0 i))) (fl* h (at k6 i)))]
    [c3 (fl* h (weighted i [(fl/ -12715105075.0 11282082432.0) k0]
                         [(fl/ 87487479700.0 32700410799.0) k2]
                         [(fl/ -10690763975.0 1880347072.0) k3]
                         [(fl/ 701980252875.0 199316789632.0) k4]
                         [(fl/ -1453857185.0 822651844.0) k5]
                         [(fl/ 69997945.0 29380423.0) k6]))]))

(define dormand-prince-54 (adaptive-method 'Dormand-Prince-54 5 start))
