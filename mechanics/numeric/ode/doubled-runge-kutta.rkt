#lang racket/base
;; The classical Runge–Kutta method of order 4, its steps doubled to learn their
;; error: the book's `qcrk4`.
;;
;; Two steps of length h/2 lead to z, one of length h to w.  Both are wrong by a
;; multiple of h⁵, w sixteen times as much as z; hence z is wrong by (z − w)/15,
;; which is the estimate and is added to z.

(require racket/flonum
         "shorter-step.rkt" "stepper.rkt" "vector-formulas.rkt")

(provide quality-controlled-runge-kutta-4)

(define (start f! y0)
  (define n (flvector-length y0))
  (define-vectors n z w middle e k0 k1 k2 k3)
  (define y (flvector-copy y0))

  ;; From `from`, where the slope is k0, to `to`.
  (define (classical-step! from to h k0)
    (combine! n to from h [0.5 k0])
    (f! to k1)
    (combine! n to from h [0.5 k1])
    (f! to k2)
    (combine! n to from h [1.0 k2])
    (f! to k3)
    (combine! n to from (fl/ h 6.0) [1.0 k0] [2.0 k1] [2.0 k2] [1.0 k3]))

  (define (try! h slope)
    (define first (slope))
    (define half (fl* 0.5 h))
    (classical-step! y w h first)
    (classical-step! y middle half first)
    (f! middle k0)
    (classical-step! middle z half k0)
    (weighted-sum! n e [(fl/ 1.0 15.0) z] [(fl/ -1.0 15.0) w])
    (combine! n z z 1.0 [1.0 e])
    (root-mean-square e y z n))

  (stepper-by-shorter-steps start f! y z try!))

(define quality-controlled-runge-kutta-4 (adaptive-method 'qcrk4 5 start))
