#lang racket/base
;; A newcomer's mistakes with chapter 5, and the messages.

(require mechanics
         mechanics/book
         "../support/checks.rkt" "../support/messages.rkt")

(define line (up 't 'q 'p))
(define polar (up 't (up 'r 'phi) (down 'p_r 'p_phi)))
(define plane (up 't (up 'x 'y) (down 'p_x 'p_y)))

;; ---------------------------------------------------------------------------
;; Shapes

(says
 [(symplectic-transform? (J-matrix 1))
  "symplectic-transform?: expected a transformation; a matrix is asked about by "
  "(symplectic-matrix? M)"]
 [(symplectic-matrix? '((1 0) (0 1)))
  "symplectic-matrix?: a symplectic matrix is square, with an even number of rows; given "
  "((1 0) (0 1)), a list\n  rows make a matrix by matrix-by-rows: (apply matrix-by-rows rows)"]
 [(omega (up 0 1 2) (up 0 (up 1 2) (down 3 4)))
  "symplectic-two-form: the increments are of states of different shapes: "
  "(up 0 1 2), an up tuple of 3 and (up 0 (up 1 2) (down 3 4)), an up tuple of 3"]
 [(loop-integral (lambda (x) (up 1 2)) 0 1)
  "loop-integral: a loop gives states (up t q p), but <function> gives "
  "(up 1 2), an up tuple of 2"]
 [((canonical-transform? C-rotating) plane)
  "canonical-transform?: a transformation takes a state (up t q p) to another one; C-rotating "
  "gives (F->CH rotating), a function\n  was a parameter left out?"]
 [((F->CH (lambda (t q) q)) line)
  "F->CH: expected a coordinate transformation, a function of the state that gives the old "
  "coordinates; given a function without a name, which takes 2 arguments\n"
  "  if it takes parameters first, supply them: (F->CH (<function> ...))"]
 [(C->K p->r polar)
  "C->K: a transformation takes a state (up t q p) to another one; p->r gives "
  "(up (* r (cos phi)) (* r (sin phi))), an up tuple of 2\n"
  "  a transformation of the coordinates alone is extended by (F->CH F)"]
 [(C->K a-non-canonical-transform (up 't 'theta 'p))
  "C->K: a-non-canonical-transform has no correction K: it is not canonical\n"
  "  for what it misses: (verify-canonical C state)"]
 [(C->K (shift-t 'tau) line)
  "C->K: (shift-t tau) changes the time t to (+ t tau); a correction belongs to one that keeps it"]
 [(extended-transformation (F->CH p->r) 0)
  "extended-transformation: a Hamiltonian is a function of the state (up t q p); given the number 0"])

;; ---------------------------------------------------------------------------
;; Functions that generate nothing

(define-syntax-rule (generates-nothing call text ...)
  (check-message (string-append text ...) call exn:fail:mechanics:singular:matrix?))

(test-case "no mixed derivatives: the two variables are not tied to each other"
  (generates-nothing
   ((F1->C (lambda (t q Q) (+ (square q) (square Q)))) line)
   "F1->C: it generates no transformation: the old coordinates do not follow from the new state\n"
   "  the determinant of the mixed second derivatives is 0\n  mixed second derivatives: 0")
  (generates-nothing
   ((F4->C (lambda (t p P) (sin p))) line)
   "F4->C: it generates no transformation: the old momenta do not follow from the new state\n"
   "  the determinant of the mixed second derivatives is 0\n  mixed second derivatives: 0"))

(test-case "one degree of freedom is left out"
  (generates-nothing
   ((F1->C (lambda (t q Q) (* (ref q 0) (ref Q 0)))) plane)
   "F1->C: it generates no transformation: the old coordinates do not follow from the new state\n"
   "  the determinant of the mixed second derivatives is 0\n"
   "  mixed second derivatives: (down (down 1 0) (down 0 0))")
  (generates-nothing
   ((F3->C (lambda (t p Q) (* (+ (ref p 0) (ref p 1)) (+ (ref Q 0) (ref Q 1))))) plane)
   "F3->C: it generates no transformation: the old momenta do not follow from the new state\n"
   "  the determinant of the mixed second derivatives is 0\n"
   "  mixed second derivatives: (up (down 1 1) (down 1 1))"))

(test-case "a point transformation has no F1 (p. 376)"
  (generates-nothing
   (generating-function (F->CH p->r) polar)
   "generating-function: it generates no transformation: the new momenta do not follow from old "
   "coordinates and new coordinates\n  the determinant of the mixed second derivatives is 0\n"
   "  mixed second derivatives: (up (up 0 0) (up 0 0))"))

;; ---------------------------------------------------------------------------
;; Perturbations

(define (rotor s) (/ (square (momentum s)) 2))
(define (wave s) (cos (coordinate s)))

(says
 [(perturbation-series rotor wave line #:keep '((0)))
  "perturbation-series: the waves to be kept are lists of one integer, one for each angle, such as "
  "((1)); given ((0))"]
 [(perturbation-series rotor (lambda (s) (coordinate s)) plane)
  "perturbation-series: the value of a Hamiltonian is a number, but that of <function> is "
  "(up x y), an up tuple of 2"])

(test-case "a resonance that was divided by is named with its integers"
  (define two (up 't (up 'a 'b) (down 'I 'J)))
  (define (H0 s) (+ (* 1/2 (square (ref s 2 0))) (* 1/2 (square (ref s 2 1)))))
  (define (H1 s) (cos (- (* 2 (ref s 1 0)) (* 3 (ref s 1 1)))))
  (define P (perturbation-series H0 H1 two))
  (check-message
   (string-append
    "perturbation-transformation: the state is on the resonance (2 -3), which was divided by in "
    "order 1: (- (* 2 I) (* 3 J)) = 0\n  #:keep '((2 -3)) keeps its waves\n"
    "  state: (up 0 (up 1 1) (down 3 2))")
   ((perturbation-transformation P) (up 0 (up 1 1) (down 3 2)))
   exn:fail:mechanics:singular?))
