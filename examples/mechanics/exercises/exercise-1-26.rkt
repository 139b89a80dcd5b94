#lang mechanics
;; Exercise 1.26 (SICM 1.6.4): properties of the total time derivative
;; Checked: the rules for sums, multiples, products and compositions
;; How: both sides compared at a local tuple, for arbitrary functions

;; Which rules does D_t obey?

(define F (literal-function 'F (-> (UP Real Real Real) Real)))
(define G (literal-function 'G (-> (UP Real Real Real) Real)))
(define H (literal-function 'H))
(define local (up 't 'q 'v 'a))
(define (same left right) (verify-equal (left local) (right local)))

;; F, as a function of longer local tuples.
(define (clipped F) (compose F (clip-state 3)))

(define rules
  (list (same (Dt (+ F G)) (+ (Dt F) (Dt G)))
        (same (Dt (* 'c F)) (* 'c (Dt F)))
        (same (Dt (* F G)) (+ (* (clipped F) (Dt G)) (* (Dt F) (clipped G))))
        (same (Dt (compose H F)) (* (compose (D H) (clipped F)) (Dt F)))))
(map verdict-status rules)

;; A multiple that is a function of the time needs the product rule.
(define (square-time local) (square (time local)))
(define slip (same (Dt (* square-time F)) (* (clipped square-time) (Dt F))))
slip

(module+ test
  (require rackunit)
  (test-case "the rules of a derivative"
    (for ([rule rules]) (check-pred proved? rule)))
  (test-case "the slip leaves the other half of the product rule over"
    (check-pred refuted? slip)
    (check-pred proved? (verify-equal (verdict-residual slip) (* 2 't (F (up 't 'q 'v)))))))
