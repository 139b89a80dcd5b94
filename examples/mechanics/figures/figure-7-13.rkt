#lang mechanics
;; Islands of the second order  (SICM 7.4.4, Figure 7.13)
;;
;; Between the resonances 0 and −ω of the driven pendulum lie two small islands, of which the
;; Hamiltonian has no wave.  When the three waves that it has are removed the second order has one,
;; in 2θ + φ, and it is kept.  Left the section of the theory, right that of the pendulum.

(require mechanics/plot "resonances.rkt")

(define gamma 1/4)
(define k '(1 2))
(define P
  (perturbation-series rotor-and-clock (waves gamma) angles-and-momenta
                       #:order 2 #:keep (list k) #:parameter 1))

(define starts '((1.6 -2.5) (1.6 -2.55) (1.6 -2.62) (1.6 -2.7) (1.6 -2.75) (0. -2.7) (0. -3.2)))
(define picture
  (frame :-pi (* 3 pi) -3.5 -1.5 #:width 700 #:height 400
         #:x-label "θ of the theory, and 2π + θ of the pendulum" #:y-label "p"))
(draw-theory picture gamma k starts 200 #:order 2)
(draw-section picture gamma starts 200 #:shift :2pi)
(plot-line picture pi -3.5 pi -1.5)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-7-13.png"))

(module+ test
  (require rackunit)
  (define T (driven-map gamma))
  (define (wrapped theta p return fail)
    (T theta p (lambda (theta p) (return ((principal-value :2pi) theta) p)) fail))
  (define center (find-fixed-point wrapped (up 1.6 -2.5) #:period 2))
  (define old (perturbation-transformation P))

  (test-case "(7.82): the wave that the second order has, in symbols"
    (define (rotor (up t q (down P p))) (+ (/ (square p) (* 2 'alpha)) (* 'omega P)))
    (define (three-waves (up t (up phi theta) p))
      (+ (* -1 'beta (cos theta)) (* 'gamma (+ (cos (+ theta phi)) (cos (- theta phi))))))
    (define Q
      (perturbation-series rotor three-waves angles-and-momenta
                           #:order 2 #:keep '((1 2)) #:parameter 1))
    (define alpha-omega (* 'alpha 'omega))
    (define told
      (* (/ (* 'alpha 'beta 'gamma) (* 4 (square 'p)))
         (/ (+ (square alpha-omega) (* 2 alpha-omega 'p) (* 2 (square 'p)))
            (square (+ alpha-omega 'p)))))
    (define wave (caddr (car (perturbation-resonances Q))))
    (check-pred proved? (verify-equal wave (* told (cos (+ 'phi (* 2 'theta))))))
    ;; (7.83): in the middle of the resonance
    (check-pred proved? (verify-equal (substitute wave 'p (* -1/2 alpha-omega) 'phi 0 'theta 0)
                                      (/ (* 2 'beta 'gamma) (* 'alpha (square 'omega))))))
  ;; The second order without angles moves the momentum where 2 ∂H/∂p + ω = 0.
  (define (energy p)
    (series:sum ((perturbation-Hamiltonian P) (up 0 (up 0 (/ pi 4)) (down 0 p))) 2))
  (define p* (find-root (lambda (p) (+ (* 2 ((D energy) p)) omega)) -2.5))
  (define (told p)
    (define s (old (up 0 (up 0 (/ pi 2)) (down 0 p))))
    (list (ref s 1 1) (ref s 2 1)))
  (test-case "its middle: the pendulum has a stable orbit of two periods there"
    (check-equal? (fixed-point-kind center) 'elliptic)
    (check-= (car (told p*)) (ref (fixed-point-coordinates center) 0) 0.005)
    (check-= (cadr (told p*)) (ref (fixed-point-coordinates center) 1) 0.005))
  (test-case "its width, 2 √(2βγ/ω²): how far from the middle orbits of the pendulum go along"
    (define (second-wave state) (series:ref ((perturbation-Hamiltonian P) state) 2))
    (define half
      (ref (resonance-width rotor-and-clock second-wave k (up 0 (up 0 0) (down 0 -2.5))) 1))
    (check-= half (* 2.0 (sqrt (/ (* 2 beta gamma) (square omega)))) 1e-12)
    (for ([side '(-1 1)])
      (define (inside? x) (apply goes-along? gamma k (told (+ p* (* side x half)))))
      (check-= (boundary inside? 0. 2.) 1 0.1))))
