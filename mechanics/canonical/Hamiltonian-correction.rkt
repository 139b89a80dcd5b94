#lang racket/base
;; Corrections of Hamiltonians for canonical transformations that depend on the time (SICM 5.2.1).
;;
;; The old state z = C(t, z') moves by M ż' + ∂₀C, with M the derivatives of C by z'.  For
;; H' = H∘C + K that is to be the motion of H, which asks of K that M J ∇K + ∂₀C = 0 (5.42).  A
;; symplectic M has the inverse −J Mᵀ J, so that
;;
;;     ∇K = Mᵀ J ∂₀C,     ∂K/∂x' = ∂q/∂x' ∂₀p − ∂p/∂x' ∂₀q:
;;
;; no equations are solved; the integrand is closed, as M is symplectic at all times.

(require "canonical.rkt" "closed-differential.rkt"
         "symplectic-transformation.rkt" "transformation.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/message-words.rkt"
         "../error/note.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/on-demand.rkt"
         "../generic/printed-function.rkt"
         "../hamiltonian/H-state.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/assumptions.rkt" "../value/shape.rkt" "../value/simplify.rkt"
         "../verdict/prove-zero.rkt" "../verdict/verdict.rkt")

(require-on-demand ["../calculus/expression-function.rkt" evaluate-at])

(provide C->K)

;; C, a state of symbols -> K, with which C passes canonical-K?
(define (C->K C state)
  (define who 'C->K)
  (check-for-any-state who C state)
  (define variables (cdr (scalars state)))
  (check-clock who C state)
  (when (refuted? (prove-zero ((symplectic-transform? C) state))) (raise-not-canonical who C))
  (define-values (e assumed)
    (call-telling-used
     (lambda ()
       (define form (map simplify (gradient-of-correction C state)))
       (unless (closed? form variables) (raise-not-canonical who C))
       (integrated who form variables))))
  (define K
    (printed-function (C->K C) (at)
      (check-H-state who at)
      (evaluate-at e state at)))
  (check-correction who C K state)
  (unless (null? assumed)
    (note-with-result (format "~a: this K is that of states with ~a" who
                       (joined (map (lambda (a) (format "~s" a)) assumed)))))
  K)

;; The components of Mᵀ J ∂₀C
(define (gradient-of-correction C state)
  (define-values (_image slopes) (image-and-slopes C state))
  (define rate (car slopes))
  (for/list ([slope (in-list (cdr slopes))])
    (g:- (g:* (momentum rate) (coordinate slope)) (g:* (momentum slope) (coordinate rate)))))

;; ---------------------------------------------------------------------------
;; Transformations without a correction

;; The time must be kept, which the brackets do not show.
(define (check-clock who C state)
  (define t (time (transformed who C state)))
  (unless (proved? (prove-zero (g:- t (time state))))
    (complain who "~a changes the time ~a to ~a; a correction belongs to one that keeps it"
              (value->text C) (value->text (time state)) (value->text (simplify t)))))

(define (raise-not-canonical who C)
  (complain who
            (string-append "~a has no correction K: it is not canonical"
                           "\n  for what it misses: (verify-canonical C state)")
            (value->text C)))

(define (check-correction who C K state)
  (define v (prove-zero ((canonical-K? C K) state)))
  (cond [(refuted? v) (raise-not-canonical who C)]
        [(not (proved? v))
         (raise-no-answer who
                          (string-append "a function was found, but not shown to correct ~a"
                                         "\n  is it canonical? (verify-canonical C state)")
                          (value->text C))]))
