#lang racket/base
;; Is a map of phase space canonical?
;;
;; A map (t, q', p') ↦ (t, q, p) is canonical if it preserves Poisson brackets; it is enough that it
;; preserves those of coordinates and momenta (SICM 5.3):
;;
;;   {qⁱ, qʲ} = 0,   {pᵢ, pⱼ} = 0,   {qⁱ, pⱼ} = δⁱⱼ.

(require "../../canonical/symplectic-transformation.rkt"
         "../../error/complain.rkt"
         "../../generic/describe.rkt" "../../generic/function.rkt"
         "../../hamiltonian/H-state.rkt"
         "../../lagrangian/generic-state.rkt"
         "../../value/shape.rkt" "../../value/structure.rkt"
         "../../value/matrix/matrix.rkt"
         "../../verdict/question-domain.rkt" "../../verdict/surveyed-zero.rkt")

(provide verify-canonical-map)

;; The verdict on the brackets of C at a state (up t q p) of symbols.
(define (verify-canonical-map C state)
  (define who 'verify-canonical-map)
  (check-H-state who state)
  (check-symbols who state "state")
  (unless (and (procedure? C) (accepts? C 1))
    (complain who "a map is a function of states (up t q p); given ~a" (describe-with-value C)))
  (define image (C state))
  (unless (and (tuple? image) (= (shape-length image) (shape-length state)))
    (complain who "its values are to be states like (up t q p)\n  value: ~a" (value->text image)))
  ;; each once, less its value if C is canonical: of J − M J Mᵀ, antisymmetric, the lower half
  (define (brackets)
    (define excess ((symplectic-transform? C) state))
    (define size (m:num-rows excess))
    (list->up (for*/list ([i (in-range size)] [j (in-range (+ i 1) size)])
                (matrix-ref excess j i))))
  (prove-residual-zero brackets (scalars state) #:domain (lambda () (expressions-of image))))
