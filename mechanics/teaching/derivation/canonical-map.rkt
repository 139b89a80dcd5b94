#lang racket/base
;; Is a map of phase space canonical?
;;
;; A map (t, q', p') ↦ (t, q, p) is canonical if it preserves Poisson brackets; it is enough that it
;; preserves those of coordinates and momenta (SICM 5.3):
;;
;;   {qⁱ, qʲ} = 0,   {pᵢ, pⱼ} = 0,   {qⁱ, pⱼ} = δⁱⱼ.

(require "../../error/complain.rkt"
         "../../generic/arithmetic.rkt" "../../generic/describe.rkt" "../../generic/function.rkt"
         "../../hamiltonian/H-state.rkt" "../../hamiltonian/Poisson-bracket.rkt"
         "../../lagrangian/generic-state.rkt"
         "../../value/shape.rkt" "../../value/structure.rkt"
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
  (define n (quotient (shape-length state) 2))
  (define (component k) (lambda (s) (list-ref (scalars (C s)) k)))
  (define (brackets)
    (list->up
     (for*/list ([i (in-range 1 (+ n n 1))] [j (in-range (+ i 1) (+ n n 1))])
       (g:- ((Poisson-bracket (component i) (component j)) state)
            (if (= j (+ i n)) 1 0)))))
  (prove-residual-zero brackets (scalars state) #:domain (lambda () (expressions-of image))))
