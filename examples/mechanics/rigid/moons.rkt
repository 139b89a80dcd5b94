#lang mechanics
;; How moons and planets turn on their orbits: the Moon, Mercury and Hyperion (SICM 2.11).

(require mechanics/plot)
(provide picture)

;; The equation of motion, with the orbit given by functions of the time.
(define L
  (L-spin-orbit 'C 'n 'epsilon (literal-function 'a/R) (literal-function 'f)))
(((Lagrange-equations L) (literal-function 'theta)) 't)

;; On a circle it is that of a pendulum, with an energy of its own.
(define (circular C n epsilon)
  (L-spin-orbit C n epsilon (lambda (t) 1) (lambda (t) (* n t))))
(define (energy s)
  (- (* 1/2 'C (square (- (velocity s) 'n)))
     (* 1/4 'C (square (* 'n 'epsilon)) (cos (* 2 (- (coordinate s) (* 'n (time s))))))))
(define conserved
  (verify-conserved (circular 'C 'n 'epsilon) energy (up 't 'theta 'thetadot)))
conserved

;; In numbers the time is counted in orbits; the rate of turning is given in turns.
(define orbit (* 2 :pi))
(define (follow epsilon e turns start orbits [events '()])
  (evolve-trajectory (spin-orbit-sysder orbit epsilon e) (up 0 start (* turns orbit) 0.) orbits
                     #:tolerance 1e-13 #:events events))

;; The Moon, one in a hundred too fast, passes the line to the Earth twice in each libration.
(define (off-line s) (- (ref s 1) (ref s 3)))
(define moon (follow 0.026 0 1.01 0. 50 (event off-line)))
(for/list ([o (trajectory-events moon)]) (time (occurrence-state o)))

;; Mercury turns three times in two orbits, and swings about that.
(define mercury (follow 0.026 0.2 (* 3/2 1.0005) 0. 100))
(define (swing t) (- (ref (mercury t) 1) (* 3/2 orbit t)))

;; Hyperion is so far from round that it tumbles: starts that differ by 1e-9 part.
(define (hyperion start) (follow 0.89 0.1 1.05 start 15))
(define-values (one other) (values (hyperion 0.) (hyperion 1e-9)))
(define (apart t) (abs (- (ref (one t) 1) (ref (other t) 1))))
(for/list ([t '(0 5 10 15)]) (round (log (/ (apart t) 1e-9))))

;; The Moon in black and Hyperion in red, the angle to the planet's line on one turn.
(define picture
  (frame 0. 15. :-pi :pi #:width 500 #:height 300 #:x-label "orbits" #:y-label "θ − f"))
(define (on-a-turn s) ((principal-value :pi) (off-line s)))
(for ([t (in-range 0. 15. 0.02)])
  (plot-point picture t (on-a-turn (moon t)))
  (plot-point picture t (on-a-turn (one t)) #:color 'red))
picture

(module+ main
  (require "../figures/save.rkt")
  (save-figure picture "moons.png"))

(module+ test
  (require rackunit)
  (test-case "the energy on a circle"
    (check-pred proved? conserved))
  (test-case "the Moon's libration takes 40.016 orbits"
    (define times (for/list ([o (trajectory-events moon)]) (time (occurrence-state o))))
    (check-= (cadr times) 40.01601442 1e-6))
  (test-case "Mercury stays near three turns in two orbits"
    (for ([t (in-range 0 100 2)]) (check-true (< (abs (swing t)) 0.04))))
  (test-case "Hyperion's starts part by some e per orbit"
    (check-true (> (/ (log (/ (apart 15) 1e-9)) 15) 0.5))))
