#lang racket/base
;; A beginner's mistakes with maps, and the messages.

(require racket/stream
         mechanics mechanics/book mechanics/plot
         "../support/checks.rkt" "../support/messages.rkt")

(define f (frame 0 7 0 7))
(define omega (* 4.2 (sqrt 9.8)))
(define shaken (H-pend-sysder 1 1 9.8 0.05 omega))
(define T (standard-map 0.6))
(define near (list (up 1 0)))

;; The image is returned, and not handed to `return`.
(define (silent x y return fail) (up (+ x y) y))
(define (of-two x y) (up (+ x y) y))
(define (of-three x y return) (return (+ x y) y))
(define (a-tuple x y return fail) (return (up (+ x y) y)))
(define (goes-on x y return fail) (return x y) (list x y))

(define-syntax-rule (says-silent [who expression point value] ...)
  (says
   [expression
    (string-append who ": the map calls neither `return` nor `fail`\n  map: silent\n"
                   "  point: " point "\n  value: " value "\n"
                   "  the image goes to the third argument: (return x y)")] ...))

(says-silent
 ["explore-map" (explore-map f silent 10 #:starts near) "(up 1.0 0.0)" "(up 1.0 0.0)"]
 ["explore-map" (explore-map f silent 10 #:grid '(1 1)) "(up 3.5 3.5)" "(up 7.0 3.5)"]
 ["find-fixed-point" (find-fixed-point silent (up 1 2)) "(up 1.0 2.0)" "(up 3.0 2.0)"]
 ["periodic-points" (periodic-points silent 1 '(0 1 0 1) #:grid '(1 1))
  "(up 0.5 0.5)" "(up 1.0 0.5)"]
 ["fast-Lyapunov-indicator" (fast-Lyapunov-indicator silent (up 1 2))
  "(up 1.0 2.0)" "(up 3.0 2.0)"]
 ["chaos-map" (chaos-map (frame 0 1 0 1) silent 10 #:samples 1) "(up 0.5 0.5)" "(up 1.0 0.5)"]
 ["maximal-Lyapunov-exponent" (maximal-Lyapunov-exponent silent (up 1 2) 100)
  "(up 1.0 2.0)" "(up 3.0 2.0)"]
 ["orbit-stream" (stream->list (orbit-stream silent 1 2)) "(up 1 2)" "(up 3 2)"]
 ["iterated-map" ((iterated-map silent 10) 1 2 list void) "(up 1 2)" "(up 3 2)"]
 ["iterated-map" ((iterated-map silent 100000) 1.0 2.0 list void) "(up 1.0 2.0)" "(up 3.0 2.0)"])

(says
 [(explore-map f of-two 10 #:starts near)
  "explore-map: expected a map, a procedure of two coordinates and of two procedures\n"
  "  given: the procedure `of-two`, which takes 2 arguments\n"
  "  its image goes to the third argument: (define (map x y return fail) ...)"]
 [(explore-map f of-three 10 #:starts near)
  "explore-map: expected a map, a procedure of two coordinates and of two procedures\n"
  "  given: the procedure `of-three`, which takes 3 arguments\n"
  "  its image goes to the third argument: (define (map x y return fail) ...)"]
 [(find-fixed-point a-tuple (up 1 0))
  "find-fixed-point: the map calls `return` with other things than the coordinates of an image\n"
  "  map: a-tuple\n  point: (up 1.0 0.0)\n  given: (up 1.0 0.0)"]
 [(find-fixed-point goes-on (up 1 0))
  "find-fixed-point: the map goes on after it has called `return` or `fail`; what these give is to "
  "be its value\n  map: goes-on\n  point: (up 1.0 0.0)"])

(define ((family a b c d) x y return fail) (return (+ a x) (+ b y)))

;; A map that takes a decision is called, and goes wrong on the way.
(define (astray x y return fail) (if (> x 0) (return x (list y)) (return (+ x 1) y)))

(says
 [(fast-Lyapunov-indicator astray (up -0.5 0))
  "fast-Lyapunov-indicator: the map calls `return` with other things than the coordinates of an "
  "image\n  map: astray\n  point: (up 0.5 0.0)\n  given: 0.5, (0.0)"])

;; Parameters are missing, or a frame, or the list around a point.
(says
 [(explore-map f standard-map 10 #:starts near)
  "explore-map: expected a map, a procedure of two coordinates and of two procedures\n"
  "  given: the procedure `standard-map`, which takes 1 argument\n"
  "  parameters are supplied first: (standard-map ...)"]
 [(explore-map f driven-pendulum-map 10 #:starts near)
  "explore-map: expected a map, a procedure of two coordinates and of two procedures\n"
  "  given: the procedure `driven-pendulum-map`, which takes 5 arguments\n"
  "  parameters are supplied first: (driven-pendulum-map ...)"]
 [(explore-map f HHmap 10 #:starts near)
  "HHmap: expected a parameter sec-eps that is a real number\n"
  "  given: the procedure `return`"]
 [(explore-map f family 10 #:starts near)
  "explore-map: the map calls neither `return` nor `fail`\n  map: family\n  point: (up 1.0 0.0)\n"
  "  value: family\n  parameters are supplied first: (family ...)"]
 [(explore-map f T #:starts (up 1 0))
  "explore-map: #:starts is a list of points to start at; given (up 1 0), an up tuple of 2\n"
  "  one point in a list: (list (up 1 0))"]
 [(explore-map T f 10 #:starts near)
  "explore-map: expected a frame, such as (frame 0 1 -1 1)\n  given: the procedure `standard-map`"])

(define T-shaken (driven-pendulum-map 1 1 9.8 0.05 omega))

(test-case "maps of the book say by their names how they are called"
  (check-regexp-match #rx"^driven-pendulum-map: " (message-of (T-shaken 1 0)))
  (check-equal? (format "~a" T-shaken) "driven-pendulum-map")
  (check-regexp-match #rx"^HHmap: " (message-of ((HHmap 1/8 0.1 1e-10 1e-12) (up 1 0)))))

;; A motion in place of a map.
(says
 [(find-fixed-point shaken (up 0 1 0))
  "find-fixed-point: a state derivative gives rates, it is no map of states\n"
  "  given: (Hamiltonian->state-derivative (Lagrangian->Hamiltonian (- T-pend V-pend)))\n"
  "  (stroboscopic-map f period) and (Poincare-map f event) make maps of it"]
 [(explore-map f (stroboscopic-map (lambda (s) s) 1) 10 #:starts near)
  "explore-map: expected a map, a procedure of two coordinates and of two procedures\n"
  "  given: (stroboscopic-map <function> 1), a function, which takes 1 argument\n"
  "  it takes a state; with it a map of the plane is (define (map q p return fail) "
  "(let ((s (f (up 0 q p)))) (return (coordinate s) (momentum s))))"]
 [((stroboscopic-map shaken (/ :2pi omega)) (up 1 0))
  "Hamiltonian->state-derivative: expected a Hamiltonian state (up t q p)\n"
  "  given: (up 1.0 0.0), an up "
  "tuple of 2"])

;; A frequency for the period, and other periods that are none.
(says
 [((stroboscopic-map (lambda (s) (up 1 (cos (* 2 (ref s 0))))) 2.0) (up 0.0 1.0))
  "no error"]
 [((stroboscopic-map (lambda (s) (up 1 (ref s 2) (cos (* 2 (ref s 0))))) 2.0) (up 0 1.0 0.0))
  "stroboscopic-map: the rates of the system are others after that time, which is no period\n"
  "  given: 2.0\n  rates now: (up 1 0.0 1)\n  and then: (up 1 0.0 -0.6536436208636119)\n"
  "  what goes as (cos (* omega t)) has the period (/ :2pi omega)"]
 [((stroboscopic-map (lambda (s) (up 1 (ref s 2) (* -1e12 (cos (ref s 0))))) (* 2 pi))
   (up 0.3 0 0))
  "no error"]
 [(stroboscopic-map shaken 0)
  "stroboscopic-map: expected a period that is not 0\n  given: the number 0"]
 [(driven-pendulum-map 1 1 9.8 0.05 0)
  "driven-pendulum-map: expected a parameter omega that is not 0\n  given: the number 0"]
 [(driven-pendulum-map 1 1 9.8 'A omega)
  "driven-pendulum-map: expected a parameter A that is a real number\n  given: the symbol A\n"
  "  give its symbols values first"]
 [(driven-pendulum-map 'm 1 9.8 0.05 omega)
  "driven-pendulum-map: expected a parameter m that is a real number\n  given: the symbol m\n"
  "  give its symbols values first"])

;; A number for a point, a fraction for the rotation number of a circle.
(says
 [(rotation-number T 3)
  "rotation-number: expected a point of the plane, such as (make-point x y)\n  given: the number 3"]
 [(fast-Lyapunov-indicator T (up 'a 0))
  "fast-Lyapunov-indicator: expected a point of real numbers, such as (up 0.1 0.2)\n"
  "  given: (up a 0), an up tuple of 2"]
 [(fixed-point-multipliers (up 0 0))
  "fixed-point-multipliers: expected a fixed point, as find-fixed-point finds one\n"
  "  given: (up 0 0), an up tuple of 2"]
 [(rotation-value 1/3)
  "rotation-value: expected what (rotation-number map start) gives\n  given: the number 1/3"]
 [(invariant-circle T 1/3)
  "invariant-circle: a circle that is kept has an irrational rotation number; this is 1/3\n"
  "  given: 0.3333333333333333\n"
  "  (periodic-points map 3 region) finds what is left of such a circle"]
 [((Poincare-map (HHsysder) (event (lambda (s) (> (ref (coordinate s) 0) 0))))
   (section->state 1/8 0.1 0))
  "Poincare-map: the value of an event's function is a real number\n  event: (event <function>)\n"
  "  value: #f, a boolean\n  it passes through zero: (- a b) where (< a b) changes"])

;; The function that a map is made of, in the map's place.
(define H (Lagrangian->Hamiltonian (L-pendulum 9.8 1 1)))
(define (H-by-hand (up t q p)) (- (* 1/2 (square p)) (cos q)))
(define (energy (up t q p)) (- (* 1/2 (square p)) (cos q)))
(define of-motion
  (string-append "  (stroboscopic-map f period) and (Poincare-map f event) make maps of its "
                 "motion,\n  with f = "))
(define (no-fixed-point given letter kind)
  (string-append "find-fixed-point: expected a map of the plane, or a function of a state\n"
                 "  given: " given "\n" of-motion "(" kind "->state-derivative " letter ")\n"
                 "  where the motion rests, (find-equilibrium " letter " q) finds"))
(define name-of-H "(Lagrangian->Hamiltonian L-pendulum), a Hamiltonian")
(define no-map
  ": expected a map, a procedure of two coordinates and of two procedures\n  given: ")
(define no-rates
  ": expected a state derivative, a function of the state\n  given: ")
(define makes-rates
  "\n  (Hamiltonian->state-derivative H) makes a state derivative of a Hamiltonian")

(says
 [(find-fixed-point H (up 0 0)) (no-fixed-point name-of-H "H" "Hamiltonian")]
 [(find-fixed-point H (up 0 0 0)) (no-fixed-point name-of-H "H" "Hamiltonian")]
 [(find-fixed-point H-by-hand (up 0 0))
  (no-fixed-point "the procedure `H-by-hand`" "H" "Hamiltonian")]
 [(find-fixed-point (L-pendulum 9.8 1 1) (up 0 0))
  (no-fixed-point "the procedure `L-pendulum`" "L" "Lagrangian")]
 [(find-fixed-point energy (up 0 0 0))
  (no-fixed-point "the procedure `energy`" "H" "Hamiltonian")]
 [(find-fixed-point 'H (up 0 0))
  "find-fixed-point: expected a map of the plane, or a function of a state\n"
  "  given: the symbol H\n  with its quote it is only a name; the function itself is H"]
 [(find-fixed-point (up 0 0) T)
  "find-fixed-point: the map comes first, then the point; these look swapped"]
 [(rotation-number H (up 0 0))
  "rotation-number" no-map name-of-H ", which takes 1 argument\n"
  of-motion "(Hamiltonian->state-derivative H)"]
 [(explore-map f 'T 10)
  "explore-map" no-map "the symbol T\n"
  "  with its quote it is only a name; the function itself is T"]
 [(radially-mapping-points sin 1 2 0 1e-8)
  "radially-mapping-points" no-map "the procedure `sin`, which takes 1 argument"]
 [(stroboscopic-map H 1) "stroboscopic-map" no-rates name-of-H makes-rates]
 [(Poincare-map H (event coordinate)) "Poincare-map" no-rates name-of-H makes-rates]
 [(stroboscopic-map 'H 1)
  "stroboscopic-map: expected a state derivative, a function of the state; given the symbol H\n"
  "  with its quote it is only a name; the function itself is H"]
 [((stroboscopic-map H-by-hand 1) (up 0 0 1))
  "stroboscopic-map: the state derivative is of another shape than the state\n"
  "  state: (up 0 0 1)\n  derivative: -0.5" makes-rates])

;; Other orders, and states that are none.
(define rates (Hamiltonian->state-derivative H))

(says
 [(rotation-number (up 1 1) T)
  "rotation-number: the map comes first; it was given after (up 1 1), an up tuple of 2"]
 [(fast-Lyapunov-indicator (up 1 1) T)
  "fast-Lyapunov-indicator: the map comes first; it was given after (up 1 1), an up tuple of 2"]
 [(iterated-map 10 T) "iterated-map: the map comes first; it was given after the number 10"]
 [(invariant-circle 0.6 T)
  "invariant-circle: the map comes first; it was given after the number 0.6"]
 [(orbit-stream 1 T 1) "orbit-stream: the map comes first; it was given after the number 1"]
 [(periodic-points 3 T '(0 1 0 1))
  "periodic-points: the map comes first; it was given after the number 3"]
 [(which-way? T 0.61 0 3) "which-way?: the map comes last: (which-way? rotation-number x0 y0 map)"]
 [(explore-map f (up 1 1) 10)
  "explore-map" no-map "(up 1 1), an up tuple of 2"]
 [(stroboscopic-map 1 rates)
  "stroboscopic-map: the state derivative comes first, then the period; these look swapped"]
 [((stroboscopic-map rates 1) 'q)
  "stroboscopic-map: expected a state, a tuple of real numbers such as (up t q v)\n"
  "  given: the symbol q\n  give its symbols values first"])

(says
 [(which-way? 0.6 'a 1 T)
  "which-way?: expected a real number as angle\n  given: the symbol a"]
 [(which-way? +inf.0 0 1 T)
  "which-way?: expected a real number as rotation number\n  given: the number +inf.0"]
 [(Lyapunov-exponents T (up 0 1) 100)
  "Lyapunov-exponents: expected a state derivative; this is a map of the plane: standard-map\n"
  "  of maps there is (maximal-Lyapunov-exponent map point steps)"])

(test-case "an angle that goes round does not come back, and what does is told"
  (define next (Poincare-map rates (event coordinate)))
  (check-exn #rx"come back to the surface\n  an angle that goes round passes a value once; its sine"
             (lambda () (next (up 0 0 9)))
             "rotating")
  (define failure
    (with-handlers ([exn:fail:mechanics:not-convergent? values]) (next (up 0 0 9))))
  (check-equal? (exn:fail:mechanics:not-convergent-value failure) (up 0 0 9))
  (check-false (exn:fail:mechanics:not-convergent-error-estimate failure))
  (define turning (Poincare-map rates (event (compose sin coordinate) #:direction 'rising)))
  (check-= (coordinate (turning (up 0 0 9))) (* 2 pi) 1e-9))

(test-case "a section of states without a time; a motion that comes to rest is given up before long"
  (define (oscillator s) (up (ref s 1) (- (ref s 0))))
  (define next ((Poincare-map oscillator (event (lambda (s) (ref s 1)))) (up 1.0 0.0)))
  (check-= (ref next 0) -1 1e-10)
  (define (falling s) (up 1 (- (cube (ref s 1)))))
  (check-regexp-match
   #px"\n  steps: \\d{1,3}$"
   (message-of ((Poincare-map falling (event (lambda (s) (+ 1 (ref s 1))))) (up 0 1.0))
               exn:fail:mechanics?)))
