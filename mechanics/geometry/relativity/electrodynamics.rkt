#lang racket/base
;; Electrodynamics: the electric and the magnetic field as one 2-form of spacetime.
;;
;; In a frame with the coordinates ct, x, y, z and in Gaussian units the forms
;;
;;     F  = (E₁ dx + E₂ dy + E₃ dz) ∧ dct + B₁ dy∧dz + B₂ dz∧dx + B₃ dx∧dy       (Faraday's)
;;     ⋆F = −(B₁ dx + B₂ dy + B₃ dz) ∧ dct + E₁ dy∧dz + E₂ dz∧dx + E₃ dx∧dy      (Maxwell's)
;;     J  = (I₁ dx + I₂ dy + I₃ dz)/c − ρ dct
;;
;; satisfy Maxwell's equations, which are dF = 0 and d⋆F = 4π ⋆J.  No frame is preferred: another
;; observer's fields are the components of the same F in his frame.

(require "../basis.rkt" "../exterior-calculus.rkt" "../Hodge-star.rkt" "../manifold-chart.rkt"
         "../metric.rkt"
         "../raising-and-lowering.rkt" "../standard-manifolds.rkt" "../tensor-field.rkt"
         "../../error/complain.rkt"
         "../../generic/arithmetic.rkt" "../../generic/describe.rkt" "../../generic/up-down.rkt"
         "../../generic/wrong-argument.rkt")

(provide SR SR-metric SR-basis SR-star
         Faraday Maxwell four-current electric-field magnetic-field Lorentz-force)

;; The spacetime of special relativity
(define SR (with-coordinate-names R4-rect #(ct x y z)))
(define SR-basis (coordinate-system->basis SR))
(define SR-metric (make-Minkowski-metric SR))
(define SR-star (Hodge-star SR-metric SR-basis))

(define (check-frame who C)
  (check-coordinate-system who C)
  (unless (eq? (coordinate-system-manifold C) R4)
    (complain who "expected a frame, a chart of R4; this is one of ~a\n  given: ~a"
              (value->text (coordinate-system-manifold C)) (value->text C))))

;; ---------------------------------------------------------------------------
;; Forms of fields; fields are given as functions on spacetime, or numbers

(define (Faraday E1 E2 E3 B1 B2 B3 #:in [frame SR])
  (form-of-fields 'Faraday frame (list E1 E2 E3) (list B1 B2 B3)))

(define (Maxwell E1 E2 E3 B1 B2 B3 #:in [frame SR])
  (form-of-fields 'Maxwell frame (map g:negate (list B1 B2 B3)) (list E1 E2 E3)))

;; Σ aᵢ dxᵢ ∧ dct + Σ bᵢ dxⱼ ∧ dxₖ, with i, j, k in cyclic order
(define (form-of-fields who frame as bs)
  (define-values (dct dx dy dz) (forms-of who frame))
  (apply g:+ (for/list ([a (in-list as)] [b (in-list bs)] [i (in-list (list dx dy dz))]
                        [j (in-list (list dy dz dx))] [k (in-list (list dz dx dy))])
               (g:+ (g:* a (wedge i dct)) (g:* b (wedge j k))))))

(define (forms-of who frame)
  (check-frame who frame)
  (vector->values (tuple-elements (coordinate-system->1form-basis frame))))

(define (four-current density I1 I2 I3 #:c [c 1] #:in [frame SR])
  (define-values (dct dx dy dz) (forms-of 'four-current frame))
  (g:- (g:/ (g:+ (g:* I1 dx) (g:* I2 dy) (g:* I3 dz)) c) (g:* density dct)))

;; ---------------------------------------------------------------------------
;; Fields of a form, as an observer in the frame measures them: up tuples of functions

(define (electric-field F [frame SR])
  (define-values (e0 ex ey ez) (vectors-of 'electric-field F frame))
  (up (F ex e0) (F ey e0) (F ez e0)))

(define (magnetic-field F [frame SR])
  (define-values (e0 ex ey ez) (vectors-of 'magnetic-field F frame))
  (up (F ey ez) (F ez ex) (F ex ey)))

(define (vectors-of who F frame)
  (check-2form who F)
  (check-frame who frame)
  (vector->values (tuple-elements (coordinate-system->vector-basis frame))))

(define (check-2form who F)
  (check-argument who (lambda (F) (and (form-field? F) (= (field-rank F) 2))) F
                  "a 2-form, such as Faraday gives"))

;; A component, by a 1-form, of the force on a charge whose 4-velocity is a vector field
(define (Lorentz-force charge F 4-velocity component)
  (check-2form 'Lorentz-force F)
  (g:* charge (F ((raise-form SR-metric) component) 4-velocity)))
