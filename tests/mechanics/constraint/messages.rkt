#lang racket/base
;; Messages to those who state constraints wrongly, or too many of them.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt")

(define (L (up t q v)) (- (* 1/2 'm (square v)) (* 'm 'g (ref q 1))))
(define (on-circle t q) (- (square q) (square 'l)))
(define circle (holonomic on-circle))
(define state (up 't (up 'x 'y) (up 'vx 'vy)))
(define xy (up (literal-function 'x) (literal-function 'y)))
(define mu (literal-function 'mu))

(test-case "what is no constraint"
  (check-message
   "holonomic: expected a function of the time and the coordinates, (G t q)\n  given: the symbol x"
   (holonomic 'x))
  (check-message
   "nonholonomic: expected a function of the time, the coordinates and the velocities, (A t q v)\n  given: (up a b), an up tuple of 2"
   (nonholonomic (up 'a 'b)))
  (check-true (constraint? (holonomic (up on-circle on-circle))))
  (define (of-velocities t q v) (ref v 0))
  (check-message
   "holonomic: expected a function of the time and the coordinates, (G t q)\n  given: the procedure `of-velocities`, which takes 3 arguments\n  a constraint on the velocities is nonholonomic: (nonholonomic A)"
   (holonomic of-velocities))
  (check-message
   "nonholonomic: expected a function of the time, the coordinates and the velocities, (A t q v)\n  given: the procedure `on-circle`, which takes 2 arguments\n  a constraint on the coordinates alone is holonomic: (holonomic G)"
   (nonholonomic on-circle))
  (define (of-local local) (coordinate local))
  (check-message
   "holonomic: expected a function of the time and the coordinates, (G t q)\n  given: the procedure `of-local`, which takes 1 argument\n  the parts of the local tuple are arguments of their own; parameters come first"
   (holonomic of-local))
  (check-message
   "constrained-accelerations: expected a constraint, (holonomic G) or (nonholonomic A), or a list of them\n  given: the procedure `on-circle`\n  (holonomic G) makes a constraint of a function of the time and the coordinates"
   (constrained-accelerations L on-circle))
  (check-equal? (format "~a" circle) "(holonomic on-circle)"))

(test-case "velocities must enter linearly"
  (check-exn
   #rx"^constrained-accelerations: a constraint must be linear in the velocities\n"
   (lambda ()
     ((constrained-accelerations L (nonholonomic (lambda (t q v) (- (square v) 1)))) state)))
  (check-not-exn
   (lambda ()
     ((constrained-accelerations L (nonholonomic (lambda (t q v) (- (ref v 0) (* t (ref v 1)) 1))))
      state))))

(test-case "multipliers of another shape, or none"
  (define equations (constrained-Lagrange-equations L circle))
  (check-exn
   #rx"^constrained-Lagrange-equations: multipliers are functions of time, as paths are; given the symbol lambda\n  [(]literal-function 'lambda[)] makes a function of that name"
   (lambda () (equations xy 'lambda)))
  (check-exn
   #rx"^constrained-Lagrange-equations: the multipliers must be a number, like the constraints\n  multipliers: [(]up [(]mu t[)] [(]mu t[)][)]"
   (lambda () ((equations xy (up mu mu)) 't)))
  (check-exn #rx"the multipliers must be an up tuple of 1, like the constraints"
             (lambda () (((constrained-Lagrange-equations L (list circle)) xy mu) 't)))
  (check-exn #rx"multipliers belong to constraints"
             (lambda () (verify-solution L xy #:multipliers mu))))

(test-case "the value of a constraint"
  (check-exn #rx"the value of a constraint is a number, or an up tuple of numbers"
             (lambda ()
               ((constrained-accelerations L (holonomic (lambda (t q) on-circle))) state))))

(test-case "more constraints than coordinates"
  (define (too-many t q) (up (ref q 0) (ref q 1) t))
  (check-message
   "constrained-accelerations: there are more constraints than coordinates\n  constraints: 3\n  coordinates: 2, (up x y)"
   ((constrained-accelerations L (holonomic too-many)) state)))

(test-case "redundant constraints are named, with what they repeat"
  (define (twice t q) (* 2 (on-circle t q)))
  (define redundant
    (string-append "constrained-accelerations: the constraints are redundant; "
                   "their multipliers are not determined\n"))
  (define ((L-free n) (up t q v)) (* 1/2 (square v)))
  (define (three t q) (up (ref q 0) (ref q 1) (- (ref q 0) (* 'a (ref q 1)))))
  (define-syntax-rule (check-redundant text L constraints at)
    (check-message (string-append redundant text)
                   ((constrained-accelerations L constraints) at)
                   exn:fail:mechanics:singular:matrix?))
  (check-redundant "  constraint 1 demands the same as 2 times constraint 0"
                   L (list circle (holonomic twice)) state)
  (check-redundant
   "  constraint 2 demands the same as constraint 0 plus (* -1 a) times constraint 1"
   (L-free 3) (holonomic three) (up 't (up 'x 'y 'z) (up 0 0 0)))
  (check-redundant
   "  constraint 0 demands nothing here: its derivatives by the coordinates are zero"
   L circle (up 0 (up 0 0) (up 1 0))))

(test-case "what is left may have no inertia"
  (define (no-inertia (up t (up x y) (up vx vy))) (* 1/2 (square vx)))
  (check-exn #rx"the mass matrix and the constraints do not determine the accelerations"
             (lambda ()
               ((constrained-accelerations no-inertia (holonomic (lambda (t q) (ref q 0))))
                state))))

(define (L-unit (up t q v)) (- (* 1/2 (square v)) (ref q 1)))

(test-case "it is told by whom, and they print as they were made"
  (define on-unit-circle (holonomic (lambda (t q) (- (square q) 1))))
  (check-message
   (string-append "Frobenius-test: a constraint must be linear in the velocities\n"
                  "  constraint: (nonholonomic <function>)\n"
                  "  its value: (+ -1 (* v0 v0) (* v1 v1))")
   (Frobenius-test (nonholonomic (lambda (t q v) (- (square v) 1))) (up 'x 'y)))
  (check-message
   (string-append "constrained-state-derivative: expected a force: a function of the local tuple\n"
                  "  given: the number 3")
   (constrained-state-derivative L-unit circle #:force 3))
  (for ([make (list constrained-state-derivative constrained-accelerations)])
    (check-message
     (format (string-append "~a: the value of a Lagrangian is a number, "
                            "but that of velocity is (up 0 1), an up tuple of 2")
             (object-name make))
     ((make velocity on-unit-circle) (up 0 (up 1 0) (up 0 1)))))
  (define (texts . makers) (for/list ([make makers]) (format "~a" (make L circle))))
  (check-equal? (texts constrained-accelerations constraint-forces consistent-state)
                '("(constrained-accelerations L (holonomic on-circle))"
                  "(constraint-forces L (holonomic on-circle))"
                  "(consistent-state L (holonomic on-circle))")))

;; The curves y = 0 and y = −(x + 1)² touch at x = −1.
(test-case "a motion that begins where two constraints demand the same"
  (define (line t q) (ref q 1))
  (define (parabola t q) (+ (ref q 1) (square (+ 1 (ref q 0)))))
  (check-message
   (string-append "constrained-state-derivative: where the motion begins, constraints depend on "
                  "each other that are independent elsewhere\n"
                  "  state: (up 0 (up -1 0) (up 0 0))\n"
                  "  constraint 1 demands the same as constraint 0")
   (evolve-trajectory
    (constrained-state-derivative L-unit (list (holonomic line) (holonomic parabola)))
    (up 0 (up -1 0) (up 0 0)) 1)
   exn:fail:mechanics:singular?))

(test-case "an augmented Lagrangian: holonomic constraints, coordinates with multipliers"
  (check-exn #rx"^augmented-Lagrangian: with a nonholonomic constraint"
             (lambda () (augmented-Lagrangian L (nonholonomic (lambda (t q v) (ref v 0))))))
  (check-message
   "augmented-Lagrangian: expected coordinates with multipliers, (up q lambda); given the symbol x"
   ((augmented-Lagrangian L circle) (up 't 'x 'v)))
  (check-message
   (string-append "augmented-Lagrangian: the multipliers must be a number, like the constraints\n"
                  "  multipliers: (up lambda mu)\n"
                  "  constraints: (- (+ (* x x) (* y y)) (* l l))")
   ((augmented-Lagrangian L circle)
    (up 't (up (up 'x 'y) (up 'lambda 'mu)) (up (up 'vx 'vy) (up 0 0))))))

(test-case "a multiplier that is a number"
  (check-message
   "constrained-Lagrange-equations: multipliers are functions of time, as paths are; given the number 0\n  a constant one is (lambda (t) 0)"
   ((constrained-Lagrange-equations L circle) xy 0)))
