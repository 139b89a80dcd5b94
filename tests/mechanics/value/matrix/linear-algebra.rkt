#lang racket/base
;; Linear algebra on matrices and on structures: determinants, transposes,
;; systems, and structures as matrices.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/error/failure
         mechanics/value/matrix/linear-algebra
         mechanics/value/matrix/matrix
         mechanics/value/structure
         mechanics/calculus/derivative
         "../../support/checks.rkt" "../../support/random.rkt" "../../support/same.rkt"
         "../../support/random/element.rkt")

(define scalars (list random-rational random-flonum random-expression random-dual))

;; ---------------------------------------------------------------------------
;; Determinants

(test-case "determinants of small matrices by hand"
  (check-equal? (determinant (matrix-by-rows '(1 2) '(3 4))) -2)
  (check-equal? (determinant (matrix-by-rows '(2 0 1) '(1 3 2) '(1 1 1))) 0)
  (check-true (same? (determinant (matrix-by-rows '(a b) '(c d))) (g:- (g:* 'a 'd) (g:* 'b 'c))))
  (check-equal? (determinant (identity-matrix 6)) 1)
  (check-equal? (determinant (matrix-by-rows '(0 1) '(1 0))) -1))

(test-case "a tuple of tuples is accepted where a matrix is meant"
  (check-equal? (determinant (down (down 1 2) (down 3 4))) -2)
  (check-equal? (determinant (up (down 1 2) (down 3 4))) -2)
  (check-equal? (trace (down (up 1 2) (up 3 4))) 5)
  (check-exn
   #rx"^determinant: expected as many components in each component as there are components"
   (lambda () (determinant (up (up 1 2 3) (up 1 2 3))))))

(test-case "the determinant multiplies, ignores transposition, scales with each row"
  (with-seed 321
    (for* ([scalar (in-list scalars)] [n '(1 2 3 4)])
      (define A (random-matrix scalar n))
      (define B (random-matrix random-rational n))
      (check-true (same? (determinant (g:* A B)) (g:* (determinant A) (determinant B)) 1e-7))
      (check-true (same? (determinant (transpose A)) (determinant A) 1e-7))
      (check-true (same? (determinant (g:* 2 A)) (g:* (expt 2 n) (determinant A)) 1e-7))
      (check-true (same? (trace (g:* A B)) (trace (g:* B A)) 1e-7)))))

(test-case "the determinant of the Hessian of a kinetic energy"
  ;; a body with angular velocity components made of Euler angle rates: A B C sin²θ
  (define ((T A B C) local)
    (define q (ref local 1))
    (define v (ref local 2))
    (define theta (ref q 0))
    (define psi (ref q 2))
    (define wa (g:+ (g:* (ref v 0) (g:cos psi)) (g:* (ref v 1) (g:sin theta) (g:sin psi))))
    (define wb (g:- (g:* (ref v 1) (g:sin theta) (g:cos psi)) (g:* (ref v 0) (g:sin psi))))
    (define wc (g:+ (ref v 2) (g:* (ref v 1) (g:cos theta))))
    (g:* 1/2 (g:+ (g:* A (g:square wa)) (g:* B (g:square wb)) (g:* C (g:square wc)))))
  (define state (up 't (up 'theta 'phi 'psi) (up 'thetadot 'phidot 'psidot)))
  (check-true (same? (determinant (((g:square (partial 2)) (T 'A 'B 'C)) state))
                     (g:* 'A 'B 'C (g:square (g:sin 'theta))))))

;; ---------------------------------------------------------------------------
;; Transposes

(test-case "transposes of matrices and of tuples of tuples"
  (check-equal? (transpose (matrix-by-rows '(1 2 3) '(a b c)))
                (matrix-by-rows '(1 a) '(2 b) '(3 c)))
  (check-equal? (transpose (up (down 1 2 3) (down 4 5 6))) (down (up 1 4) (up 2 5) (up 3 6)))
  (with-seed 322
    (for ([_ 5])
      (define A (random-matrix random-expression 3))
      (define B (random-matrix random-rational 3))
      (check-equal? (transpose (transpose A)) A)
      (check-true (same? (transpose (g:* A B)) (g:* (transpose B) (transpose A)))))))

(test-case "of a function transpose, trace and determinant are those of its values"
  (define (f x) (matrix-by-rows (list x 1) (list 2 3)))
  (for ([operation (list transpose trace determinant)])
    (check-equal? ((operation f) 5) (operation (f 5)))
    (check-equal? (operation 5) 5)))

(test-case "the transpose of a linear map of structures moves it across the pairing"
  ;; (* p (* A x)) = (* (* (transpose A x) p) x)
  (define A (down (up 'a 'b) (up 'c 'd) (up 'e 'f)))
  (define x (up 'x 'y 'z))
  (define p (down 'p 'q))
  (check-true (same? (g:* p (g:* A x)) (g:* (g:* (transpose A x) p) x))))

;; ---------------------------------------------------------------------------
;; Systems

(test-case "solutions satisfy their system, for matrices of every kind of scalar"
  (with-seed 323
    (for* ([scalar (in-list scalars)] [n '(1 2 3)])
      (define A (random-matrix scalar n))
      (define b (s:generate n 'up (lambda (i) (random-rational))))
      (check-true (same? (g:* A (solve-linear-left A b)) b 1e-6))
      (check-true (same? (g:* (solve-linear-right (flip b) A) A) (flip b) 1e-6))
      (check-true (same? (g:* A (solve-linear-left A (up->column-matrix b)))
                         (up->column-matrix b)
                         1e-6)))))

(test-case "solutions satisfy their system, for structures of every orientation"
  (with-seed 324
    (for* ([outer (list up down)] [inner (list up down)])
      (define (pair make) (make (random-rational) (random-rational)))
      (define A (outer (pair inner) (pair inner)))
      (define b (pair inner))
      (define x (solve-linear-left A b))
      (check-equal? (g:* A x) b)
      (check-not-equal? (s:same x) (s:same A))
      ;; the unknown on the left contracts with the index that A's orientation offers
      (define c (pair (if (eq? outer inner) inner outer)))
      (check-equal? (g:* (solve-linear-right c A) A) c))))

(test-case "a mass matrix: accelerations from forces"
  ;; a down of downs takes velocities (up) to momenta (down)
  (check-equal? (solve-linear-left (down (down 2 0) (down 0 4)) (down 'F 8))
                (up (g:/ (g:* 4 'F) 8) 2)))

(test-case "scalars are systems of one equation"
  (check-equal? (solve-linear-left 2 6) 3)
  (check-equal? (solve-linear-right 'b 'a) (g:/ 'b 'a)))

(test-case "a singular system is a failure that carries the matrix"
  (define failure
    (with-handlers ([exn:fail:mechanics:singular? values])
      (solve-linear-left (matrix-by-rows '(1 2) '(2 4)) (up 1 1))))
  (check-pred exn:fail:mechanics:singular? failure)
  (check-equal? (exn-message failure)
                (string-append
                 "solve-linear-left: the matrix has no inverse\n  matrix: ((1 2) (2 4))\n  rank: 1 of 2\n"
                 "  null vector: (up -2 1)\n  dependent: row 1 is 2 times row 0\n"
                 "  solutions: none, the right-hand side not depending in the same way"))
  (check-equal? (exn:fail:mechanics:singular-where failure) (matrix-by-rows '(1 2) '(2 4)))
  (check-equal? (exn:fail:mechanics:singular:matrix-null-vectors failure) (list (up -2 1)))
  (define A (matrix-by-rows '(0 0) '(0 0)))
  (check-eq? (with-handlers ([exn:fail:mechanics:singular? exn:fail:mechanics:singular-where])
               (m:invert A))
             A)
  (check-exn exn:fail:mechanics:singular?
             (lambda () (solve-linear-left (down (down 1 2) (down 2 4)) (down 'x 'y)))))

(test-case "a system from the right fails by its own name, with null vectors from the left"
  (check-exn #rx"^solve-linear-right: the matrix has no inverse\n.*null vector: [(]down -2 1[)]\n"
             (lambda () (solve-linear-right (down 1 1) (matrix-by-rows '(1 2) '(2 4)))))
  (check-exn #rx"^solve-linear-right: expected a square matrix\n"
             (lambda () (solve-linear-right (down 1 1) (matrix-by-rows '(1 2)))))
  (check-exn #rx"^solve-linear-right: the right-hand side must be a down tuple of 2, to match "
             (lambda () (solve-linear-right 1 (down (up 1 2) (up 3 4))))))

(test-case "a right-hand side of the wrong shape is named"
  (check-exn
   #rx"^solve-linear-left: the right-hand side must be a down tuple of 2, to match [(]down [(]down 1 2[)] [(]down 3 4[)][)]; given [(]up 1 2[)], an up tuple of 2$"
   (lambda () (solve-linear-left (down (down 1 2) (down 3 4)) (up 1 2))))
  (check-exn
   #rx"^solve-linear-left: the right-hand side must be an up tuple or a matrix of 2 rows, .*; given [(]up 1 2 3[)], an up tuple of 3$"
   (lambda () (solve-linear-left (identity-matrix 2) (up 1 2 3))))
  (check-exn #rx"given [(]1 2[)], a list\n  a list is not a tuple; use [(]up x y ...[)]$"
             (lambda () (solve-linear-left (identity-matrix 2) '(1 2)))))

(test-case "elimination is stable: a Hilbert-like system of flonums"
  (define n 8)
  (define A (m:generate n n (lambda (i j) (/ 1.0 (+ 1 (abs (- i j)))))))
  (define x (s:generate n 'up (lambda (i) (exact->inexact (add1 i)))))
  (check-true (same? (solve-linear-left A (g:* A x)) x 1e-12))
  ;; a pivot that is nearly zero
  (check-true (same? (solve-linear-left (matrix-by-rows '(1e-20 1.0) '(1.0 1.0)) (up 1.0 2.0))
                     (up 1.0 1.0) 1e-12)))

(test-case "exact numbers beside flonums are decimals: the solution holds flonums alone"
  (check-equal? (solve-linear-left (matrix-by-rows '(2.0 1.0) '(1.0 1.0)) (up 1 2)) (up -1.0 3.0))
  (check-equal? (solve-linear-left (matrix-by-rows '(2 1) '(1 1)) (up 1.0 2.5)) (up -1.5 4.0)))

;; ---------------------------------------------------------------------------
;; Structures as matrices (SICM p. 353)

;; (t + u uᵀ) x = s u has the solution s u/(t + uᵀu) (Sherman and Morrison).
(test-case "derivatives of solutions, by the matrix alone and by the right-hand side alone"
  (define (solution n s t)
    (define (entry i j) (g:+ (if (= i j) t 0) (* (+ i 1) (+ j 1))))
    (solve-linear-left (m:generate n n entry)
                       (list->up (for/list ([i n]) (g:* s (+ i 1))))))
  (for ([n '(2 5)])
    (define uu (for/sum ([i n]) (* (+ i 1) (+ i 1))))
    (define (multiple-of-u c) (list->up (for/list ([i n]) (* c (+ i 1)))))
    (check-equal? ((D (lambda (t) (solution n 1 t))) 2) (multiple-of-u (/ -1 (expt (+ 2 uu) 2))))
    (check-equal? ((D (lambda (s) (solution n s 2))) 3) (multiple-of-u (/ 1 (+ 2 uu))))
    (check-equal? ((D (lambda (t) (solution n t t))) 2)
                  (multiple-of-u (/ uu (expt (+ 2 uu) 2))))))

(test-case "s->m and m->s undo one another"
  (with-seed 325
    (for* ([ls (list (down 'a 'b) (up 'a (down 'b 'c)))]
           [rs (list (up 'x 'y 'z) (up 'x (down 'y 'z)))])
      (define ms
        (s:map/r (lambda (_) (s:map/r (lambda (_) (random-rational)) (flip ls))) (flip rs)))
      (define M (s->m ls ms rs))
      (check-equal? (list (m:num-rows M) (m:num-cols M)) (list (s:dimension ls) (s:dimension rs)))
      (check-equal? (m->s ls M rs) ms)
      (check-equal? (s->m ls (m->s ls M rs) rs) M))))

(test-case "the derivative of a canonical transformation as a matrix"
  ;; (x, p) to polar phase space coordinates: det = 1
  (define ((polar alpha) state)
    (define theta (ref state 1))
    (define I (ref state 2))
    (up (ref state 0)
        (g:* (g:sqrt (g:/ (g:* 2 I) alpha)) (g:sin theta))
        (g:* (g:sqrt (g:* 2 I alpha)) (g:cos theta))))
  (define s (up 't 'theta 'I))
  (define DC ((D (polar 'alpha)) s))
  (define M (s->m (compatible-shape s) DC s))
  (check-true (same? (determinant (m:submatrix M 1 3 1 3)) 1)))

(test-case "s:inverse inverts a linear map of structures"
  (define A (down (up 1 2) (up 3 4)))
  (define inverse (s:inverse (down 0 0) A (up 0 0)))
  (check-true (same? (g:* inverse (g:* A (up 'x 5))) (up 'x 5))))
