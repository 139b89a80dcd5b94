#lang mechanics
;; A free particle seen from axes that turn (SICM 1.6, p. 48).

(require mechanics/book)

(define L (compose (L-free-rectangular 'm) (F->C (rotating->inertial 'Omega))))
(L (up 't (up 'x 'y) (up 'vx 'vy)))
(((Lagrange-equations L) (up (literal-function 'x) (literal-function 'y))) 't)

;; A straight path on axes at rest goes round on turning ones, and still solves.
(define (straight t) (up (+ 'x_0 (* 'v t)) 'y_0))
(define seen-from-there (compose (inertial->rotating 'Omega) (Gamma straight)))
(seen-from-there 't)
(verify-solution L seen-from-there)
(verify-solution L straight)

(module+ test
  (require rackunit)
  (define (status path) (verdict-status (verify-solution L path)))
  (test-case "a straight line seen from turning axes is a motion there"
    (check-eq? (status seen-from-there) 'proved))
  (test-case "a straight line on turning axes is none, unless they are at rest"
    (check-eq? (status straight) 'refuted)
    (define at-rest (compose (L-free-rectangular 'm) (F->C (rotating->inertial 0))))
    (check-eq? (verdict-status (verify-solution at-rest straight)) 'proved))
  (test-case "it is the Lagrangian that the book makes by way of polar coordinates"
    (define local (up 't (up 'x 'y) (up 'vx 'vy)))
    (check-eq? (verdict-status
                (verify-equal (L local) ((L-rotating-rectangular 'm 'Omega) local)))
               'proved)))
