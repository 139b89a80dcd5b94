#lang mechanics
;; The driven pendulum as a rotor with three waves, α = β = 1 and ω = 5, and the theory of its
;; resonances, one at a time, for the figures of section 7.4.
;;
;; With the time as an angle φ = ωt the perturbation is three waves, each with a momentum at which
;; its angle k·(φ, θ) rests.  Near one of these the others are removed by a Lie transform.  A
;; pendulum is left, moved by elliptic functions: into the new variables, on, and back.

(require mechanics/plot)

(provide alpha beta omega rotor-and-clock waves angles-and-momenta
         middle half-width resonant-motion edges
         driven-map goes-along? boundary island-edges section-frame draw-section draw-theory)

(define-values (alpha beta omega) (values 1 1 5))
(define angles-and-momenta (up 's (up 'phi 'theta) (down 'P 'p)))

(define (rotor-and-clock (up t q (down P p))) (+ (/ (square p) (* 2 alpha)) (* omega P)))
(define ((waves gamma) (up t (up phi theta) p))
  (+ (* -1 beta (cos theta))
     (* gamma (+ (cos (+ theta phi)) (cos (- theta phi))))))

;; The momentum in the middle of the resonance k, a list of two integers, and how far its
;; separatrix reaches from there, read off the Hamiltonian.
(define somewhere (up 0 (up 0 0) (down 0 0)))
(define (middle k) (resonance-center rotor-and-clock k somewhere 1))
(define (half-width gamma k)
  (ref (resonance-width rotor-and-clock (waves gamma) k somewhere) 1))

;; ---------------------------------------------------------------------------
;; The theory

;; (((resonant-motion gamma k) theta p) t) : angle and momentum, an up tuple, at the time t
(define (resonant-motion gamma k #:order [order 1])
  (define P
    (perturbation-series rotor-and-clock (waves gamma) angles-and-momenta
                         #:order order #:keep (list k) #:parameter 1))
  (define-values (old new) (values (perturbation-transformation P) (perturbation-inverse P)))
  (define pendulum (pendulum-of P k))
  (lambda (theta p)
    (define on (pendulum (new (up 0 (up 0 theta) (down 0 p)))))
    (lambda (t)
      (define s (old (on t)))
      (up (ref (coordinate s) 1) (ref (momentum s) 1)))))

;; The wave A cos σ that was kept, with σ = k·(φ, θ) and p = p* + k₁ J, is a pendulum in σ and J;
;; where A > 0 it hangs at σ = π.
(define (pendulum-of P k)
  (define-values (k0 k1) (values (car k) (cadr k)))
  (define center (middle k))
  (define A (amplitude P center))
  (define shift (if (> A 0) pi 0))
  (define advance (pendulum-advance (/ alpha (square k1)) (abs A)))
  (lambda (s)
    (define-values (phi theta) (values (ref s 1 0) (ref s 1 1)))
    (define on (advance (up 0
                            (- (+ (* k0 phi) (* k1 theta)) shift)
                            (/ (- (ref s 2 1) center) k1))))
    (lambda (t)
      (define later (on t))
      (define phi-later (+ phi (* omega t)))
      (up t
          (up phi-later (/ (- (+ (coordinate later) shift) (* k0 phi-later)) k1))
          (down 0 (+ center (* k1 (momentum later))))))))

(define (amplitude P p)
  (for/sum ([r (perturbation-resonances P)])
    (substitute (caddr r) 'phi 0 'theta 0 'p p)))

;; The momenta, lowest and highest, of the separatrix at the angle at which it is widest, and
;; where the transformation takes them.
(define (edges gamma k)
  (define P
    (perturbation-series rotor-and-clock (waves gamma) angles-and-momenta
                         #:keep (list k) #:parameter 1))
  (define theta (if (> (amplitude P (middle k)) 0) pi 0.))
  (define old (perturbation-transformation P))
  (for/list ([side '(-1 1)])
    (define p (+ (middle k) (* side (half-width gamma k))))
    (ref (old (up 0 (up 0 theta) (down 0 p))) 2 1)))

;; ---------------------------------------------------------------------------
;; Sections, at the times at which the drive has its phase 0

(define ((driven gamma) (up t theta p))
  (up 1
      (/ p alpha)
      (* (sin theta) (- (* 2 gamma (cos (* omega t))) beta))))
(define period (/ :2pi omega))
(define angle (principal-value :pi))

;; The pendulum itself, by integration; the angle counts turns.
(define (driven-map gamma)
  (define later (stroboscopic-map (driven gamma) period #:tolerance 1e-10))
  (lambda (theta p return fail)
    (define s (later (up 0. theta p)))
    (return (coordinate s) (momentum s))))

;; Does an orbit go along with σ = k·(φ, θ): does that swing about where it starts by less than half
;; a turn, for n periods?
(define (goes-along? gamma k theta p [n 300])
  (define T (driven-map gamma))
  (let loop ([theta-j theta] [p p] [j 0])
    (define sigma (+ (* (cadr k) (- theta-j theta)) (* (car k) :2pi j)))
    (cond [(> (abs sigma) pi) #f]
          [(= j n) #t]
          [else (T theta-j p (lambda (theta p) (loop theta p (+ j 1))) void)])))

;; The same edges, as they are: where orbits that start at that angle, below the middle and above
;; it, cease to go along.
(define (island-edges gamma k theta p)
  (define (inside? p) (goes-along? gamma k theta p))
  (list (boundary inside? p (- p 4.)) (boundary inside? p (+ p 4.))))

;; Where between two numbers it ceases to be so.
(define (boundary so? in out)
  (define half (* 1/2 (+ in out)))
  (cond [(< (abs (- out in)) 1e-3) half]
        [(so? half) (boundary so? half out)]
        [else (boundary so? in half)]))

(define (section-frame) (frame :-pi :pi -8. 8. #:width 400 #:height 500
                               #:x-label "θ" #:y-label "p"))

;; starts : lists (θ p)
(define (draw-section picture gamma starts n #:shift [shift 0])
  (define T (driven-map gamma))
  (define (wrapped theta p return fail)
    (T theta p (lambda (theta p) (return (+ shift (angle theta)) p)) fail))
  (explore-map picture wrapped n
               #:starts (for/list ([start starts]) (up (+ shift (car start)) (cadr start))))
  (void))

(define (draw-theory picture gamma k starts n #:order [order 1] #:color [color 'black])
  (define motion (resonant-motion gamma k #:order order))
  (for ([start starts])
    (define at (apply motion start))
    (for ([j n])
      (define point (at (* j period)))
      (plot-point picture (angle (ref point 0)) (ref point 1) #:color color #:size 1.))))
