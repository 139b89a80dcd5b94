#lang racket/base
;; Questions without sense were answered all the same, by functions of maps and motions, or refused
;; in the name of a function that the reader had not called, or with advice that led nowhere.

(require (except-in mechanics time) mechanics/book mechanics/plot
         "../support/checks.rkt" "../support/messages.rkt")

(define HH (HHmap 1/8 0.1 1e-10 1e-12))
(define on-the-section (section->state 1/8 0.1 0))
(define runs-away (section->state 1/8 5 5))
(define crossing (event (lambda (s) (ref (coordinate s) 0))))
(define shaken (H-pend-sysder 1 1 9.8 0.05 13))
(define swing (Lagrangian->state-derivative (L-pendulum 9.8 1 1)))
(define twist (standard-map 0.8))
(define golden (/ 1 golden-ratio))

;; ---------------------------------------------------------------------------
;; Computed all the same

(says
 [(Floquet-multipliers shaken (up 0 :pi 0) 0)
  "Floquet-multipliers: expected a period that is not 0\n  given: the number 0"]
 [(unstable-manifold twist 0 0 0 0 2 1e-8)
  "unstable-manifold: the direction (dx, dy) is 0; it may be of any length but that"]
 [(invariant-circle twist golden #:most-modes 0)
  "invariant-circle: expected #:most-modes, a positive integer\n  given: the number 0"]
 [(invariant-circle-limit standard-map golden 0.9 1.0 #:most-modes -1)
  "invariant-circle-limit: expected #:most-modes, a positive integer\n  given: the number -1"]
 [(explore-map (frame 0 1 0 1) twist 9 #:starts (list (up 0 0) (up +nan.0 0)))
  "explore-map: start 1 is not of finite numbers\n  given: (up +nan.0 0), an up tuple of 2"]
 [(explore-map (frame 0 1 0 1) twist 9 #:starts (list (up 0 +inf.0)))
  "explore-map: start 0 is not of finite numbers\n  given: (up 0 +inf.0), an up tuple of 2"])

(test-case "a rotation number is not negative, and that of a swing is none"
  (define r (rotation-number HH (up 0.25 0) 500))
  (check-true (>= (rotation-value r) 0))
  (check-regexp-match #rx"does not turn; how an orbit turns about a point, #:about tells"
                      (format "~a" r))
  (check-false (regexp-match? #rx"#:about" (format "~a" (rotation-number twist (up 0 2)))))
  (check-false (regexp-match? #rx"#:about"
                              (format "~a" (rotation-number HH (up 0.25 0) 500
                                                            #:about (up 0.3 0))))))

;; So many steps would fill the memory.
(says
 [(rotation-number twist (up 3 0) 1000000000)
  "rotation-number: expected an orbit of at most 10000000 steps\n  given: the number 1000000000\n"
  "  10000 give ten digits and more where the orbit is regular"])

;; ---------------------------------------------------------------------------
;; In whose name

(says
 [(Floquet-multipliers shaken (up 0 :pi 0) 1 #:tolerance 0)
  "Floquet-multipliers: expected a positive tolerance\n  given: the number 0"]
 [(maximal-Lyapunov-exponent (HHsysder) on-the-section 10 #:tolerance 0)
  "maximal-Lyapunov-exponent: expected a positive tolerance\n  given: the number 0"]
 [(find-invariant-curve twist golden 0 2.0 5.0 0)
  "find-invariant-curve: expected a positive tolerance\n  given: the number 0"]
 [(section->state 1/8 'y 0)
  "section->state: expected a real number as y\n  given: the symbol y"]
 [(which-way? 0.38 0 2.0) "which-way?: takes 4 or 5 arguments; it was given 3"]
 [((linearized-flow L-pendulum 9.8 1 1) (up 0 0 0) 2)
  "linearized-flow: the state derivative is of another shape than the state\n"
  "  state: (up 0 0 0)\n  derivative: 9.8\n"
  "  (Lagrangian->state-derivative L) makes a state derivative of a Lagrangian"])

(define-check (check-tells-state who thunk)
  (define message (message-of (thunk) exn:fail:mechanics:singular?))
  (define expected
    (regexp (string-append "^" who ": the motion cannot be followed any further\n"
                           "  last state: .up 1[.]22[0-9]* .up [^ ]* [^ ]*. .down [^ ]* [^ ]*..$")))
  (unless (regexp-match? expected message)
    (with-check-info (['message message]) (fail-check))))

(test-case "the last state is told without the displacements followed with it"
  (check-tells-state "Lyapunov-exponents"
                     (lambda () (Lyapunov-exponents (HHsysder) runs-away 10)))
  (check-tells-state "linearized-flow"
                     (lambda () ((linearized-flow (HHsysder)) runs-away 10))))

;; These were answered by Racket, or by bisect.
(says
 [(which-way? 'a 0 2 twist)
  "which-way?: expected a real number as rotation number\n  given: the symbol a"]
 [(which-way? golden 0 (up 1 2) twist)
  "which-way?: expected a real number as action\n  given: (up 1 2), an up tuple of 2"]
 [(which-way? golden +nan.0 2 twist)
  "which-way?: expected a real number as angle\n  given: the number +nan.0"]
 [(which-way? golden 0 2 twist -1)
  "which-way?: expected how many steps at most, a natural number\n  given: the number -1"]
 [(radially-mapping-points twist sin 2.4 1.0 1e-12)
  "radially-mapping-points: expected a real number as least action\n"
  "  given: the procedure `sin`"]
 [(radially-mapping-points (iterated-map (standard-map 0.3) 3) 1.8 2.4 1.0 0)
  "radially-mapping-points: expected a positive tolerance\n  given: the number 0"]
 [(radially-mapping-points twist 1.8 2.4 1.0 +inf.0)
  "radially-mapping-points: expected a real number as tolerance\n  given: the number +inf.0"]
 [(Baker-Campbell-Hausdorff HHHam (lambda () 1))
  "Baker-Campbell-Hausdorff: expected two operators, or two Hamiltonians; given the procedure "
  "`HHHam` and a function without a name"])

;; ---------------------------------------------------------------------------
;; Advice

(define sections-of-motions "expected a state derivative, a function of the state")

(says
 [(Lyapunov-exponents HH (up 0.1 0.1) 100)
  "Lyapunov-exponents: expected a state derivative; this is a map of the plane: HHmap\n"
  "  of maps there is (maximal-Lyapunov-exponent map point steps)"]
 [(Poincare-map HHsysder crossing)
  "Poincare-map: " sections-of-motions "; given the procedure `HHsysder`, which takes 0 arguments\n"
  "  it makes one: (HHsysder)"]
 [((Poincare-map HHHam crossing) (up 0 (up 0 1/2) (down 1 0)))
  "Poincare-map: the state derivative is of another shape than the state\n"
  "  state: (up 0 (up 0 1/2) (down 1 0))\n  derivative: 0.5833333333333334\n"
  "  (Hamiltonian->state-derivative H) makes a state derivative of a Hamiltonian"]
 [((evolve swing 9.8) (up 0 1 0) void 1 10)
  "evolve: it makes a state derivative of the parameters, and this is one already\n"
  "  given: (Lagrangian->state-derivative L-pendulum)\n  parameters: (9.8)\n"
  "  what takes them is as (lambda (m) (Lagrangian->state-derivative (L m)))"]
 [(evolve-ensemble swing (list (up 0 1 0)) 10 #:parameters '((9.8)))
  "evolve-ensemble: it makes a state derivative of the parameters, and this is one already\n"
  "  given: (Lagrangian->state-derivative L-pendulum)\n  parameters: (9.8)\n"
  "  what takes them is as (lambda (m) (Lagrangian->state-derivative (L m)))"]
 [((F->C p->r) (up 't (up 'r 'phi) (down 'p_r 'p_phi)))
  "F->C: the velocities are not of the shape of the coordinates\n"
  "  coordinates: (up r phi)\n  velocities: (down p_r p_phi)\n"
  "  they are momenta: states of these are transformed by (F->CH F)"])

(says
 [((phase-space-divergence HHHam) (up 0 (up 0 1/2) (down 1 0)))
  "phase-space-divergence: the state derivative is of another shape than the state\n"
  "  state: (up 0 (up 0 1/2) (down 1 0))\n  derivative: 7/12\n"
  "  (Hamiltonian->state-derivative H) makes a state derivative of a Hamiltonian"])

(test-case "points of a section that are fixed at each energy"
  (define rising (event (lambda (s) (ref (coordinate s) 0)) #:direction 'rising))
  (check-regexp-match
   #rx"for each energy.*at one energy it is a map of the plane: .define .map q p return fail"
   (message-of (find-fixed-point (Poincare-map (HHsysder) rising) (section->state 1/8 0.3 0))
               exn:fail:mechanics?)))

;; Van der Pol's oscillator keeps no energy: its limit cycle is at x = 2.0086 where v = 0.
(test-case "the section of a limit cycle has a point that is fixed"
  (define (van-der-Pol s)
    (define-values (x v) (values (ref s 1) (ref s 2)))
    (up 1 v (- (* (- 1 (square x)) v) x)))
  (define at-rest (event (lambda (s) (ref s 2)) #:direction 'falling))
  (define p (find-fixed-point (Poincare-map van-der-Pol at-rest) (up 0 2 0)))
  (check-= (ref (fixed-point-coordinates p) 1) 2.00861986 1e-7))

(test-case "circles that are not there"
  (define-syntax-rule (told expression)
    (message-of expression exn:fail:mechanics:not-convergent?))
  (check-regexp-match #rx"whole turns, 0[.]61803398874989[0-9]* is the same rotation"
                      (told (invariant-circle twist golden-ratio #:most-modes 64)))
  (check-regexp-match
   (string-append
    "^invariant-circle-limit: no circle was found at the first of the two parameters, "
    "where it is to be\n  first: 1.1\n  second: 0.9\n"
    "  why: no invariant circle was found: the orbit that turns most like it lies on no curve,\n"
    "  as where the motion is chaotic; it may have broken up\n"
    "  rotation number: 0.3819660112501052\n  start of the orbit: [(]up 0.0 2.0743593599[0-9]*[)]$")
   (told (invariant-circle-limit standard-map (- 1 golden) 1.1 0.9 #:most-modes 64))))

(test-case "a parameter that is 1 is no name"
  (define P
    (perturbation-series (H0 'alpha) (H1 'beta) (up 't 'theta 'p) #:order 1 #:parameter 1))
  (check-regexp-match #rx"^perturbation to order 1\n" (format "~a" P)))

;; ---------------------------------------------------------------------------
;; The order of arguments, which was told as that of a point, or by the user's own `ref`

(define at (up 0 0.1 0.2))

(says
 [(maximal-Lyapunov-exponent (up 0.1 0.2) twist 100)
  "maximal-Lyapunov-exponent: the state derivative or map comes first, then the start and how "
  "long\n"
  "  given first: (up 0.1 0.2), an up tuple of 2"]
 [(maximal-Lyapunov-exponent at swing 100)
  "maximal-Lyapunov-exponent: the state derivative or map comes first, then the start and how "
  "long\n"
  "  given first: (up 0 0.1 0.2), an up tuple of 3"]
 [(maximal-Lyapunov-exponent swing 100 at)
  "maximal-Lyapunov-exponent: the start comes before how long it is followed\n"
  "  given second: the number 100"]
 [(Lyapunov-exponents swing 100 at)
  "Lyapunov-exponents: the state comes before how long it is followed\n"
  "  given second: the number 100"]
 [(Lyapunov-exponents 100 swing at)
  "Lyapunov-exponents: the state derivative comes first, then the state and how long\n"
  "  given first: the number 100"]
 [(Floquet-multipliers swing 3 at)
  "Floquet-multipliers: the state comes before the period\n  given second: the number 3"])
