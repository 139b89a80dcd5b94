#lang mechanics
;; When resonances overlap  (SICM 7.4.3, Figure 7.12)
;;
;; The section of the driven pendulum, γ = 1/4, and over it what is read off its Hamiltonian: the
;; middle of each resonance and how far its separatrix reaches.  Between 0 and ω there is room as
;; long as 2√(αβ) + 2√(αγ) < αω, so up to γ = 9/4.  Chaos is large before that: second resonances
;; and the chaotic edges of the first take room, too.

(require mechanics/plot "resonances.rkt")

(define gamma 1/4)
(define resonances '((0 1) (-1 1) (1 1)))

(define picture (section-frame))
(draw-section picture gamma
              '((0. 0.5) (0. 1.) (0. 1.5) (0. 2.5) (0. 3.) (0. 3.5) (0. 6.5) (0. 7.)
                (3.1 5.2) (3.1 5.6) (3.1 -5.2) (3.1 -5.6) (0. -2.5) (0. -3.5) (0. -6.5))
              120)
(for ([k resonances])
  (plot-line picture :-pi (middle k) :pi (middle k) #:color 'red #:style 'dot)
  (for ([edge '(-1 1)])
    (define p (+ (middle k) (* edge (half-width gamma k))))
    (plot-line picture :-pi p :pi p #:color 'red)))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-7-12.png"))

(module+ test
  (require rackunit)
  (define (room gamma)
    (- (middle '(-1 1)) (half-width gamma '(-1 1)) (half-width gamma '(0 1))))
  (test-case "middles and half-widths, read off the Hamiltonian"
    (for ([k resonances] [p '(0 5 -5)] [w '(2 1 1)])
      (check-= (middle k) p 1e-12)
      (check-= (half-width gamma k) w 1e-12)))
  (test-case "they touch at γ = 9/4"
    (check-= (room 9/4) 0 1e-12)
    (check-true (> (room 5/4) 0)))
  ;; How far up orbits come that start between the resonances
  (define (climb gamma)
    (define T (driven-map gamma))
    (for*/fold ([most 0.]) ([start '(2.3 2.5 3.)])
      (for/fold ([theta 0.] [p start] [most most] #:result most) ([_ 3000])
        (T theta p (lambda (theta p) (values theta p (max most p))) void))))
  (test-case "what is seen: curves between them at γ = 1/4, none at 5/4, before they touch"
    (check-true (< (climb 1/4) 3.9))
    (check-true (> (climb 5/4) 6))))
