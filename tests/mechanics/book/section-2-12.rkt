#lang racket/base
;; SICM 2.12, Nonsingular Coordinates and Quaternions (pp. 181-191).

(require mechanics
         mechanics/scmutils
         mechanics/book
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/session.rkt")

(define q (quaternion 'q_0 'q_1 'q_2 'q_3))
(define p (quaternion 'p_0 'p_1 'p_2 'p_3))

;; ---------------------------------------------------------------------------
;; Rotations

(test-case "p. 184: the rotation by an angle about an axis"
  (define n (up 'x 'y (sqrt (- 1 (square 'x) (square 'y)))))
  (define M (angle-axis->rotation-matrix 'theta n))
  (check-identity (* M n) n)
  (check-identity (trace M) (+ 1 (* 2 (cos 'theta))))
  (check-pred proved? (verify-rotation M))
  (check-identity (quaternion->rotation-matrix (angle-axis->quaternion 'theta n)) M))

(test-case "p. 184: by colatitude and longitude of the axis"
  (define axis (up (* (sin 'c) (cos 'l)) (* (sin 'c) (sin 'l)) (cos 'c)))
  (define to-axis (* (Rz-matrix 'l) (Ry-matrix 'c)))
  (check-identity (angle-axis->rotation-matrix 'theta axis)
                  (* to-axis (Rz-matrix 'theta) (transpose to-axis))))

(test-case "p. 185: the matrix of a quaternion"
  (define m^2 '(+ (expt q_0 2) (expt q_1 2) (expt q_2 2) (expt q_3 2)))
  (define M (quaternion->rotation-matrix q))
  (check-prints (ref M 0 0)
                `(/ (+ (expt q_0 2) (expt q_1 2) (* -1 (expt q_2 2)) (* -1 (expt q_3 2))) ,m^2))
  (check-prints (ref M 0 1) `(/ (* 2 (- (* q_1 q_2) (* q_0 q_3))) ,m^2))
  (check-prints (ref M 1 0) `(/ (* 2 (+ (* q_0 q_3) (* q_1 q_2))) ,m^2))
  (check-pred proved? (verify-rotation M))
  (check-identity (quaternion->rotation-matrix (* 'k q)) M)
  (check-identity (quaternion->rotation-matrix (- q)) M))

(test-case "the matrix of a product is the product of the matrices, in the same order"
  (check-identity (quaternion->rotation-matrix (* q p))
                  (* (quaternion->rotation-matrix q) (quaternion->rotation-matrix p)))
  (check-pred refuted?
              (verify-equal (quaternion->rotation-matrix (* q p))
                            (* (quaternion->rotation-matrix p) (quaternion->rotation-matrix q)))))

(test-case "a vector between a quaternion and its conjugate is turned"
  (define unit (angle-axis->quaternion 'theta (up 0 0 1)))
  (check-identity (quaternion->3vector (* unit (quaternion 0 'x 'y 'z) (q:conjugate unit)))
                  ((rotate-z 'theta) (up 'x 'y 'z)))
  (check-close ((q:rotate (angle-axis->quaternion 0.3 (up 0 0.6 0.8))) (up 1 2 3))
               (* (angle-axis->rotation-matrix 0.3 (up 0 0.6 0.8)) (up 1 2 3))
               1e-14))

(test-case "p. 184: from a quaternion to its angle and axis, and by them to the matrix"
  (define given (angle-axis->quaternion 0.7 (up 0.48 0.64 0.6)))
  (define found (quaternion->angle-axis given))
  (check-= (car found) 0.7 1e-15)
  (check-close (cadr found) (up 0.48 0.64 0.6) 1e-15)
  (check-close (quaternion->angle-axis given list) found 1e-18)
  (check-close (* (quaternion->RM given) (up 1 2 3))
               (* (quaternion->rotation-matrix given) (up 1 2 3)) 1e-14))

(test-case "from a matrix to the quaternion, wherever its greatest part is"
  (for ([four (list '(.9 .1 .3 .2) '(.1 .9 .3 .2) '(.1 .3 .9 -.2) '(.1 -.3 .2 .9)
                    '(0. 1. 0. 0.) '(0. 0. 1. 0.) '(0. 0. 0. 1.) '(1. 0. 0. 0.)
                    '(.001 .6 .6 .6))])
    (define unit (q:make-unit (make-quaternion four)))
    (check-close (quaternion->vector
                  (rotation-matrix->quaternion (quaternion->rotation-matrix unit)))
                 (quaternion->vector unit) 1e-14))
  (define M (Euler->M (up 0.4 0.5 0.6)))
  (check-close (* (quaternion->rotation-matrix (rotation-matrix->quaternion M)) (up 1 2 3))
               (* M (up 1 2 3)) 1e-14))

(test-case "symbols: a rotation about an axis comes back, where the angle is small"
  (define found (rotation-matrix->quaternion (Rz-matrix 'a)))
  (check-identity (quaternion->rotation-matrix found) (Rz-matrix 'a)))

;; ---------------------------------------------------------------------------
;; The units as matrices

(test-case "p. 186: the units multiply as i, j and k do"
  (define one (identity-matrix 4))
  (for ([unit (list q:i q:j q:k)]) (check-equal? (* unit unit) (* -1 one)))
  (check-equal? (* q:i q:j) q:k)
  (check-equal? (* q:j q:k) q:i)
  (check-equal? (* q:k q:i) q:j)
  (check-equal? (* q:j q:i) (* -1 q:k))
  (check-identity (quaternion->4x4 q)
                  (+ (* 'q_0 one) (* 'q_1 q:i) (* 'q_2 q:j) (* 'q_3 q:k)))
  (check-identity (quaternion->4x4 (* q p)) (* (quaternion->4x4 q) (quaternion->4x4 p)))
  (check-equal? (4x4->quaternion (quaternion->4x4 q)) q))

;; ---------------------------------------------------------------------------
;; Angular velocity

(define s (up 't (up 'a 'b 'c 'd) (up 'a^ 'b^ 'c^ 'd^)))
(define m^2 '(+ (expt a 2) (expt b 2) (expt c 2) (expt d 2)))

(test-case "p. 186: the angular velocity on the body, by the units"
  (define Q (coordinate s))
  (define (part unit) (/ (* 2 (dot-product Q (* unit (velocity s)))) (square Q)))
  (check-identity (quaternion-state->omega-body s) (up (part q:i) (part q:j) (part q:k)))
  (check-prints (ref (quaternion-state->omega-body s) 0)
                `(/ (* 2 (+ (* a b^) (* -1 a^ b) (* -1 c d^) (* c^ d))) ,m^2))
  (check-prints (ref (quaternion-state->omega-space s) 0)
                `(/ (* 2 (+ (* a b^) (* -1 a^ b) (* c d^) (* -1 c^ d))) ,m^2)))

(test-case "it is that of the matrix along a path"
  (define (M q) (quaternion->rotation-matrix (make-quaternion q)))
  (check-identity ((M->omega-body M) s) (up->column-matrix (quaternion-state->omega-body s)))
  (check-identity ((M->omega M) s) (up->column-matrix (quaternion-state->omega-space s))))

(test-case "the kinetic energy"
  (check-identity ((T-quaternion-state 'A 'B 'C) s)
                  ((T-body 'A 'B 'C) (quaternion-state->omega-body s)))
  (check-prints ((T-quaternion-state 'A 'B 'C) (up 1 (up 1 2 3 4) (up 2 3 4 5)))
                '(+ (* 8/225 B) (* 2/225 C))))

;; ---------------------------------------------------------------------------
;; The free body

(define qw (up 't (up 'a 'b 'c 'd) (up 'w_a 'w_b 'w_c)))

(test-case "p. 189: the derivative of the state is that of the book"
  (define Q (coordinate qw))
  (check-identity ((qw-sysder 'A 'B 'C) qw)
                  (up 1
                      (* -1/2 (+ (* 'w_a (* q:i Q)) (* 'w_b (* q:j Q)) (* 'w_c (* q:k Q))))
                      (up (* (/ (- 'B 'C) 'A) 'w_b 'w_c)
                          (* (/ (- 'C 'A) 'B) 'w_c 'w_a)
                          (* (/ (- 'A 'B) 'C) 'w_a 'w_b)))))

;; The rate of a function of the state along the motion
(define (rate f) (* ((D f) qw) ((qw-sysder 'A 'B 'C) qw)))

(test-case "p. 190: energy, angular momentum in space and the length of q are conserved"
  (check-identity (rate (lambda (s) ((T-body 'A 'B 'C) (ref s 2)))) 0)
  (check-identity (rate (qw-state->L-space 'A 'B 'C)) (down 0 0 0))
  (check-identity (rate (lambda (s) (square (coordinate s)))) 0)
  (check-pred refuted? (prove-zero (rate (qw-state->L-body 'A 'B 'C)))))

(test-case "the state moves with the angular velocity it holds"
  (check-identity (quaternion-state->omega-body
                   (up 't (coordinate qw) (ref ((qw-sysder 'A 'B 'C) qw) 1)))
                  (up 'w_a 'w_b 'w_c)))

(define-values (A B C) (values 1.0 (sqrt 2.0) 2.0))
(define Euler-start (up 0 (up 1 0 0) (up .1 .1 .1)))
(define start
  (up 0
      (quaternion->vector (rotation-matrix->quaternion (Euler->M (coordinate Euler-start))))
      (Euler-state->omega-body Euler-start)))
(define motion (evolve-trajectory (qw-sysder A B C) start 100 #:tolerance 1e-14))

(test-case "p. 190: after 100 s"
  (check-close (coordinate (motion 100))
               (up -.9501831654548522 -.05699715799969905 -.3054905540187315 .024058210063923138)
               1e-10)
  (check-close (ref (motion 100) 2)
               (up -.07215083472579217 -.1134368298947756 .1484260290508362) 1e-10))

(test-case "p. 191: errors stay below 1e-13, and |q| is 1 to rounding"
  (define E0 ((T-body A B C) (ref start 2)))
  (define L0 ((qw-state->L-space A B C) start))
  (check-close ((qw-state->L-body A B C) start) ((L-body A B C) (ref start 2)) 1e-18)
  (for ([t (in-range 0 101)])
    (define s (motion t))
    (check-= (square (coordinate s)) 1 1e-13)
    (check-true (< (abs (relative-error ((T-body A B C) (ref s 2)) E0)) 1e-13))
    (for ([i 3])
      (check-true (< (abs (relative-error (ref ((qw-state->L-space A B C) s) i) (ref L0 i)))
                     1e-13)))))

(test-case "both representations are at the same place"
  (define end ((state-advancer rigid-sysder A B C) Euler-start 100. 1e-13))
  (check-close (* (Euler->M (coordinate end)) (up 1 2 3))
               (* (quaternion->rotation-matrix (make-quaternion (coordinate (motion 100))))
                  (up 1 2 3))
               1e-10))

;; ---------------------------------------------------------------------------
;; The mass matrix of four coordinates for three ways to turn

(define local (up 't (up 'q_0 'q_1 'q_2 'q_3) (up 'v_0 'v_1 'v_2 'v_3)))
(define T (T-quaternion-state 'A 'B 'C))
(define S (((square (partial 2)) T) local))
(define mass (s->m (velocity local) S (velocity local)))
(define length^2 (square (coordinate local)))

(test-case "turns about the axes of the body have the inertia 4 A, 4 B and 4 C over |q|²"
  (for ([unit (list q:i q:j q:k)] [moment '(A B C)])
    (define turn (* unit (coordinate local)))
    (check-identity (* mass turn) (* 4 moment (/ turn length^2)))))

;; Zeros, if two tuples of four are along one line
(define (cross-minors a b)
  (for/list ([i '(1 2 3)]) (- (* (ref a 0) (ref b i)) (* (ref a i) (ref b 0)))))

(test-case "a change of the length has none: the determinant is 0, and the direction is named"
  (check-identity (* mass (coordinate local)) (up 0 0 0 0))
  (check-identity (determinant S) 0)
  (check-equal? (rank mass) 3)
  (define failure
    (with-handlers ([exn:fail:mechanics:singular:matrix? values])
      ((Lagrangian->acceleration T) local)))
  (define directions (exn:fail:mechanics:singular:matrix-null-vectors failure))
  (check-equal? (length directions) 1)
  (for ([x (cross-minors (car directions) (coordinate local))]) (check-identity x 0))
  (check-true (regexp-match? #rx"no inertia in the direction: [(]up q_0 q_1 q_2 q_3[)]"
                             (exn-message failure)))
  (check-true (< (string-length (exn-message failure)) 3000) "it is simplified"))

(test-case "the energy is the one of the body, for a quaternion of any length"
  (check-identity (T local) ((T-body 'A 'B 'C) (quaternion-state->omega-body local)))
  (check-identity (T local) (* 1/2 (dot-product (velocity local) (* mass (velocity local))))))

(test-case "with the length held the Hessian is positive: sums of squares of ω"
  (define omega (quaternion-state->omega-body local))
  (check-identity (* 2 (T local))
                  (apply + (map (lambda (moment w) (* moment (square w)))
                                '(A B C) (structure->list omega)))))

;; ---------------------------------------------------------------------------
;; Mistakes

(says
 [((qw-sysder 1 2 3) (up 0 (up 1 2 3 4) (up 1 0 0)))
  "qw-sysder: the quaternion is to have the length 1; given (up 1 2 3 4), an up tuple of 4\n"
  "  its length: 5.477225575051661"]
 [((qw-state->L-space 1 2 3) (up 0 (up 1 0 0) (up 1 0 0)))
  "qw-state->L-space: expected the coordinates of a quaternion, a tuple of 4 components; "
  "given (up 1 0 0), an up tuple of 3"]
 [((qw-sysder 1 2 3) (up 0 (up 1 0 0 0) (up 1 0 0 0)))
  "qw-sysder: expected the angular velocity on the body, a tuple of 3 components; "
  "given (up 1 0 0 0), an up tuple of 4"]
 [(quaternion-state->omega-body (up 0 (up 1 0 0 0) (up 1 0 0)))
  "quaternion-state->omega-body: expected the velocities of a quaternion, a tuple of 4 "
  "components; given (up 1 0 0), an up tuple of 3"]
 [((q:rotate (quaternion 1 1 0 0)) (up 1 2 3))
  "q:rotate: the quaternion is to have the length 1; given (up 1 1 0 0), an up tuple of 4\n"
  "  its length: 1.4142135623730951"]
 [(quaternion->angle-axis (quaternion 1 0 0 0))
  "quaternion->angle-axis: a quaternion without a vector part turns nothing and has no axis; "
  "given (quaternion 1 0 0 0), a quaternion"]
 [(quaternion->rotation-matrix (quaternion 0 0 0 0))
  "quaternion->rotation-matrix: the quaternion 0 is no rotation"]
 [(quaternion->rotation-matrix (up 1 0 0 0))
  "quaternion->rotation-matrix: expected a quaternion\n  given: (up 1 0 0 0), an up tuple of 4\n"
  "  (make-quaternion ...) makes one of a tuple of 4"]
 [(rotation-matrix->quaternion (matrix-by-rows '(1 2 0) '(0 1 0) '(0 0 1)))
  "rotation-matrix->quaternion: the matrix is no rotation: its transpose times it is not 1\n"
  "  given: (matrix-by-rows (list 1 2 0) (list 0 1 0) (list 0 0 1))\n"
  "  the product less 1: (matrix-by-rows (list 0 2 0) (list 2 4 0) (list 0 0 0))"])
