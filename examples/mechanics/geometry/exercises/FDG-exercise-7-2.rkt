#lang mechanics
;; Exercise 7.2 (FDG 7): covariant derivatives that are Lie derivatives
;; Checked: for a field v there is a connection with ∇_v = £_v; none is that for all fields
;; How: the connection for an unknown v, and a law that Lie derivatives break

(require mechanics/geometry)
(define basis (coordinate-system->basis R2-rect))
(define e (basis->vector-basis basis))
(define v (literal-vector-field 'v R2-rect))
(define u (literal-vector-field 'u R2-rect))

;; A 1-form that gives 1 on v, where v is not 0
(define vs ((basis->1form-basis basis) v))
(define (alpha w)
  (/ (apply + (for/list ([i 2]) (* (ref ((basis->1form-basis basis) w) i) (ref vs i))))
     (apply + (for/list ([i 2]) (square (ref vs i))))))

;; £_v ∂_j = −(∂_j v^k) ∂_k shall be ∇_v ∂_j, so ω^k_j = −(∂_j v^k) α.
(define (form j k)
  (lambda (w) (* -1 (alpha w) ((ref e j) (ref vs k)))))
(define connection
  (make-Cartan (down (up (form 0 0) (form 0 1)) (up (form 1 0) (form 1 1))) basis))
(define nabla (covariant-derivative connection))
(define right (verify-equal ((nabla v) u) ((Lie-derivative v) u)))
right

;; Along another field this connection differs from the Lie derivative.
(define w (literal-vector-field 'w R2-rect))
(define other (verify-equal ((nabla w) u) ((Lie-derivative w) u)))
(verdict-status other)

;; So does every connection for some field: ∇_fv = f ∇_v, which Lie derivatives do not keep.
(define f (literal-manifold-function 'f R2-rect))
(define any (covariant-derivative (literal-Cartan 'G R2-rect)))
(define linear (verify-equal ((any (* f v)) u) (* f ((any v) u))))
(define not-linear (verify-equal ((Lie-derivative (* f v)) u) (* f ((Lie-derivative v) u))))
linear
(verdict-status not-linear)

(module+ test
  (require rackunit)
  (test-case "for one field"
    (check-pred proved? right)
    (check-pred refuted? other))
  (test-case "not for all"
    (check-pred proved? linear)
    (check-pred refuted? not-linear)))
