#lang racket/base
;; The kinetic energy ½ Σ m_k v_k² of particles at r(t, q), as a function of (t, q, q̇).

(require "masses.rkt" "particles.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt")

(provide kinetic-energy)

(define (kinetic-energy masses r)
  (define who 'kinetic-energy)
  (check-masses who masses)
  (check-positions who r)
  (unary-function (lambda () (list who (masses->datum masses) (value->datum r))) (local)
    (check-local who local)
    (define-values (x v) (motion-along who r local))
    (check-masses-fit who masses x)
    (g:* 1/2 (scaled-sum (times-masses masses v) v))))
