#lang racket/base
;; The time as a coordinate (SICM 5.5, pp. 394–402).
;;
;; With the time q⁰ = t as a coordinate and a momentum p₀ for it, H' = p₀ + H(t, q, p) moves q and
;; p as H does, ∂H'/∂p₀ = 1, and does not depend on the new time: the explicit time of H is
;; one coordinate more.  Along a motion p₀ + H is conserved.
;;
;; A transformation C with its correction K, H' = H∘C + K, is one without explicit time there:
;; p₀' + H' = p₀ + H∘C gives p₀ = p₀' + K, and K is right if that is symplectic (exercise 5.19).
;;
;; A Hamiltonian that is periodic with the frequency ω has an angle φ = ω t instead, with the
;; momentum P: H' = ω P + H(φ/ω, q, p).

(require "../canonical/transformation.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/printed-function.rkt"
         "../generic/scalar.rkt" "../generic/wrong-argument.rkt"
         "../hamiltonian/H-state.rkt" "../hamiltonian/Hamiltonian.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/structure.rkt")

(provide extended-Hamiltonian extended-transformation extended-state reduced-state
         periodic-extension)

;; ((extended-Hamiltonian H) (up s (up t q) (down p_t p))) = p_t + H(t, q, p)
(define-printed (extended-Hamiltonian H)
  (check-Hamiltonian 'extended-Hamiltonian H)
  (lambda (state)
    (define inner (reduced 'extended-Hamiltonian state))
    (g:+ (s:ref (momentum state) 0) (H inner))))

;; (s, (t, q'), (p_t', p')) ↦ (s, (t, q), (p_t' + K(t, q', p'), p))
(define-printed (extended-transformation C K)
  (define who 'extended-transformation)
  (check-transformation who C)
  (check-Hamiltonian who K)
  (lambda (state)
    (define inner (reduced who state))
    (define old (transformed who C inner))
    (up (time state)
        (up (time old) (coordinate old))
        (down (g:+ (s:ref (momentum state) 0) (K inner)) (momentum old)))))

;; ((periodic-extension H ω) (up s (up φ q) (down P p))) = ω P + H(φ/ω, q, p)
(define-printed (periodic-extension H omega)
  (check-Hamiltonian 'periodic-extension H)
  (when (or (not (scalar? omega)) (eqv? omega 0))
    (complain 'periodic-extension "the frequency is a number other than 0, or a symbol; given ~a"
              (describe-with-value omega)))
  (lambda (state)
    (define inner (reduced 'periodic-extension state))
    (g:+ (g:* omega (s:ref (momentum state) 0))
         (H (up (g:/ (time inner) omega) (coordinate inner) (momentum inner))))))

;; (t, q, p) with a momentum p_t ↦ (t, (t, q), (p_t, p)); without one −H(t, q, p), so that the
;; extended Hamiltonian is 0
(define (extended-state state p_t)
  (check-H-state 'extended-state state)
  (define t (time state))
  (define extra (if (procedure? p_t) (g:negate (p_t state)) p_t))
  (up t (up t (coordinate state)) (down extra (momentum state))))

(define (reduced-state state) (reduced 'reduced-state state))

(define (reduced who state)
  (check-H-state who state)
  (define q (coordinate state))
  (unless (and (tuple? q) (= (s:length q) 2))
    (complain-of-argument who
                          (string-append "a state of the extended phase space, "
                                         "(up s (up t q) (down p_t p))")
                          state))
  (up (s:ref q 0) (s:ref q 1) (s:ref (momentum state) 1)))
