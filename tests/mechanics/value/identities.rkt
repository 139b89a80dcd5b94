#lang racket/base
;; Identities of mechanics by name: each is proved, and refuted with a sign or a
;; factor changed.

(require (except-in mechanics define lambda) (only-in racket/base define lambda)
         "../support/checks.rkt")

(define-syntax-rule (check-identity name zero wrong)
  (test-case name
    (check-pred proved? (prove-zero zero))
    (define v (prove-zero wrong))
    (check-pred refuted? v)
    (check-true (pair? (verdict-witness v)))))

;; ---------------------------------------------------------------------------
;; Poisson brackets, two degrees of freedom

(define state (up 't (up 'x 'y) (down 'px 'py)))
(define (Hamiltonian name)
  (literal-function name (-> (UP Real (UP Real Real) (DOWN Real Real)) Real)))
(define F (Hamiltonian 'F))
(define G (Hamiltonian 'G))
(define H (Hamiltonian 'H))
(define (bracket f g)
  (- (* ((partial 1)  f) ((partial 2) g)) (* ((partial 2) f) ((partial 1) g))))

(define (cyclic sign)
  ((+ (bracket F (bracket G H)) (bracket G (bracket H F)) (* sign (bracket H (bracket F G))))
   state))

(check-identity "Jacobi's, with three literal Hamiltonians" (cyclic 1) (cyclic -1))

(check-identity "Leibniz's, of brackets"
  ((- (bracket F (* G H)) (+ (* (bracket F G) H) (* G (bracket F H)))) state)
  ((- (bracket F (* G H)) (+ (* (bracket F G) H) (* (bracket F H) F))) state))

;; ---------------------------------------------------------------------------
;; Rotations by Euler angles

(define (about-z a)
  (matrix-by-rows (list (cos a) (- (sin a)) 0) (list (sin a) (cos a) 0) (list 0 0 1)))
(define (about-x a)
  (matrix-by-rows (list 1 0 0) (list 0 (cos a) (- (sin a))) (list 0 (sin a) (cos a))))
(define M (* (about-z 'phi) (about-x 'theta) (about-z 'psi)))
(define unit (matrix-by-rows '(1 0 0) '(0 1 0) '(0 0 1)))

(check-identity "Euler-angle matrices are orthogonal" (- (* (transpose M) M) unit) (- (* M M) unit))
(check-identity "their determinant is 1" (- (determinant M) 1) (- (determinant M) 'd))

(define (T-body A B C)
  (lambda (thetadot phidot psidot)
    (define wa (+ (* phidot (sin 'theta) (sin 'psi)) (* thetadot (cos 'psi))))
    (define wb (- (* phidot (sin 'theta) (cos 'psi)) (* thetadot (sin 'psi))))
    (define wc (+ (* phidot (cos 'theta)) psidot))
    (* 1/2 (+ (* A wa wa) (* B wb wb) (* C wc wc)))))
(define mass-matrix-determinant
  (let ([T (T-body 'A 'B 'C)])
    (define (second i j) (((partial i) ((partial j) T)) 'a 'b 'c))
    (determinant (apply matrix-by-rows
                        (for/list ([i 3]) (for/list ([j 3]) (second i j)))))))

(check-identity "the mass matrix in Euler angles has the determinant A B C sin²θ"
  (- mass-matrix-determinant (* 'A 'B 'C (square (sin 'theta))))
  (- mass-matrix-determinant (* 'A 'B 'C (square (cos 'theta)))))

;; ---------------------------------------------------------------------------
;; Total derivatives

(define x (literal-function 'x))
(define y (literal-function 'y))
(define (D2 f) ((expt D 2) f))

(check-identity "the virial: d²(x²)/dt² = 2 ẋ² + 2 x ẍ"
  ((- (D2 (square x)) (* 2 (+ (square (D x)) (* x (D2 x))))) 't)
  ((- (D2 (square x)) (* 2 (- (square (D x)) (* x (D2 x))))) 't))

(define (Wronskian f g) (- (* f (D g)) (* g (D f))))
(check-identity "Abel: a Wronskian's derivative is f g̈ - g f̈"
  ((- (D (Wronskian x y)) (- (* x (D2 y)) (* y (D2 x)))) 't)
  ((- (D (Wronskian x y)) (+ (* x (D2 y)) (* y (D2 x)))) 't))

(define L0 (lambda (s) (* 1/2 'm (square (ref s 2)))))
(define L1
  (lambda (s) (+ (L0 s) (* 2 (ref s 1) (ref s 2)) (* 3 (square (ref s 0))))))
(check-identity "Lagrangians that differ by the derivative of x² + t³ have the same equations"
  (((- (Lagrange-equations L1) (Lagrange-equations L0)) x) 't)
  (((- (Lagrange-equations L1) (* 2 (Lagrange-equations L0))) x) 't))

;; ---------------------------------------------------------------------------
;; Vectors

(define (cross u v)
  (up (- (* (ref u 1) (ref v 2)) (* (ref u 2) (ref v 1)))
      (- (* (ref u 2) (ref v 0)) (* (ref u 0) (ref v 2)))
      (- (* (ref u 0) (ref v 1)) (* (ref u 1) (ref v 0)))))
(define a (up 'a1 'a2 'a3))
(define b (up 'b1 'b2 'b3))
(define c (up 'c1 'c2 'c3))
(check-identity "Jacobi's, of cross products, as Bianchi's is of commutators"
  (+ (cross a (cross b c)) (cross b (cross c a)) (cross c (cross a b)))
  (+ (cross a (cross b c)) (cross b (cross c a)) (cross (cross a b) c)))
