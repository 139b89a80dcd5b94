#lang racket/base
;; SICM 2.2, Kinematics of Rotation (pp. 122-126).

(require mechanics
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/session.rkt")

(define w (up 'omega^x 'omega^y 'omega^z))
(define v (up 'x 'y 'z))

(test-case "p. 126: the antisymmetric matrix of a vector multiplies as the vector does"
  (define A (3vector-components->antisymmetric w))
  (check-prints A '(matrix-by-rows (list 0 (* -1 omega^z) omega^y)
                                   (list omega^z 0 (* -1 omega^x))
                                   (list (* -1 omega^y) omega^x 0)))
  (check-true (m:antisymmetric? A))
  (check-identity (* A v) (cross-product w v))
  (check-equal? (antisymmetric->column-matrix A) (up->column-matrix w))
  (check-equal? (wcross->w A) w)
  (check-equal? (wcross->w (m->s (down 0 0 0) A (up 0 0 0))) w))

(test-case "what is antisymmetric, and what is not"
  (check-true (m:antisymmetric? (matrix-by-rows (list 0 'a) (list (- 'a) 0))))
  (check-true (m:antisymmetric?
               (matrix-by-rows (list 0 (square (sin 'x))) (list (- (square (cos 'x)) 1) 0))))
  (check-false (m:antisymmetric? (matrix-by-rows '(0 a) '(a 0))))
  (check-false (m:antisymmetric? (matrix-by-rows '(0 1 2) '(-1 0 3)))))

(test-case "p. 126: a rotation about each axis has its rate about that axis"
  (define angle (literal-function 'alpha))
  (define rate '((D alpha) t))
  (for ([M (list Rx-matrix Ry-matrix Rz-matrix)] [k 3])
    (define column
      (cons 'matrix-by-rows (for/list ([i 3]) (list 'list (if (= i k) rate 0)))))
    (check-prints (((M-of-q->omega-of-t M) angle) 't) column)
    (check-prints (((M-of-q->omega-body-of-t M) angle) 't) column)))

(test-case "p. 125: a turn of the whole turns the rate in space and leaves that on the body"
  (define turn (* (Rx-matrix 'a) (Ry-matrix 'b)))
  (define (turned q) (* turn (Rz-matrix q)))
  (define state (up 't 'psi 'psidot))
  (check-identity ((M->omega turned) state) (* turn ((M->omega Rz-matrix) state)))
  (check-identity ((M->omega-body turned) state) ((M->omega-body Rz-matrix) state)))

(test-case "velocities of the body's points are omega times their positions"
  (define axis (up 0 (sin 'beta) (cos 'beta)))
  (define angle (literal-function 'alpha))
  (define (M q) (angle-axis->rotation-matrix q axis))
  (define (position t) (* (M (angle t)) v))
  (define omega (column-matrix->up (((M-of-q->omega-of-t M) angle) 't)))
  (check-identity omega (* ((D angle) 't) axis))
  (check-identity ((D position) 't) (cross-product omega (position 't))))

(test-case "with numbers, along a path"
  (define path (up sin cos (lambda (t) (* 2 t))))
  (define omega (((M-of-q->omega-of-t Euler->M) path) 0.3))
  (check-close (column-matrix->up omega)
               (Euler-state->omega-space ((Gamma path) 0.3))
               1e-14))

;; ---------------------------------------------------------------------------
;; Matrices that are no rotations

(define x (literal-function 'x))
(define (shrinking q) (matrix-by-rows (list (cos q) 0 0) '(0 1 0) '(0 0 1)))
(define (mirror q) (matrix-by-rows '(1 0 0) '(0 1 0) '(0 0 -1)))
(define (flat q) (matrix-by-rows (list (cos q) (- (sin q))) (list (sin q) (cos q))))

(says
 [(((M-of-q->omega-of-t shrinking) x) 't)
  "M-of-q->omega-of-t: the matrix is no rotation: its transpose times it is not 1\n"
  "  given: (matrix-by-rows (list (cos (x t)) 0 0) (list 0 1 0) (list 0 0 1))\n"
  "  the product less 1: (matrix-by-rows (list (* -1 (expt (sin (x t)) 2)) 0 0) (list 0 0 0) "
  "(list 0 0 0))"]
 [(((M-of-q->omega-body-of-t mirror) x) 't)
  "M-of-q->omega-body-of-t: the matrix reflects: its determinant is −1, that of a rotation 1\n"
  "  given: (matrix-by-rows (list 1 0 0) (list 0 1 0) (list 0 0 -1))"]
 [(((M-of-q->omega-of-t flat) x) 't)
  "M-of-q->omega-of-t: expected a rotation, a 3 by 3 matrix\n  given: (matrix-by-rows "
  "(list (cos (x t)) (* -1 (sin (x t)))) (list (sin (x t)) (cos (x t)))), a 2 by 2 matrix"]
 [(M-of-q->omega-of-t (Rx-matrix 'a))
  "M-of-q->omega-of-t: expected a function from coordinates to a rotation; given "
  "(matrix-by-rows (list 1 0 0) (list 0 (cos a) (* -1 (sin a))) (list 0 (sin a) (cos a))), "
  "a 3 by 3 matrix"]
 [((M-of-q->omega-of-t Euler->M) 'theta)
  "M-of-q->omega-of-t: a path is a function of time, or a tuple of such functions; "
  "given the symbol theta\n  (literal-function 'theta) makes a path of that name"]
 [(antisymmetric->column-matrix (matrix-by-rows '(0 1 2) '(-1 0 3) '(-2 4 0)))
  "antisymmetric->column-matrix: expected an antisymmetric 3 by 3 matrix\n  given: "
  "(matrix-by-rows (list 0 1 2) (list -1 0 3) (list -2 4 0)), a 3 by 3 matrix\n"
  "  with its transpose it adds up to: "
  "(matrix-by-rows (list 0 0 0) (list 0 0 7) (list 0 7 0))"])

(test-case "numbers that are no rotation are refused too, and rounding is not"
  (check-exn #rx"is no rotation"
             (lambda () (((M-of-q->omega-of-t shrinking) (lambda (t) t)) 0.1)))
  (define turned (* (Rx-matrix 0.1) (Rz-matrix 0.7)))
  (check-pred matrix? (((M-of-q->omega-of-t (lambda (q) (* turned (Ry-matrix q)))) sin) 0.1)))
