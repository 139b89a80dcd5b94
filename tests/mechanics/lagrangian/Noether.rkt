#lang racket/base
;; Noether's integrals (SICM 1.8.5, pp. 90-91).

(require mechanics
         "../support/checks.rkt" "../support/session.rkt")

(define ((L-central m U) local)
  (- (* 1/2 m (square (velocity local))) (U (sqrt (square (coordinate local))))))
(define L (L-central 'm (literal-function 'U)))
(define state (up 't (up 'x 'y 'z) (up 'vx 'vy 'vz)))

(define (rotations a b c) (compose (Rx a) (Ry b) (Rz c) coordinate))

;; The rate of an integral along the motions of L.
(define (rate I L state) (* ((D I) state) ((Lagrangian->state-derivative L) state)))

(test-case "rotations: the angular momentum, with the sign of r × m v (p. 91 prints the other)"
  (define I (Noether-integral L rotations))
  (define angular-momentum (cross-product (coordinate state) (* 'm (velocity state))))
  (for ([k 3])
    (check-identity (ref (I state) k) (ref angular-momentum k)))
  (check-pred down? (I state)))

(test-case "it is what the book computes: the momentum times the derivative at 0"
  (check-identity ((Noether-integral L rotations) state)
                  ((* ((partial 2) L) ((D rotations) 0 0 0)) state)))

(test-case "it is constant along the motions"
  (check-eq? (verdict-status (prove-zero (rate (Noether-integral L rotations) L state))) 'proved))

(test-case "one parameter gives a scalar: translation and momentum"
  (define ((L-two m1 m2 V) (up t (up a b) (up va vb)))
    (- (+ (* 1/2 m1 (square va)) (* 1/2 m2 (square vb))) (V (- a b))))
  (define L (L-two 'm1 'm2 (literal-function 'V)))
  (define (together s) (lambda (local) (+ (coordinate local) (up s s))))
  (define state (up 't (up 'a 'b) (up 'va 'vb)))
  (check-identity ((Noether-integral L together) state) (+ (* 'm1 'va) (* 'm2 'vb)))
  (check-eq? (verdict-status (prove-zero (rate (Noether-integral L together) L state))) 'proved))

(test-case "a screw symmetry conserves the momentum of its screw"
  (define ((L-screw m V) (up t (up r phi z) (up rdot phidot zdot)))
    (- (* 1/2 m (+ (square rdot) (square (* r phidot)) (square zdot))) (V r (- z (* 'h phi)))))
  (define L (L-screw 'm (literal-function 'V (-> (X Real Real) Real))))
  (define (screw s) (lambda (local) (+ (coordinate local) (up 0 s (* 'h s)))))
  (define state (up 't (up 'r 'phi 'z) (up 'rdot 'phidot 'zdot)))
  (check-identity ((Noether-integral L screw) state)
                  (* 'm (+ (* (square 'r) 'phidot) (* 'h 'zdot))))
  (check-eq? (verdict-status (prove-zero (rate (Noether-integral L screw) L state))) 'proved))

(test-case "what is no symmetry has an integral that is not constant"
  (define (shift s) (lambda (local) (+ (coordinate local) (up s 0 0))))
  (check-eq? (verdict-status (prove-zero (rate (Noether-integral L shift) L state))) 'refuted))

(test-case "it prints as what was typed and names what is no family"
  (check-equal? (format "~a" (Noether-integral L rotations))
                "(Noether-integral L-central rotations)")
  (check-exn
   #rx"^Noether-integral: .*a family of coordinate transformations: a function of its parameters"
   (lambda () (Noether-integral L (lambda () coordinate))))
  (check-exn #rx"^Noether-integral: the family coordinate gives no coordinate transformation"
             (lambda () ((Noether-integral L (procedure-rename (lambda (s) s) 'coordinate)) state)))
  (check-exn
   #rx"^Noether-integral: the family wrong gives the number 0 where the coordinates are [(]up x y z[)]"
   (lambda () ((Noether-integral L (procedure-rename (lambda (s) (lambda (l) 0)) 'wrong)) state))))
