#lang mechanics
;; Resonances that have merged  (SICM 7.4.1, Figure 7.11)
;;
;; As figure 7.10 with five times the drive, γ = 5/4.  The theory still knows where the islands are.
;; Where its pieces do not fit together there is one chaotic sea.

(require mechanics/plot "resonances.rkt" "composite.rkt")

(define gamma 5/4)
(define starts
  '((0. 0.5) (0. 1.) (0. 1.5) (3.1 0.3) (0. 2.3) (0. -2.3) (0. 2.8) (0. -2.8)
    (3.1 4.5) (3.1 5.) (3.1 5.5) (3.1 6.) (3.1 6.5) (3.1 -4.5) (3.1 -5.) (3.1 -5.5) (3.1 -6.)
    (3.1 -6.5) (0. 7.5) (0. -7.5)))
(define picture (side-by-side gamma starts 120))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-7-11.png"))

(module+ test
  (require rackunit)
  ;; The momenta of three orbits that start between 0 and ω
  (define (heights gamma)
    (define T (driven-map gamma))
    (for*/fold ([ps '()]) ([start '(2.3 2.5 3.)])
      (for/fold ([theta 0.] [p start] [ps ps] #:result ps) ([_ 3000])
        (T theta p (lambda (theta p) (values theta p (cons p ps))) void))))
  (test-case "orbits go from one resonance to the others, as none does with γ = 1/4"
    (define sea (heights gamma))
    (check-true (> (apply max sea) 5))
    (check-true (< (apply min sea) -5))
    (define confined (heights 1/4))
    (check-true (< (apply max confined) 3.8))
    (check-true (> (apply min confined) 0)))
  (test-case "the middles of islands are still where the theory has them, to 0.2"
    (define T (driven-map gamma))
    (define (wrapped theta p return fail)
      (T theta p (lambda (theta p) (return ((principal-value :2pi) theta) p)) fail))
    (define center (find-fixed-point wrapped (up pi 4.5)))
    (check-equal? (fixed-point-kind center) 'elliptic)
    ;; the theory's: where the pendulum rests
    (define rest ((resonant-motion gamma '(-1 1)) pi (ref (fixed-point-coordinates center) 1)))
    (define told (for/list ([j 50]) (ref (rest (/ (* j :2pi) omega)) 1)))
    (check-= (apply max told) (apply min told) 0.4)))
