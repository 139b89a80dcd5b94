#lang mechanics
;; Exercise 1.38 (SICM 1.9): properties of the Euler-Lagrange operator
;; Checked: the rules for sums, multiples, products and compositions
;; How: both sides compared at a local tuple, for arbitrary functions

;; Which rules does the operator E obey that takes a Lagrangian to its equations?

(define F (literal-function 'F (-> (UP Real Real Real) Real)))
(define G (literal-function 'G (-> (UP Real Real Real) Real)))
(define E Euler-Lagrange-operator)
(define local (up 't 'x 'v 'a))
(define (same left right) (verify-equal (left local) (right local)))

;; A function of (t, x, v), as one of longer local tuples.
(define (clipped F) (compose F (clip-state 3)))
(define (by-v F) (clipped ((partial 2) F)))

(define sums (same (E (+ F G)) (+ (E F) (E G))))
(define multiples (same (E (* 'c F)) (* 'c (E F))))
sums
multiples

;; Products, first as if E were a derivative; what is missing is what a product of rates has.
(define slip (same (E (* F G)) (+ (* (E F) (clipped G)) (* (clipped F) (E G)))))
(define products
  (same (E (* F G))
        (+ (* (E F) (clipped G)) (* (clipped F) (E G))
           (* (Dt F) (by-v G)) (* (by-v F) (Dt G)))))
(verdict-status slip)
products

;; Compositions with a transformation of local tuples; as its values are tuples, the operator
;; is written out for it.
(define (f local) ((literal-function 'f (-> (UP Real Real) Real))
                   (up (time local) (coordinate local))))
(define C (F->C f))
(define DF-there (compose (D F) C))
(define compositions
  (same (E (compose F C))
        (+ (* (Dt DF-there) (by-v C))
           (* (clipped DF-there)
              (- (Dt ((partial 2) C)) (clipped ((partial 1) C)))))))
compositions

(module+ test
  (require rackunit)
  (test-case "rules of the operator"
    (for ([v (list sums multiples products compositions)]) (check-pred proved? v)))
  (test-case "it is no derivative: both cross terms are missing"
    (check-pred refuted? slip)
    (check-pred proved?
                (verify-equal (verdict-residual slip)
                              ((+ (* (Dt F) (by-v G)) (* (by-v F) (Dt G))) local)))))
