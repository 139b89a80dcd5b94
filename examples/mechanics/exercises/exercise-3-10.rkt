#lang mechanics
;; Exercise 3.10 (SICM 3.6.2): phase portraits of a driven system
;; Checked: of a driven oscillator with two wells, what stays regular and what is one chaotic zone
;; How: its strobe map: fixed points, rotation numbers, Lyapunov exponents, where an orbit comes

(require mechanics/plot)

;; V(x) = x⁴/4 − x²/2 has wells at ±1 and a hill between them; a force f cos ωt drives it.
(define ((H f omega) s)
  (define-values (t x p) (values (time s) (coordinate s) (momentum s)))
  (+ (* 1/2 (square p)) (* 1/4 (expt x 4)) (* -1/2 (square x)) (* -1 f x (cos (* omega t)))))

(define omega 1.)
(define (strobe f)
  (define period-later (stroboscopic-map (Hamiltonian->state-derivative (H f omega))
                                         (/ :2pi omega)))
  (lambda (x p return fail)
    (define next (period-later (up 0 x p)))
    (return (coordinate next) (momentum next))))
(define T (strobe 0.1))

;; Without a drive it rests in the wells and on the hill; the separatrix is the curve H = 0.
(define (at x p) (up 0 x p))
(define still (plot-phase-portrait (frame -1.8 1.8 -1.2 1.2) (H 0 omega)))
(map (lambda (x) ((D (H 0 omega)) (at x 0))) '(-1 0 1))

;; Driven, periodic motions take the place of rest: in each well, and where the hill is.
(define points (map (lambda (x) (find-fixed-point T (up x 0.))) '(-0.9 -0.05 0.9)))
(map fixed-point-kind points)

;; Is the dust about the wells one chaotic zone?  An attempt: one orbit comes to both sides of
;; the hill, and to either side with either momentum.
(define (orbit x p n)
  (for/fold ([all '()] [x x] [p p] #:result all) ([k n])
    (T x p (lambda (x p) (values (cons (up x p) all) x p)) void)))
(define dust (orbit 0. 0.05 400))
(define (quarter v) (list (positive? (ref v 0)) (positive? (ref v 1))))
(define (quarters all)
  (for/fold ([seen '()]) ([v all]) (if (member (quarter v) seen) seen (cons (quarter v) seen))))
(length (quarters dust))

;; A slip: that all of the plane is like that.  Far out motions are regular.
(define far (rotation-number T (up 0. 2.5) 400 #:about (up 0 0)))
(rotation-regular? far)
(define (growth x p) (car (Lyapunov-values (maximal-Lyapunov-exponent T (up x p) 100))))

(module+ test
  (require rackunit)
  (test-case "undriven it rests in the wells and on the hill"
    (for ([x '(-1 0 1)])
      (check-equal? (ref ((D (H 0 omega)) (at x 0)) 1) 0))
    (check-equal? (length (frame-points still)) 3))
  (test-case "areas are kept, and the hill stays unstable"
    (for ([p points]) (check-= (fixed-point-determinant p) 1 1e-8))
    (check-equal? (fixed-point-kind (list-ref points 1)) 'hyperbolic))
  (test-case "one chaotic zone about the hill, regular motions farther out"
    (check-equal? (length (quarters dust)) 4)
    (check-true (> (growth 0. 0.05) 0.3))
    (check-true (rotation-regular? far))
    (check-true (< (growth 0. 2.5) 0.1))))
