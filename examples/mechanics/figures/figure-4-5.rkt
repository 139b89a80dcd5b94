#lang mechanics
;; A quartet of multipliers  (SICM 4.2.3, Figure 4.5)
;;
;; Of two degrees of freedom: the body at rest at the third corner of a triangle with two others,
;; which turn (SICM 1.8.3), looked at after each time 1.5.  As the lighter one gets heavier, two
;; pairs on the unit circle come together, at the part 0.0385 of both masses, and leave it as
;; four: a number, its conjugate, and the inverses of both.  Red, for the part 0.1.

(require mechanics/plot mechanics/book
         (only-in racket/base real-part imag-part))

(define period 1.5)
(define (multipliers mu)
  (define-values (x y) (values (- 1/2 mu) (/ (sqrt 3.) 2)))
  (Floquet-multipliers (Hamiltonian->state-derivative
                        (Lagrangian->Hamiltonian (LR3B 1. 1. (- 1 mu) mu)))
                       (up 0. (up x y) (down (- y) x))
                       period))

(define picture
  (frame -1.2 1.8 -2. 3. #:width 350 #:height 500 #:aspect-ratio 'equal
         #:x-label "real part" #:y-label "imaginary part"))
(define (draw mu color size label)
  (for ([z (multipliers mu)])
    (plot-point picture (real-part z) (imag-part z) #:color color #:size size #:label label)))

(plot-parametric picture (up cos sin) 0 :2pi #:style 'dot)
(for ([mu (in-range 0.004 0.14 0.004)]) (draw mu 'black 2 #f))
(draw 0.02 'blue 8 "stable")
(draw 0.1 'red 8 "a quartet")

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-4-5.png"))

(module+ test
  (require rackunit)
  (define (in? z all) (for/or ([w all]) (< (magnitude (- z w)) 1e-5)))
  (test-case "with each its inverse and its conjugate"
    (for* ([mu '(0.01 0.03 0.05 0.1 0.2)])
      (define all (multipliers mu))
      (check-equal? (length all) 4)
      (for ([z all])
        (check-true (in? (/ 1 z) all))
        (check-true (in? (- (* 2 (real-part z)) z) all))))
    (check-= (apply * (multipliers 0.1)) 1 1e-8))
  (test-case "up to Routh's ratio all are on the unit circle, beyond it none is"
    (define Routh (* 1/2 (- 1 (sqrt (/ 23.0 27)))))
    (check-= Routh 0.0385 1e-4)
    (for ([z (multipliers (- Routh 0.003))]) (check-= (magnitude z) 1 1e-8))
    (for ([z (multipliers (+ Routh 0.003))]) (check-true (> (abs (- (magnitude z) 1)) 0.01))))
  (test-case "they are the exponentials of the exponents: λ⁴ + λ² + (27/4) μ (1 − μ) = 0"
    (for* ([mu '(0.02 0.1)] [z (multipliers mu)])
      (define lambda-1 (/ (log z) period))
      (define residue
        (+ (expt lambda-1 4) (square lambda-1) (* 27/4 mu (- 1 mu))))
      (check-= (magnitude residue) 0 1e-7))))
