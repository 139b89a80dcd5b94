#lang mechanics
;; Exercise 3.3 (SICM 3.1): Hamilton's equations by program
;; Checked: residuals along paths of one's own Hamiltonian
;; How: against what the Legendre transform gives; a motion by a verdict

;; Have the machine derive Hamilton's equations for the systems of the two exercises before.
;; Here: what it prints for the pendulum, and whether a motion that one believes in is one.

(define ((H-pendulum m l g) (up t theta p))
  (- (/ (square p) (* 2 m (square l))) (* m g l (cos theta))))
(((Hamilton-equations (H-pendulum 'm 'l 'g))
  (literal-function 'theta) (literal-function 'p))
 't)

;; Small oscillations about the bottom: cos θ = 1 − θ²/2.
(define ((H-small m l g) (up t theta p))
  (+ (/ (square p) (* 2 m (square l))) (* 1/2 m g l (square theta))))

;; θ = a cos ωt, and p = m l² Dθ.
(define ((swing omega) t) (* 'a (cos (* omega t))))
(define ((momentum-of-swing omega) t) (* -1 'm (square 'l) omega 'a (sin (* omega t))))
(define (check omega)
  (verify-Hamiltonian-solution (H-small 'm 'l 'g) (swing omega) (momentum-of-swing omega)))

(define right (check (sqrt (/ 'g 'l))))
right

;; With the rate not settled the verdict says which it is.
(define open (check 'omega))
open

;; The slip: p is m l θ̇.
(define slip
  (verify-Hamiltonian-solution
   (H-small 'm 'l 'g)
   (swing (sqrt (/ 'g 'l)))
   (lambda (t) (/ ((momentum-of-swing (sqrt (/ 'g 'l))) t) 'l))))
(verdict-conditions slip)

(module+ test
  (require rackunit)
  (test-case "the motion near the bottom"
    (check-pred proved? right))
  (test-case "the rate follows from the verdict"
    (check-pred refuted? open)
    (check-equal? (map expression (verdict-conditions open)) '((= g (* l (expt omega 2))))))
  (test-case "a momentum with a length too few is right for l = 1"
    (check-pred refuted? slip)
    (check-equal? (map expression (verdict-conditions slip)) '((= l 1)))))
