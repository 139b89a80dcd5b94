#lang racket/base
;; SICM 6.2, Time Evolution is Canonical (pp. 426–437), in the reader's own language.

(require mechanics)

(provide H-driven-oscillator C*)

;; An oscillator of mass 1 and frequency ω₀ that is driven by the force α cos ωt (p. 430).
(define ((H-driven-oscillator alpha omega omega_0) (up t q p))
  (- (+ (* 1/2 (square p))
        (* 1/2 (square omega_0) (square q)))
     (* alpha q (cos (* omega t)))))

;; Its state a time Δt later.  Driven, it has the motion xi; the rest moves freely.
(define (((C* alpha omega omega_0) delta-t) (up t q p))
  (define amplitude (/ alpha (- (square omega_0) (square omega))))
  (define (xi t) (* amplitude (cos (* omega t))))
  (define-values (c s) (values (cos (* omega_0 delta-t)) (sin (* omega_0 delta-t))))
  (define-values (q-free p-free) (values (- q (xi t)) (- p ((D xi) t))))
  (define later (+ t delta-t))
  (up later
      (+ (* q-free c) (* (/ p-free omega_0) s) (xi later))
      (+ (* p-free c) (* -1 omega_0 q-free s) ((D xi) later))))
