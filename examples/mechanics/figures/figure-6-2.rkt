#lang mechanics
;; Evolution and Lie transform  (SICM 6.3, Figure 6.2)
;;
;; A trajectory of H', black, is carried point by point by the Lie transform with the generator W
;; to a trajectory of H, blue.  One may go on in time first and over to the other second, or the
;; other way round.  Here H' is an oscillator and W is of the third degree.

(require mechanics/plot)

(define (oscillator (up t q p)) (* 1/2 (+ (square q) (square p))))
(define (W (up t q p)) (* q (square p)))
(define epsilon 0.15)

;; C, from the states of H' to those of H: q and p by the motion of W for a time ε
(define (generated W) (lambda (state) ((Hamiltonian->state-derivative W) state)))
(define carry (state-advancer generated W))
(define ((carried-by epsilon) state)
  (define s (carry (up 0. (coordinate state) (momentum state)) epsilon 1e-12))
  (up (time state) (coordinate s) (momentum s)))
(define-values (C C-inv) (values (carried-by epsilon) (carried-by (- epsilon))))

;; The motion of H' is a turn; H = H' ∘ C⁻¹
(define ((turned Delta) (up t q p))
  (define-values (c s) (values (cos Delta) (sin Delta)))
  (up (+ t Delta) (+ (* c q) (* s p)) (- (* c p) (* s q))))
(define H (compose oscillator C-inv))

(define start (up 0. 1. 0.))
(define picture
  (frame -1.6 1.6 -1.6 1.6 #:aspect-ratio 'equal #:x-label "q" #:y-label "p"))
(define (draw motion color)
  (plot-parametric picture
                   (lambda (t) (define s (motion t)) (up (coordinate s) (momentum s)))
                   0. 5. 0.05 #:color color))
(define (below t) ((turned t) start))
(draw below 'black)
(draw (compose C below) 'blue)
(for ([t '(0. 1. 2. 3. 4. 5.)])
  (define-values (a b) (values (below t) (C (below t))))
  (plot-line picture (coordinate a) (momentum a) (coordinate b) (momentum b) #:color 'red))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-6-2.png"))

(module+ test
  (require rackunit)
  (define line (up 't 'q 'p))
  (test-case "C is canonical, to any order of its Lie series that is taken, up to the next"
    (define excess
      (matrix-ref ((symplectic-transform? (Lie-transformation W 'e 3)) line) 0 1))
    (for ([k 4]) (check-pred proved? (prove-zero (coefficient excess 'e k)))))
  (test-case "its series, summed, is what the motion of W does"
    (define s ((Lie-transformation W epsilon 14) start))
    (define moved ((Lie-transformation W epsilon 14) (up 0. 0.5 0.5)))
    (check-= (coordinate s) (coordinate (C start)) 1e-9)
    (check-= (momentum moved) (momentum (C (up 0. 0.5 0.5))) 1e-9))
  (test-case "the trajectory carried is a trajectory of H: its rate is H's"
    (for ([t '(0.5 1.5 3.)])
      (define s (C (below t)))
      (define rate ((Hamiltonian->state-derivative H) s))
      (define h 1e-4)
      (define-values (a b) (values (C (below (- t h))) (C (below (+ t h)))))
      (check-= (/ (- (coordinate b) (coordinate a)) (* 2 h)) (coordinate rate) 1e-6)
      (check-= (/ (- (momentum b) (momentum a)) (* 2 h)) (momentum rate) 1e-6)))
  (test-case "(6.107): the series of any F is F of the series, order by order"
    (define F (literal-function 'F (Hamiltonian 1)))
    (define terms (((Lie-transform W 'e) F) line))
    (define (composed e) (F ((Lie-transformation W e 3) line)))
    (for ([k 4])
      (check-pred proved?
                  (verify-equal (series:ref terms k)
                                (* (expt 'e k) (/ (((expt D k) composed) 0) (factorial k))))))))
