#lang racket/base
;; Birkhoff normal forms, checked against forms and numbers from elsewhere.

(require mechanics
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/session.rkt")

(define plane (up 't (up 'x 'y) (down 'p_x 'p_y)))
(define line (up 't 'q 'p))

(define (Henon-Heiles (up t (up x y) p))
  (+ (* 1/2 (+ (square p) (square x) (square y)))
     (* (square x) y)
     (* -1/3 (cube y))))

(define N (Birkhoff-normal-form Henon-Heiles plane #:degree 8))
(define (term n) (series:ref ((normal-form-Hamiltonian N) plane) (- n 2)))

;; Gustavson 1966; Kummer 1976: with I = H₂ and L = x p_y − y p_x.
(test-case "Hénon and Heiles to degree 4: (7 L² − 5 I²)/12"
  (define I (* 1/2 (+ (square 'p_x) (square 'p_y) (square 'x) (square 'y))))
  (define L (- (* 'x 'p_y) (* 'y 'p_x)))
  (check-identity (term 3) 0)
  (check-identity (term 4) (* 1/12 (- (* 7 (square L)) (* 5 (square I))))))

;; On the line x = 0 the motion is that of p²/2 + y²/2 + g y³ with g = −1/3, of which the energy
;; by the action is known: J − 15/4 g² J² − 705/16 g⁴ J³ − 115755/128 g⁶ J⁴ (the classical limit
;; of the perturbed levels of the cubic oscillator).
(test-case "to degree 8, along the orbit on a symmetry axis"
  (define terms
    (series:head ((normal-form-Hamiltonian N) (up 0 (up 0 (sqrt (* 2 'J))) (down 0 0))) 7))
  (define g -1/3)
  (for ([k '(0 2 4 6)]
        [expected (list 'J (* -15/4 (expt g 2) (expt 'J 2)) (* -705/16 (expt g 4) (expt 'J 3))
                        (* -115755/128 (expt g 6) (expt 'J 4)))])
    (check-identity (list-ref terms k) expected)))

;; An independent computation: the action of that orbit by quadrature.
(test-case "the same by quadrature"
  (define (energy J)
    (series:sum ((normal-form-Hamiltonian N) (up 0 (up 0 (sqrt (* 2 J))) (down 0 0))) 6))
  (define E 1/100)
  (define (p^2 y) (- (* 2 E) (square y) (* -2/3 (cube y))))
  (define low (find-root p^2 -0.2 -0.1))
  (define high (find-root p^2 0.1 0.2))
  ;; y = middle + half sin u takes the roots of p away
  (define-values (middle half) (values (/ (+ low high) 2) (/ (- high low) 2)))
  (define J
    (/ (definite-integral
        (lambda (u) (* half (cos u) (sqrt (max 0 (p^2 (+ middle (* half (sin u))))))))
        (/ pi -2) (/ pi 2) 1e-12)
       pi))
  (check-close (energy J) E 1e-9))

(test-case "it is one: transformed as functions, and commuting with the oscillators"
  (check-pred proved? (verify-normal-form (Birkhoff-normal-form Henon-Heiles plane #:degree 6)))
  (check-equal? (normal-form-resonances N) '((2 -2) (4 -4)))
  (check-equal? (normal-form-frequencies N) '(1 1))
  (check-pred normal-form? N)
  (check-equal? (length (normal-form-generators N)) 6))

(test-case "states to and fro, and the Hamiltonian in the new ones"
  (define-values (C C-inv) (values (normal-form-transformation N) (normal-form-inverse N)))
  (define new (up 0 (up 0.01 0.02) (down 0.03 -0.01)))
  (check-close (C-inv (C new)) new 1e-9)
  (check-close (Henon-Heiles (C new)) (series:sum ((normal-form-Hamiltonian N) new) 6) 1e-13)
  (define M (qp-submatrix ((D-as-matrix C) new)))
  (check-close (for*/list ([i 4] [j 4]) (matrix-ref (symplectic-matrix? M) i j))
               (for*/list ([i 4] [j 4]) 0) 1e-8))

;; E = J − J²/16 − J³/256 − 5 J⁴/8192 of the pendulum, by its elliptic integrals.
(test-case "the pendulum, from the series of its cosine"
  (define P (Birkhoff-normal-form (lambda (s) (- (/ (square (momentum s)) 2) (cos (coordinate s))))
                                  line #:degree 8))
  (define terms
    (series:head ((normal-form-Hamiltonian P) (up 0 (sqrt (* 2 'J)) 0)) 7))
  (for ([k '(0 2 4 6)] [c '(1 -1/16 -1/256 -5/8192)] [n '(1 2 3 4)])
    (check-identity (list-ref terms k) (* c (expt 'J n))))
  (check-equal? (normal-form-resonances P) '()))

(test-case "frequencies that are not rational multiples leave the actions alone"
  (define (H (up t (up x y) (down a b)))
    (+ (* 1/2 (+ (square a) (square x))) (* (sqrt 2.0) 1/2 (+ (square b) (square y)))
       (* (square x) y)))
  (define M (Birkhoff-normal-form H plane #:degree 4))
  (check-equal? (normal-form-resonances M) '())
  (check-close (map cdr (map cdr (filter (lambda (d) (equal? (cadr d) '(2 -1)))
                                         (normal-form-divisors M))))
               (list (- 2 (sqrt 2.0))) 1e-12)
  (check-equal? (for/list ([d (normal-form-divisors M)] #:when (equal? (cadr d) '(2 -1))) (car d))
                '(3)))

;; The mean of x⁴ over an oscillation is 3/8 (x² + a²)².
(test-case "with a decimal among exact coefficients the terms stand as monomials"
  (define (H (up t (up x y) (down a b)))
    (+ (* 1/2 (+ (square a) (square x))) (square b) (square y) (* 8 (expt x 4)) (* 1.5 (expt y 4))))
  (define quartic (series:ref ((normal-form-Hamiltonian (Birkhoff-normal-form H plane)) plane) 2))
  (define (means-at x y a b)
    (+ (* 3 (square (+ (* x x) (* a a)))) (* 9/16 (square (+ (* y y) (* b b))))))
  (check-close (substitute quartic 'x 0.3 'y -0.7 'p_x 0.2 'p_y 0.4)
               (means-at 0.3 -0.7 0.2 0.4) 1e-12)
  (check-equal? (map car (cdr (expression quartic))) '(* * * * * *))
  (check-close (sort (map cadr (cdr (expression quartic))) <) '(9/16 9/16 9/8 3 3 6) 1e-12))

(test-case "what it prints"
  (check-equal? (format "~a" (Birkhoff-normal-form Henon-Heiles plane #:degree 3))
                (string-append
                 "normal form to degree 3, of frequencies (1 1)\n"
                 "  degree 2: (* 1/2 (+ (expt p_x 2) (expt p_y 2) (expt x 2) (expt y 2)))\n"
                 "  degree 3: 0"))
  (check-regexp-match #rx"\n  resonances: [(][(]2 -2[)][)]$"
                      (format "~a" (Birkhoff-normal-form Henon-Heiles plane #:degree 4))))

(says
 [(Birkhoff-normal-form (lambda (s) (coordinate s)) line)
  "Birkhoff-normal-form: there is no equilibrium of <function> at (up t 0 0)\n"
  "  derivatives there: (1 0)\n"
  "  give a state near one by #:at"]
 [(Birkhoff-normal-form (lambda (s) (+ (square (momentum s)) (square (coordinate s)) )) line
                        #:degree 2)
  "Birkhoff-normal-form: expected the degree of the last terms, from 3 to 63\n  given: the number 2"]
 [(Birkhoff-normal-form (lambda (s) (square (momentum s))) line)
  "Birkhoff-normal-form: the quadratic terms are not semisimple, and have no normal form\n"
  "  frequencies: 0\n"
  "  distance to terms that are not, beside the greatest: 0"]
 [(Birkhoff-normal-form (lambda (s) (* 'k (square (coordinate s)))) line)
  "Birkhoff-normal-form: the coefficients of the series of <function> are to be numbers; there is "
  "k\n  give the parameters as numbers"]
 [(verify-normal-form 3)
  "verify-normal-form: expected what Birkhoff-normal-form gives\n  given: the number 3"])
