#lang mechanics
;; The rate of turning about its own axis  (SICM 2.10, Figure 2.7)
;;
;; ψ̇ = p_ψ/C − φ̇ cos θ rises and falls with the precession.

(require "top.rkt" (only-in racket/list argmax))

(define picture (draw-against-time spin 170. 205. "Dψ"))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-2-7.png"))

(module+ test
  (require rackunit)
  (define (along-axis s)
    (+ (spin s) (* (ref (velocity s) 1) (cos (tilt s)))))
  (test-case "the spin along the axis is kept, and the rate of ψ is not"
    (define spins (for/list ([t (in-range 0. 2. 0.001)]) (spin (top t))))
    (check-= (apply max spins) 200 1e-6)
    (check-true (< 170 (apply min spins) 195))
    (for ([t (in-range 0. 2. 0.1)])
      (check-= (along-axis (top t)) (along-axis start) 1e-8)))
  (test-case "it turns fastest where it is most upright"
    (define times (for/list ([i 4001]) (* i 0.0005)))
    (define fastest (argmax (lambda (t) (spin (top t))) times))
    (check-= (tilt (top fastest)) 0.4 1e-3)))
