#lang racket/base
;; Point transformations in phase space (SICM 5.1).
;;
;; F gives the old coordinates as a function of the new state, q = F(t, q').  Velocities
;; transform by v = ∂₀F + ∂₁F v', so that the momenta, which contract with them, satisfy
;; p' = p ∂₁F(t, q'): with p = p' (∂₁F)⁻¹ the state is extended to phase space.  The new
;; Hamiltonian is H∘C + K, with K = −p ∂₀F, the contribution of the moving coordinates.

(require "../calculus/derivative.rkt"
         "../error/complain.rkt" "../error/failure.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/printed-function.rkt"
         "../hamiltonian/H-state.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/simplify.rkt" "../value/structure.rkt"
         "../value/matrix/linear-algebra.rkt")

(provide F->CH F->K)

;; (F->CH F) : (t, q', p') ↦ (t, F(t, q'), p' (∂₁F)⁻¹)
(define-printed (F->CH F)
  (check-transformation 'F->CH F)
  (lambda (state)
    (define-values (q p) (old-coordinates-and-momenta 'F->CH F state))
    (up (time state) q p)))

;; (F->K F) : (t, q', p') ↦ −p ∂₀F(t, q')
(define-printed (F->K F)
  (check-transformation 'F->K F)
  (lambda (state)
    (define-values (q p) (old-coordinates-and-momenta 'F->K F state))
    (g:negate (g:* p (((partial 0) F) state)))))

(define (old-coordinates-and-momenta who F state)
  (check-H-state who state)
  (define q (F state))
  (define slope (((partial 1) F) state))
  (check-shape who F q state)
  (values q (with-handlers ([exn:fail:mechanics:singular:matrix?
                             (lambda (e) (raise-not-invertible who F slope e))])
              (solve-linear-right (momentum state) slope))))

;; ---------------------------------------------------------------------------
;; Bad coordinate transformations

(define (check-transformation who F)
  (unless (and (of-functions? F) (accepts? F 1))
    (complain who
              (string-append "expected a coordinate transformation, a function of the state that "
                             "gives the old coordinates; given ~a~a")
              (describe-function F)
              (if (of-functions? F)
                  (format "\n  if it takes parameters first, supply them: (~a (~a ...))"
                          who (value->text F))
                  ""))))

(define (check-shape who F q state)
  (define given (coordinate state))
  (unless (= (s:dimension q) (s:dimension given))
    (complain who "~a takes ~a new coordinates to ~a old ones\n  new: ~a\n  old: ~a~a"
              (value->text F) (s:dimension given) (s:dimension q)
              (value->text given) (value->text q)
              (if (and (up? q) (= (s:length q) 3))
                  "\n  the value is to be the coordinates alone, without time and momenta"
                  ""))))

(define (raise-not-invertible who F slope e)
  (raise-without-inverse
   who
   (format (string-append "the new coordinates do not determine the old ones: "
                          "the derivatives of ~a have no inverse\n  derivatives: ~a")
           (value->text F) (value->text (simplify slope)))
   slope
   (exn:fail:mechanics:singular:matrix-null-vectors e)
   e))
