#lang mechanics
;; Lagrangians that depend on accelerations and beyond (SICM exercises 1.10, 1.13).
;;
;; For L(t, q, v, a) the residual is D(∂₂L) − D²(∂₃L) − ∂₁L along the path.

;; A total time derivative away from the harmonic oscillator.
(define ((L-acceleration m k) (up t x v a))
  (- (* -1/2 m x a) (* 1/2 k (square x))))

(define ((L-harmonic m k) (up t x v))
  (- (* 1/2 m (square v)) (* 1/2 k (square x))))

(define x (literal-function 'x))

(((Lagrange-equations (L-acceleration 'm 'k) #:order 2) x) 't)

;; Any order: for ½ (Dⁿx)² the equation is ± D²ⁿ x = 0.
(define ((L-order n) local)
  (* 1/2 (square (ref local (+ n 1)))))

(for ([n (in-range 1 5)])
  (displayln (simplify (((Lagrange-equations (L-order n) #:order n) x) 't))))

(module+ test
  (require rackunit)
  (test-case "−½ m x ẍ − ½ k x² gives the harmonic oscillator"
    (check-eq? (verdict-status
                (verify-equal
                 (((Lagrange-equations (L-acceleration 'm 'k) #:order 2) x) 't)
                 (((Lagrange-equations (L-harmonic 'm 'k)) x) 't)))
               'proved))
  (test-case "½ (Dⁿx)² gives ± the derivative of order 2n"
    (for ([n (in-range 1 5)])
      (check-eq? (verdict-status
                  (verify-equal (((Lagrange-equations (L-order n) #:order n) x) 't)
                                (* (expt -1 (+ n 1)) (((expt D (* 2 n)) x) 't))))
                 'proved
                 (format "order ~a" n))))
  (test-case "a Lagrangian of first order may be treated as one of second"
    (check-eq? (verdict-status
                (verify-equal
                 (((Lagrange-equations (lambda (local) ((L-harmonic 'm 'k)
                                                        (up (ref local 0)
                                                            (ref local 1)
                                                            (ref local 2))))
                                       #:order 2)
                   x) 't)
                 (((Lagrange-equations (L-harmonic 'm 'k)) x) 't)))
               'proved)))
