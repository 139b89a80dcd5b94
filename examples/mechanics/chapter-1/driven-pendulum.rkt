#lang mechanics
;; A pendulum whose pivot is moved (SICM 1.6, pp. 52 and 61, and 1.7, pp. 74-76).

(require mechanics/book)

;; By its energies, and by the coordinates that its rod allows.
(define y_s (literal-function 'y_s))
(define by-energies (L-pend 'm 'l 'g y_s))
(define by-coordinates
  (compose (L-uniform-acceleration 'm 'g) (F->C (dp-coordinates 'l y_s))))
(verify-equal (by-energies (up 't 'theta 'thetadot))
              (by-coordinates (up 't 'theta 'thetadot)))
(((Lagrange-equations by-coordinates) (literal-function 'theta)) 't)

;; Shaken up and down, at twice the frequency of small swings.
((pend-state-derivative 'm 'l 'g 'A 'omega) (up 't 'theta 'thetadot))
(define (show-angle state)
  (printf "~a  ~a\n" (time state) ((principal-value :pi) (coordinate state))))
((evolve pend-state-derivative 1 1 9.8 0.1 (* 2 (sqrt 9.8)))
 (up 0 1 0) show-angle 1 5 1e-12)

(module+ test
  (require rackunit)
  (test-case "both ways give the same Lagrangian"
    (check-eq? (verdict-status (verify-equal (by-energies (up 't 'theta 'thetadot))
                                             (by-coordinates (up 't 'theta 'thetadot))))
               'proved))
  (test-case "the state after ten seconds"
    (define state
      ((state-advancer pend-state-derivative 1 1 9.8 0.1 (* 2 (sqrt 9.8))) (up 0 1 0) 10 1e-13))
    (check-= (coordinate state) 1.27379225442614696 1e-10)
    (check-= (velocity state) -3.45379718978431025 1e-10)))
