#lang mechanics
;; Exercise 1.28 (SICM 1.6.4): total time derivatives recognized
;; Checked: whether a function is one, and of what
;; How: its Euler-Lagrange expression; the total time derivative of the answer

;; Which of these functions of (t, x, v), or of (t, (x, y), (vx, vy)), are total time derivatives,
;; and of what?  They are not the book's.

(define line (up 't 'x 'v))
(define plane (up 't (up 'x 'y) (up 'vx 'vy)))

(define (a (up t x v)) (* 3 (square x) v))
(define (b (up t x v)) (* v (exp t)))
(define (c (up t x v)) (* (+ v x) (exp t)))
(define (d (up t (up x y) (up vx vy)))
  (- (* (+ (* y vx) (* x vy)) (cos t)) (* x y (sin t))))
(define (e (up t (up x y) (up vx vy))) (- (* x vy) (* y vx)))

;; My answers: those of b and e are slips.
(define (of-a (up t x)) (cube x))
(define (of-b (up t x)) (* x (exp t)))
(define (of-c (up t x)) (* x (exp t)))
(define (of-d (up t (up x y))) (* x y (cos t)))
(define (of-e (up t (up x y))) (* x y))

(define (check F f local) (verify-equal (F local) ((Dt f) local)))
(define answers
  (list (check a of-a line) (check b of-b line) (check c of-c line)
        (check d of-d plane) (check e of-e plane)))
(map verdict-status answers)

;; Are there any better ones for b and e?
(define b-at-all (verify-total-time-derivative b line))
(define e-at-all (verify-total-time-derivative e plane))
b-at-all
e-at-all

;; With a symbol in it, a function may be one under a condition.
(define (almost (up t x v)) (+ (* v (sin (* 'omega t))) (* x (cos (* 'omega t)))))
(define under-a-condition (verify-total-time-derivative almost line))
(verdict-conditions under-a-condition)

;; Of what, in the library's opinion.
((gauge-function c line) line)
((gauge-function d plane) plane)

(module+ test
  (require rackunit)
  (test-case "three answers are right"
    (check-equal? (map verdict-status answers) '(proved refuted proved proved refuted)))
  (test-case "the others have none"
    (check-pred refuted? b-at-all)
    (check-pred refuted? e-at-all)
    (check-equal? (expression (verdict-residual b-at-all)) '(exp t)))
  (test-case "one with the angular velocity 1"
    (check-pred refuted? under-a-condition)
    (check-equal? (map expression (verdict-conditions under-a-condition)) '((= omega 1))))
  (test-case "the library finds the same functions"
    (for ([F (list a c d)] [f (list of-a of-c of-d)] [local (list line line plane)])
      (check-pred proved? (verify-equal ((gauge-function F local) local)
                                        (f ((clip-state 2) local)))))))
