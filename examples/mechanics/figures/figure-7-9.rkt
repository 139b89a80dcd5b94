#lang mechanics
;; Resonances of the driven pendulum  (SICM 7.4, Figure 7.9)
;;
;; The section at the times of the drive, α = β = 1, γ = 1/4, ω = 5, and over it what the theory
;; says of its resonances: the middle of each, and how far its separatrix reaches.  They are the
;; pendulum's own and two of the drive, in which the pendulum turns along with it.

(require mechanics/plot)

(define-values (alpha beta gamma omega) (values 1 1 1/4 5))

(define (rotor-and-clock (up t q (down P p))) (+ (/ (square p) (* 2 alpha)) (* omega P)))
(define (waves (up t (up phi theta) p))
  (+ (* -1 beta (cos theta))
     (* gamma (+ (cos (+ theta phi)) (cos (- theta phi))))))

(define somewhere (up 0 (up 0 0) (down 0 0.)))
(define resonances '((0 1) (1 -1) (1 1)))
(define (center k) (resonance-center rotor-and-clock k somewhere 1))
(define (width k) (ref (resonance-width rotor-and-clock waves k somewhere) 1))

;; The same pendulum with the time as it is
(define ((flow) (up t theta p))
  (up 1
      (/ p alpha)
      (+ (* -1 beta (sin theta)) (* 2 gamma (sin theta) (cos (* omega t))))))
(define period (/ (* 2 pi) omega))
(define advance (state-advancer flow))
(define (orbit theta p n)
  (for/fold ([states (list (up 0 theta p))] #:result (reverse states)) ([_ n])
    (define next (advance (car states) period 1e-8))
    (cons (up 0 (coordinate next) (momentum next)) states)))

(define picture (frame :-pi :pi -8 8 #:width 400 #:height 500))
(define starts '((0. 0.5) (0. 1.) (0. 1.5) (0. 2.5) (0. 3.) (0. 3.5) (0. 6.5) (0. 7.)
                 (3.1 5.2) (3.1 5.6) (3.1 -5.2) (3.1 -5.6) (0. -2.5) (0. -3.5) (0. -6.5)))
(for ([start starts])
  (for ([s (orbit (car start) (cadr start) 120)])
    (plot-point picture ((principal-value pi) (coordinate s)) (momentum s))))
(for ([k resonances])
  (for ([edge '(-1 1)])
    (define p (+ (center k) (* edge (width k))))
    (plot-line picture :-pi p :pi p #:color 'red)))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-7-9.png"))

(module+ test
  (require rackunit)
  (test-case "the theory's resonances"
    (for ([k resonances] [p '(0 5 -5)] [w '(2 1 1)])
      (check-= (center k) p 1e-12)
      (check-= (width k) w 1e-12)))
  ;; How far the momenta of an orbit on a resonance go from its middle
  (define (reach theta p)
    (apply max (for/list ([s (orbit theta p 80)]) (abs (- (momentum s) (round p))))))
  (test-case "orbits that start within the width stay within it"
    (check-true (< (reach 3.1 5.2) 1.1))
    (check-true (< (reach 3.1 -5.2) 1.1)))
  (test-case "those between two resonances go round, and do not reach them"
    (define ps (map momentum (orbit 0. 3. 80)))
    (check-true (> (apply min ps) 2))
    (check-true (< (apply max ps) 4.1))))
