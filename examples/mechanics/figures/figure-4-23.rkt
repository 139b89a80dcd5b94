#lang mechanics
;; How often the golden curve is visited where it breaks up  (SICM 4.6.2, Figure 4.23)
;;
;; At K = 0.971635406 its Fourier series converges no more.  But it is the limit of orbits of a
;; period q with convergents as their rotation numbers, which visit all their points equally; so
;; the density is 1/q for each gap between neighbours.  Here q = 2584.  Valleys are self-similar,
;; and from one q to a greater one get deeper without end.  (J. Greene 1979.)

(require mechanics/plot mechanics/book "kicks.rkt")

(define critical 0.971635406)

;; A point of period q beside the golden curve
(define (nearly-golden K q)
  (define T (standard-map K))
  (define beside (find-invariant-curve T golden 0. 2. 2.2 1e-9))
  (find-fixed-point T (up 0. beside) #:period q #:tolerance 1e-9))

(define turn (principal-value :2pi))
(define (orbit-angles K q)
  (define start (fixed-point-coordinates (nearly-golden K q)))
  (for/fold ([all '()] [x (ref start 0)] [y (ref start 1)] #:result (reverse all)) ([k q])
    ((standard-map K) x y (lambda (x y) (values (cons (turn x) all) x y)) void)))

;; Lists (angle density), the mean density on the circle being 1
(define (orbit-densities K q)
  (define angles (sort (orbit-angles K q) <))
  (for/list ([a angles] [b (append (cdr angles) (list (+ :2pi (car angles))))])
    (list (turn (/ (+ a b) 2)) (/ :2pi q (- b a)))))

(define win
  (frame 0 :2pi 0 3 #:width 600 #:height 400 #:x-label "θ" #:y-label "relative density"))
(for ([place (orbit-densities critical 2584)]) (plot-point win (car place) (cadr place)))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-4-23.png"))

(module+ test
  (require rackunit)
  ;; Greene's residue, of which the sign tells elliptic from hyperbolic points
  (define (residue K q)
    (* 1/4 (- 2 (real-part (apply + (fixed-point-multipliers (nearly-golden K q)))))))
  (define (least K q) (apply min (map cadr (orbit-densities K q))))
  (test-case "the orbits go round as convergents of the golden rotation number do"
    (define angles (orbit-angles critical 233))
    (define ways (for/list ([a angles] [b (append (cdr angles) (list (car angles)))])
                   (turn (- b a))))
    (check-= (/ (apply + ways) :2pi) 89 1e-6))
  (test-case "their residues stay at a quarter; for less K they vanish, for more they grow"
    (for ([q '(233 377 610 987)])
      (define r (residue critical q))
      (check-= r (if (> r 0) 0.2501 -0.2554) 1e-3))
    (check-true (< (abs (residue 0.95 233)) 0.01))
    (check-true (> (abs (residue 0.98 233)) 1)))
  (test-case "from the third convergent to the third the deepest valley gets deeper by one factor"
    (define depths (for/list ([q '(144 610 2584)]) (least critical q)))
    (check-= (/ (cadr depths) (car depths)) 0.669 2e-3)
    (check-= (/ (caddr depths) (cadr depths)) 0.669 2e-3))
  (test-case "where there is a curve, K = 0.95, it does not"
    (for ([q '(89 144 233)]) (check-= (least 0.95 q) 0.38 0.02))
    (define curve (map cadr (densities (golden-circle 0.95) 600)))
    (check-= (least 0.95 233) (apply min curve) 0.02)))
