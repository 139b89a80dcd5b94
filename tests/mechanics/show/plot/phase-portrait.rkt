#lang racket/base
;; Phase portraits with their separatrices.

(require mechanics
         mechanics/book
         mechanics/plot
         (only-in mechanics/show/plot/frame frame-now)
         (only-in mechanics/show/plot/picture-layer
                  layer-data layer-kind layer-style style-color field-level)
         (only-in mechanics/show/plot/phase-portrait places-of-rest
                  place-q place-p place-energy place-kind)
         "../../support/checks.rkt" "../../support/close.rkt" "../../support/messages.rkt")

(define (levels f color)
  (for/list ([l (frame-now f)]
             #:when (and (eq? (layer-kind l) 'level) (equal? (style-color (layer-style l)) color)))
    (field-level (layer-data l))))

(define pendulum (Lagrangian->Hamiltonian (L-pendulum 9.8 1 1)))

(test-case "the pendulum: two saddles of one energy have one separatrix, at just that energy"
  (define win (frame -4 4 -10 10))
  (check-eq? (plot-phase-portrait win pendulum #:orbits 7) win)
  (check-close (levels win 'red) '(9.8) 1e-13)
  (check-equal? (length (levels win 'gray)) 7)
  (check-equal? (length (frame-points win)) 3))

(define (double-well s)
  (define x (coordinate s))
  (+ (* 1/2 (square (momentum s))) (* 1/4 (expt x 4)) (* -1/2 (square x))))

(test-case "places of rest are found once each, with their kinds and energies"
  (define all (places-of-rest 'test double-well '(-2.0 2.0 -1.5 1.5)))
  (define in-order (sort all < #:key place-q))
  (check-equal? (map place-kind in-order) '(centre saddle centre))
  (check-close (map place-q in-order) '(-1 0 1) 1e-12)
  (check-close (map place-p in-order) '(0 0 0) 1e-12)
  (check-close (map place-energy in-order) '(-1/4 0 -1/4) 1e-12))

(test-case "orbits part the frame into equal areas"
  (define (oscillator s) (* 1/2 (+ (square (momentum s)) (square (coordinate s)))))
  (define win (frame -1 1 -1 1))
  (plot-phase-portrait win oscillator #:orbits 3)
  ;; within the circle the area is 2πE: a quarter of 4 is left inside at E = 1/2π
  (check-close (car (levels win 'gray)) (/ 1 :2pi) 0.02)
  (check-equal? (levels win 'red) '()))

(test-case "the energy may be that of a Lagrangian, over velocities"
  (define win (frame -4 4 -10 10))
  (plot-phase-portrait win (Lagrangian->energy (L-pendulum 9.8 1 1)) #:orbits 0)
  (check-close (levels win 'red) '(9.8) 1e-12))

(define win (frame -1 1 -1 1))
(define (driven s) (+ (square (momentum s)) (* (time s) (coordinate s))))
(define (plane s) (up (coordinate s) (momentum s)))

(test-case "what is no energy"
  (check-exn (regexp (string-append "^plot-phase-portrait: expected the energy of a system of one "
                                    "degree of freedom, a function of a state \\(up t q p\\)\n"
                                    "  its value: .*, an up tuple of 2$"))
             (lambda () (plot-phase-portrait win plane))))

(says
 [(plot-phase-portrait win driven)
  "plot-phase-portrait: the energy depends on the time, so that orbits cross in this plane\n"
  "  a stroboscopic-map shows them once in each period"]
 [(plot-phase-portrait win pendulum #:orbits -1)
  "plot-phase-portrait: expected how many orbits, from 0 to 500\n  given: the number -1"])

;; A Lagrangian has a value at each point, too; its contours are no orbits.
(define (V-well s) (square (coordinate s)))
(define (T-well s) (square (momentum s)))
(define (no-energy given)
  (string-append "plot-phase-portrait: orbits are curves of constant energy, which a Lagrangian is "
                 "not\n  given: " given
                 "\n  over momenta: (plot-phase-portrait f (Lagrangian->Hamiltonian L))"
                 "\n  over velocities: (plot-phase-portrait f (Lagrangian->energy L))"))
(define wanted
  (string-append "plot-phase-portrait: expected the energy of a system of one degree of freedom, "
                 "a function of a state (up t q p)\n"))
(define (H-two m s) (* m (square (momentum s))))

(says
 [(plot-phase-portrait win (L-pendulum 9.8 1 1)) (no-energy "L-pendulum")]
 [(plot-phase-portrait win (- T-well V-well)) (no-energy "(- T-well V-well)")]
 [(plot-phase-portrait win 'H)
  wanted "  given: the symbol H\n  with its quote it is only a name; the function itself is H"]
 [(plot-phase-portrait win H-two)
  wanted "  given: the procedure `H-two`, which takes 2 arguments\n"
  "  parameters are supplied first: (H-two ...)"])

(test-case "energies that are called so are drawn"
  (define (H s) (+ (T-well s) (V-well s)))
  (for ([energy (list H (+ T-well V-well) (Lagrangian->energy (L-pendulum 9.8 1 1)))])
    (define win (frame -1 1 -1 1))
    (check-eq? (plot-phase-portrait win energy #:orbits 1) win)))
