#lang racket/base
;; Functional Differential Geometry, chapter 4: bases, changes of basis, commutators.

(require mechanics
         mechanics/geometry
         "../../support/checks.rkt" "../../support/session.rkt")

(define-coordinates (up x y) R2-rect)
(define-coordinates (up r theta) R2-polar)
(define R2-rect-point ((point R2-rect) (up 'x0 'y0)))

(define e0 (+ (* (literal-manifold-function 'e0x R2-rect) d/dx)
              (* (literal-manifold-function 'e0y R2-rect) d/dy)))
(define e1 (+ (* (literal-manifold-function 'e1x R2-rect) d/dx)
              (* (literal-manifold-function 'e1y R2-rect) d/dy)))
(define vectors (down e0 e1))
(define dual (vector-basis->dual vectors R2-polar))

(test-case "4.1: the dual of a basis"
  (check-prints ((dual vectors) R2-rect-point) '(up (down 1 0) (down 0 1)))
  (define v
    (* (up (literal-manifold-function 'b^0 R2-rect) (literal-manifold-function 'b^1 R2-rect))
       vectors))
  (check-prints ((dual v) R2-rect-point) '(up (b^0 (up x0 y0)) (b^1 (up x0 y0)))))

(test-case "4.2: components in another basis"
  (define polar (coordinate-system->basis R2-polar))
  (define b (literal-vector-field 'b R2-rect))
  (define b-rect ((coordinate-system->1form-basis R2-rect) b))
  (define b-polar (* (Jacobian polar (coordinate-system->basis R2-rect)) b-rect))
  (define R^2 (+ (square 'x0) (square 'y0)))
  (define (component k)
    ((literal-function k '(-> (UP Real Real) Real)) (up 'x0 'y0)))
  (define expected
    (up (/ (+ (* 'x0 (component 'b^0)) (* 'y0 (component 'b^1))) (sqrt R^2))
        (/ (+ (* 'x0 (component 'b^1)) (* -1 'y0 (component 'b^0))) R^2)))
  (check-identity (b-polar R2-rect-point) expected)
  (check-identity (((coordinate-system->1form-basis R2-polar) b) R2-rect-point) expected))

;; ---------------------------------------------------------------------------
;; 4.3, 4.4

(test-case "4.4: the commutator of a basis in polar coordinates"
  (define polar (coordinate-system->basis R2-polar))
  (define vector-basis (basis->vector-basis polar))
  (define forms (basis->1form-basis polar))
  (define f (literal-manifold-function 'f-rect R2-rect))
  (check-identity ((- ((commutator e0 e1) f)
                      (* (- (e0 (forms e1)) (e1 (forms e0))) (vector-basis f)))
                   R2-rect-point)
                  0))

(test-case "4.4: generators of rotations of space"
  (define-coordinates (up x y z) R3-rect)
  (define Jz (- (* x d/dy) (* y d/dx)))
  (define Jx (- (* y d/dz) (* z d/dy)))
  (define Jy (- (* z d/dx) (* x d/dz)))
  (define g (literal-manifold-function 'g-rect R3-rect))
  (define m ((point R3-rect) (up 'x0 'y0 'z0)))
  (check-prints (((+ (commutator Jx Jy) Jz) g) m) 0)
  (check-prints (((+ (commutator Jy Jz) Jx) g) m) 0)
  (check-prints (((+ (commutator Jz Jx) Jy) g) m) 0)
  (check-identity (commutator Jx Jy) (- Jz)))

(define-coordinates (up Theta phi psi) Euler-angles)
(define e_x (+ (* (cos phi) d/dTheta)
               (* -1 (/ (* (sin phi) (cos Theta)) (sin Theta)) d/dphi)
               (* (/ (sin phi) (sin Theta)) d/dpsi)))
(define e_y (+ (* (/ (* (cos phi) (cos Theta)) (sin Theta)) d/dphi)
               (* (sin phi) d/dTheta)
               (* -1 (/ (cos phi) (sin Theta)) d/dpsi)))
(define e_z d/dphi)

(test-case "4.3, 4.4: rotations about the axes are a basis of SO(3)"
  (define f (literal-manifold-function 'f-Euler Euler-angles))
  (define m ((point Euler-angles) (up 'theta 'phi 'psi)))
  (check-prints (((+ (commutator e_x e_y) e_z) f) m) 0)
  (check-prints (((+ (commutator e_y e_z) e_x) f) m) 0)
  (check-prints (((+ (commutator e_z e_x) e_y) f) m) 0))

;; M(Euler's angles) as a function on SO(3), entry by entry: e_x M is the derivative of Rx(ε) M.
(define M
  (let ([angles (chart Euler-angles)])
    (lambda (m)
      (define-values (theta phi psi) (apply values (structure->list (angles m))))
      (* (Rz-matrix phi) (Rx-matrix theta) (Rz-matrix psi)))))

(define (entry i j) (lambda (m) (ref (M m) i j)))

(test-case "4.3: they are the velocities of turning about the axes"
  (define m ((point Euler-angles) (up 'theta 'phi 'psi)))
  (for* ([field+turn (list (cons e_x Rx-matrix) (cons e_y Ry-matrix)
                           (cons e_z Rz-matrix))]
         [i (in-range 3)] [j (in-range 3)])
    (check-identity (((car field+turn) (entry i j)) m)
                    ((D (lambda (angle) (ref (* ((cdr field+turn) angle) (M m)) i j))) 0))))
