#lang racket/base
;; SICM 2.3 to 2.7: kinetic energy, angular momentum and Euler angles (pp. 128-141).

(require mechanics
         mechanics/scmutils
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/session.rkt")

(define omega (up 'omega^a 'omega^b 'omega^c))
(define angles (up 'theta 'phi 'psi))
(define state (up 't angles (up 'thetadot 'phidot 'psidot)))
(define path (up (literal-function 'theta) (literal-function 'phi) (literal-function 'psi)))

(test-case "p. 134: the kinetic energy of rotation"
  (check-prints ((T-body 'A 'B 'C) omega)
                '(+ (* 1/2 A (expt omega^a 2)) (* 1/2 B (expt omega^b 2))
                    (* 1/2 C (expt omega^c 2))))
  (check-identity ((T-body 'A 'B 'C) (up->column-matrix omega)) ((T-body 'A 'B 'C) omega)))

(test-case "p. 137: the angular momentum on the body, and in space"
  (check-prints ((L-body 'A 'B 'C) omega) '(down (* A omega^a) (* B omega^b) (* C omega^c)))
  (check-identity ((L-body 'A 'B 'C) omega) ((D (T-body 'A 'B 'C)) omega))
  (check-prints (((L-space (Rz-matrix 'phi)) 'A 'B 'C) omega)
                '(down (- (* A omega^a (cos phi)) (* B omega^b (sin phi)))
                       (+ (* A omega^a (sin phi)) (* B omega^b (cos phi)))
                       (* C omega^c))))

(test-case "what is made of moments and matrices prints as what makes it"
  (check-equal? (expression (T-body-Euler 'A 'B 'C)) '(T-body-Euler A B C))
  (check-equal? (expression (L-body 'A 'B 'C)) '(L-body A B C))
  (define M (identity-matrix 3))
  (check-equal? (expression ((L-space M) 'A 'B 'C)) `((L-space ,(expression M)) A B C))
  (check-equal? (expression (Euler-equations 1 2 3)) '(Euler-equations 1 2 3))
  (check-equal? (expression (M-of-q->omega-of-t Rx-matrix))
                '(M-of-q->omega-of-t rotate-x-matrix))
  (check-equal? (expression (q:rotate (quaternion 1 0 0 0))) '(q:rotate (quaternion 1 0 0 0))))

(test-case "p. 139: the matrices of rotations about two axes, and of Euler angles"
  (check-prints (Rz-matrix 'phi)
                '(matrix-by-rows (list (cos phi) (* -1 (sin phi)) 0)
                                 (list (sin phi) (cos phi) 0)
                                 (list 0 0 1)))
  (check-prints (Rx-matrix 'theta)
                '(matrix-by-rows (list 1 0 0)
                                 (list 0 (cos theta) (* -1 (sin theta)))
                                 (list 0 (sin theta) (cos theta))))
  (check-identity (Euler->M angles) (* (Rz-matrix 'phi) (Rx-matrix 'theta) (Rz-matrix 'psi)))
  (check-pred proved? (verify-rotation (Euler->M angles))))

(test-case "p. 140: the angular velocity on the body along a path"
  (check-prints
   (((M-of-q->omega-body-of-t Euler->M) path) 't)
   '(matrix-by-rows
     (list (+ (* ((D phi) t) (sin (theta t)) (sin (psi t))) (* (cos (psi t)) ((D theta) t))))
     (list (- (* ((D phi) t) (sin (theta t)) (cos (psi t))) (* (sin (psi t)) ((D theta) t))))
     (list (+ (* ((D phi) t) (cos (theta t))) ((D psi) t)))))
  (check-equal? (simplify ((Euler->omega-body path) 't))
                (simplify (((M-of-q->omega-body-of-t Euler->M) path) 't))))

(test-case "p. 140: as a function of the state"
  (check-prints ((M->omega-body Euler->M) state)
                '(matrix-by-rows
                  (list (+ (* phidot (sin theta) (sin psi)) (* thetadot (cos psi))))
                  (list (- (* phidot (sin theta) (cos psi)) (* thetadot (sin psi))))
                  (list (+ (* phidot (cos theta)) psidot))))
  (check-identity ((M->omega-body Euler->M) state)
                  (up->column-matrix (Euler-state->omega-body state)))
  (check-identity ((M->omega Euler->M) state)
                  (up->column-matrix (Euler-state->omega-space state)))
  (check-identity ((Euler->omega path) 't)
                  (up->column-matrix (Euler-state->omega-space ((Gamma path) 't))))
  (check-identity (* (Euler->M angles) (Euler-state->omega-body state))
                  (Euler-state->omega-space state)))

(define T (T-body-Euler 'A 'B 'C))

(test-case "p. 141: the kinetic energy and the momenta in Euler angles"
  (check-identity (T state) ((T-body 'A 'B 'C) (Euler-state->omega-body state)))
  (check-prints (ref (((partial 2) T) state) 1)
                '(+ (* (expt (sin theta) 2) phidot
                       (+ (* A (expt (sin psi) 2)) (* B (expt (cos psi) 2))))
                    (* thetadot (cos psi) (sin psi) (sin theta) (- A B))
                    (* C phidot (expt (cos theta) 2))
                    (* C psidot (cos theta)))))

(test-case "the momentum of phi is the angular momentum about the z axis in space"
  (check-identity (ref (((partial 2) T) state) 1) (ref ((L-space-Euler 'A 'B 'C) state) 2))
  (check-identity (ref (((partial 2) T) state) 2) (ref ((L-body-Euler 'A 'B 'C) state) 2)))

(test-case "p. 144: the determinant of the masses"
  (check-prints (determinant (((square (partial 2)) T) state)) '(* A B C (expt (sin theta) 2))))

(test-case "the length of the angular momentum is the same on the body and in space"
  (check-identity (square ((L-space-Euler 'A 'B 'C) state))
                  (square ((L-body-Euler 'A 'B 'C) state))))

(test-case "from a rotation back to its angles"
  (check-close (M->Euler (Rx-matrix 0.4)) (up 0.4 0 0) 1e-15)
  (for ([angles (list (up .3 .4 .5) (up 3. -2. 1.) (up 1e-6 3 -3))])
    (check-close (M->Euler (Euler->M angles)) angles 1e-9)))

(test-case "exercise 2.9 the other way round: rotate-y, then x, then z, and its own omega"
  (define (M (up a b c)) (* (Ry-matrix a) (Rx-matrix b) (Rz-matrix c)))
  (define s (up 't (up 'a 'b 'c) (up 'adot 'bdot 'cdot)))
  (check-identity ((M->omega-body M) s) (* (transpose (M (coordinate s))) ((M->omega M) s)))
  (check-prints (determinant (((square (partial 2))
                               (compose (T-body 'A 'B 'C) (M->omega-body M)))
                              s))
                '(* A B C (expt (cos b) 2))))

;; ---------------------------------------------------------------------------
;; Rotations of tuples

(define v (up 'x 'y 'z))

(test-case "the procedures, the matrices and the tuples turn in the same way"
  (for ([turn (list rotate-x rotate-y rotate-z)]
        [M (list rotate-x-matrix rotate-y-matrix rotate-z-matrix)]
        [tuple (list rotate-x-tuple rotate-y-tuple rotate-z-tuple)]
        [axis (list (up 1 0 0) (up 0 1 0) (up 0 0 1))])
    (check-identity ((turn 'a) v) (* (M 'a) v))
    (check-identity (* (tuple 'a) v) (* (M 'a) v))
    (check-identity (angle-axis->rotation-matrix 'a axis) (M 'a)))
  (check-prints (rotate-z-tuple 'a)
                '(down (up (cos a) (sin a) 0) (up (* -1 (sin a)) (cos a) 0) (up 0 0 1))))

(test-case "they turn one axis to the next by a quarter"
  (check-close ((rotate-x (/ pi 2)) (up 0 1 0)) (up 0 0 1) 1e-15)
  (check-close ((rotate-y (/ pi 2)) (up 0 0 1)) (up 1 0 0) 1e-15)
  (check-close ((rotate-z (/ pi 2)) (up 1 0 0)) (up 0 1 0) 1e-15))

;; ---------------------------------------------------------------------------
;; Mistakes

(says
 [(Euler->M (up 'theta 'phi))
  "Euler->M: expected the Euler angles (up theta phi psi), a tuple of 3 components; "
  "given (up theta phi), an up tuple of 2"]
 [(Euler->M '(1 2 3))
  "Euler->M: expected the Euler angles (up theta phi psi), a tuple of 3 components; "
  "given (1 2 3), a list\n  a list is not a tuple; use (up x y z)"]
 [(Euler-state->omega-body angles)
  "Euler-state->omega-body: expected the Euler angles (up theta phi psi), a tuple of 3 components; "
  "given the symbol phi"]
 [(Euler-state->omega-body (up 't angles (up 1 2)))
  "Euler-state->omega-body: expected the rates of the Euler angles, a tuple of 3 components; "
  "given (up 1 2), an up tuple of 2"]
 [((T-body 'A 'B 'C) (up 1 2))
  "T-body: expected the angular velocity, a tuple of 3 components; given (up 1 2), an up tuple of 2"]
 [((L-space angles) 'A 'B 'C)
  "L-space: expected a rotation, a 3 by 3 matrix\n  given: (up theta phi psi), an up tuple of 3"]
 [(angle-axis->rotation-matrix 'a (up 1 0 1))
  "angle-axis->rotation-matrix: the axis is to have the length 1; given (up 1 0 1), "
  "an up tuple of 3\n  its length: 1.4142135623730951"])

(test-case "angles that are not determined are said to be so"
  (define M (Rz-matrix 0.5))
  (check-message
   (string-append
    "M->Euler: Euler angles are singular where sin θ = 0: φ and ψ turn about one axis there\n"
    "  quaternions are not: see qw-sysder and rotation-matrix->quaternion\n"
    "  given: (matrix-by-rows (list 0.8775825618903728 -0.479425538604203 0) "
    "(list 0.479425538604203 0.8775825618903728 0) (list 0 0 1))")
   (M->Euler M)
   exn:fail:mechanics:singular?))
