#lang racket/base
;; SICM 6.5, exponential identities (pp. 451-453), and exercises 6.7 to 6.11.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt" "../support/session.rkt")

(define line (up 't 'q 'p))
(define (any name) (literal-function name (Hamiltonian 1)))

;; Sums over the ways to write n as an ordered sum
(define (compositions n)
  (if (= n 0)
      '(())
      (for*/list ([k (in-range 1 (add1 n))] [rest (in-list (compositions (- n k)))])
        (cons k rest))))

;; The term of order n of exp(Z₁ + Z₂ + ⋯) F
(define (exponential-term Z F n)
  (for/sum ([ks (in-list (compositions n))])
    (* (/ 1 (factorial (length ks)))
       (for/fold ([G F]) ([k (in-list (reverse ks))]) ((series:ref Z k) G)))))

(test-case "Baker, Campbell and Hausdorff, proved to order 3 for any two Hamiltonians"
  (define-values (A B F) (values (Lie-derivative (any 'f)) (Lie-derivative (any 'g)) (any 'F)))
  (define Z (Baker-Campbell-Hausdorff A B))
  (define product (((exp A) ((exp B) F)) line))
  (for ([n 4]) (check-identity (series:ref product n) ((exponential-term Z F n) line))))

(test-case "the first terms are the book's (p. 453)"
  (define-values (A B F) (values (Lie-derivative (any 'f)) (Lie-derivative (any 'g)) (any 'F)))
  (define Z (Baker-Campbell-Hausdorff A B))
  (check-identity (((series:ref Z 2) F) line) (* 1/2 (((commutator A B) F) line)))
  (check-identity (((series:ref Z 3) F) line)
                  ((* 1/12 (+ ((commutator A (commutator A B)) F)
                              ((commutator B (commutator B A)) F)))
                   line)))

(test-case "to order 5 where brackets are polynomials"
  (define (f s) (* (square (momentum s)) (coordinate s)))
  (define (g s) (expt (coordinate s) 3))
  (define (F s) (+ (coordinate s) (momentum s)))
  (define-values (A B) (values (Lie-derivative f) (Lie-derivative g)))
  (define Z (Baker-Campbell-Hausdorff A B))
  (define product (((exp A) ((exp B) F)) line))
  (for ([n 6]) (check-identity (series:ref product n) ((exponential-term Z F n) line))))

(test-case "of Hamiltonians: the one whose Lie series is the product of the two"
  (define (f s) (* (square (momentum s)) (coordinate s)))
  (define (g s) (expt (coordinate s) 3))
  (define of-functions (Baker-Campbell-Hausdorff f g))
  (define of-operators (Baker-Campbell-Hausdorff (Lie-derivative f) (Lie-derivative g)))
  (for ([n '(1 2 3 4)])
    (check-identity (((Lie-derivative (series:ref of-functions n)) coordinate) line)
                    (((series:ref of-operators n) coordinate) line))))

(test-case "what commutes adds up"
  (define Z (Baker-Campbell-Hausdorff (partial 1) (* 'a (partial 1))))
  (define F (any 'F))
  (check-identity (((series:ref Z 1) F) line) (* (+ 1 'a) (((partial 1) F) line)))
  (check-identity (((series:ref Z 2) F) line) 0)
  (check-identity (((series:ref Z 3) F) line) 0))

;; Exercise 6.10: [L_f, L_g] = −L_{f, g}
(test-case "the commutator of Lie derivatives is that of the bracket, with a minus"
  (define-values (f g F) (values (any 'f) (any 'g) (any 'F)))
  (check-identity (((commutator (Lie-derivative f) (Lie-derivative g)) F) line)
                  (- (((Lie-derivative (Poisson-bracket f g)) F) line))))

;; Exercise 6.8: e^{C} f(A) e^{−C}
(test-case "exp C A exp −C = A + [C, A] + [C, [C, A]]/2 + ⋯"
  (define-values (C A F) (values (Lie-derivative (any 'f)) (Lie-derivative (any 'g)) (any 'F)))
  (define conjugated (((exp C) (A ((exp (* -1 C)) F))) line))
  (define (nested n) (for/fold ([X A]) ([_ (in-range n)]) (commutator C X)))
  (for ([n 3])
    (check-identity (series:ref conjugated n) (((* (/ 1 (factorial n)) (nested n)) F) line))))

(says
 [(Baker-Campbell-Hausdorff 3 sin)
  "Baker-Campbell-Hausdorff: expected two operators, or two Hamiltonians; given the number 3 and "
  "the procedure `sin`"])
