#lang mechanics
;; The pendulum on its head: contours and section  (SICM 7.4.5, Figure 7.14)
;;
;; The pivot of a pendulum is shaken by 3 cm, a hundred times as fast as it swings.  All waves that
;; hold the phase of the drive are removed to the second order; what is left has waves of θ alone.
;; Left its contours, right the section of the pendulum: both rest at the top, too.
;;
;; Note: the cos 2θ of the averaged Hamiltonian has a minus here, where the book's (7.85) prints a
;; plus; with a plus the top would never be stable.  The tests prove the minus, and that it gives
;; the book's condition (7.88), which is 2γ² > αβω²: (7.87) prints it without the 2.

(require mechanics/plot (only-in "resonances.rkt" boundary))

;; m = 1 kg, l = 1 m: α = m l² = 1, β = m g l, γ = m l A ω²/2
(define-values (beta A) (values 9.8 0.03))
(define omega (* 100 (sqrt beta)))
(define gamma (* 1/2 A (square omega)))

;; (7.85), with α, without what depends on neither θ nor p
(define ((averaged alpha beta gamma omega) theta p)
  (define-values (p2 w2) (values (square p) (square (* alpha omega))))
  (+ (/ p2 (* 2 alpha))
     (* -1 beta (cos theta))
     (* alpha (square gamma) (+ w2 p2) (/ 1 (* 2 (square (- w2 p2)))) (- 1 (cos (* 2 theta))))))
(define energy (averaged 1 beta gamma omega))

(define ((shaken) (up t theta p))
  (up 1 p (* (sin theta) (- (* 2 gamma (cos (* omega t))) beta))))
(define later (stroboscopic-map (shaken) (/ :2pi omega) #:tolerance 1e-9))
(define (T theta p return fail)
  (define s (later (up 0. theta p)))
  (return (coordinate s) (momentum s)))

;; Both from the bottom to the bottom, with the top in the middle
(define angle (principal-value :2pi))
(define picture
  (frame 0 (* 2 :2pi) -12. 12. #:width 700 #:height 400
         #:x-label "θ of the average, and 2π + θ of the pendulum" #:y-label "p"))
(define starts '((3.3 0.) (3.6 0.) (3.9 0.) (4.2 0.) (0.3 0.) (0.8 0.) (1.2 0.) (1.6 0.)
                 (3.14 7.) (3.14 9.) (3.14 11.) (3.14 -7.) (3.14 -9.) (3.14 -11.)))
(plot-contours picture
               (lambda (theta p) (if (< theta :2pi) (energy theta p) 1e3))
               (for/list ([start starts]) (apply energy start)) #:samples 161)
(void
 (explore-map picture
              (lambda (theta p return fail)
                (T theta p (lambda (theta p) (return (+ :2pi (angle theta)) p)) fail))
              400 #:starts (for/list ([start starts]) (up (+ :2pi (car start)) (cadr start)))))
(plot-line picture :2pi -12. :2pi 12.)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-7-14.png"))

(module+ test
  (require rackunit)
  (define state (up 's (up 'phi 'theta) (down 'P 'p)))
  (define (series-of alpha beta gamma omega)
    (define (rotor (up t q (down P p))) (+ (/ (square p) (* 2 alpha)) (* omega P)))
    (define (three-waves (up t (up phi theta) p))
      (+ (* -1 beta (cos theta)) (* gamma (+ (cos (+ theta phi)) (cos (- theta phi))))))
    (perturbation-series rotor three-waves state #:order 2 #:keep '((0 1)) #:parameter 1))
  (test-case "the averaged Hamiltonian is what the second order leaves"
    (define P (series-of 'alpha 'beta 'gamma 'omega))
    (check-pred proved? (verify-perturbation P))
    (check-pred proved?
                (verify-equal (series:sum ((perturbation-Hamiltonian P) state) 2)
                              (+ (* 'omega 'P)
                                 ((averaged 'alpha 'beta 'gamma 'omega) 'theta 'p)))))
  (test-case "the top is stable for 2γ² > αβω², which is (7.88)"
    (define (slope theta) (((partial 0) (averaged 'alpha 'beta 'gamma 'omega)) theta 0))
    (check-pred proved?
                (verify-equal ((D slope) pi)
                              (- (/ (* 2 (square 'gamma)) (* 'alpha (square 'omega))) 'beta)))
    (define in-metres
      (substitute ((D slope) pi) 'gamma (* 1/2 'm 'l 'A (square 'omega))
                  'alpha (* 'm (square 'l)) 'beta (* 'm 'g 'l)))
    (check-pred proved?
                (verify-equal in-metres
                              (* 1/2 'm (- (square (* 'A 'omega)) (* 2 'g 'l))))))

  ;; The barrier beside the top, by the average and by where orbits cease to swing about the top
  (define barrier (acos (/ (* -1 beta (square omega)) (* 2 (square gamma)))))
  (define (about-the-top? theta p)
    (let loop ([theta theta] [p p] [j 0])
      (cond [(> (abs (- theta pi)) (- pi 1)) #f]
            [(= j 400) #t]
            [else (T theta p (lambda (theta p) (loop theta p (+ j 1))) void)])))
  ;; where the transform takes what the average says
  (define old (perturbation-transformation (series-of 1 beta gamma omega)))
  (define (told theta p) (old (up 0 (up 0 theta) (down 0 p))))
  (test-case "the barrier is where the average has it, to 0.002"
    (check-= (boundary (lambda (theta) (about-the-top? theta 0.)) pi 1.5)
             (ref (told barrier 0.) 1 1) 0.002))
  (test-case "and the island is as high, to 0.005 of 5"
    (define height (sqrt (* 2 (- (energy barrier 0.) (energy pi 0.)))))
    (check-= (boundary (lambda (p) (about-the-top? pi p)) 0. 12.)
             (ref (told pi height) 2 1) 0.005)))
