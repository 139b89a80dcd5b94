#lang mechanics
;; The pendulum upside down: manifolds, and those of the linear motion  (SICM 4.3, Figure 4.6)
;;
;; About the upright rest.  Solid, the curve W of points that come from it, red, and that go to it,
;; blue; dashed, what is left of them if the motion is linearized there: straight lines V, along the
;; eigenvectors.  The curves touch the lines at the rest.

(require mechanics/plot "strobe.rkt")

(define T (strobe-map 0. 4.2))
(define T-back (strobe-map 0. -4.2))
(define upright (find-fixed-point T (up 3.14 0.)))
(define (branch stable? side)
  (invariant-manifold T upright #:stable? stable? #:inverse T-back #:branch side
                      #:length 6.5 #:gap 0.05))

;; About the upright rest
(define turn (principal-value :pi))
(define (from-rest v) (up (turn (- (ref v 0) :pi)) (ref v 1)))
(define-values (unstable stable)
  (apply values (for/list ([stable? '(#f #t)])
                  (for/list ([side '(1 -1)]) (map from-rest (branch stable? side))))))

;; The multipliers, greatest first, and the slopes of their directions
(define-values (growth slope decay slope-back)
  (apply values
         (fixed-point-eigen T :pi 0. 1e-8
                            (lambda (A dx dy B ex ey) (list A (/ dy dx) B (/ ey ex))))))

(define picture
  (frame -2.2 2.2 -7 10 #:x-label "θ − π" #:y-label "p_θ" #:width 450 #:height 400))
(for ([m (list slope slope-back)] [color '(red blue)] [label '("V u" "V s")])
  (plot-function picture (lambda (u) (* m u)) -2.2 2.2 #:color color #:style 'short-dash
                 #:label label))
(for ([branches (list unstable stable)] [color '(red blue)])
  (for ([points branches]) (draw-branch picture points #:color color)))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-4-6.png"))

(module+ test
  (require rackunit)
  (define omega_0 (sqrt 9.8))
  (test-case "the lines have the slopes ±m l² ω₀, and grow and fall as exp(±ω₀ T)"
    (check-= slope omega_0 1e-8)
    (check-= slope-back (- omega_0) 1e-8)
    (check-= growth (exp (/ :2pi 4.2)) 1e-8)
    (check-= decay (exp (/ :2pi -4.2)) 1e-8))
  (test-case "the curves are the separatrix"
    (for* ([branches (list unstable stable)] [points branches] [v points])
      (check-= (+ (* 1/2 (square (ref v 1))) (* 9.8 (cos (ref v 0)))) 9.8 1e-5)))
  (test-case "they touch the lines: what is between is of the third order"
    (for ([branches (list unstable stable)] [m (list slope slope-back)])
      (for* ([points branches] [v points] #:when (< 0.05 (abs (ref v 0)) 0.6))
        (define u (ref v 0))
        (check-= (/ (- (* m u) (ref v 1)) (cube u) m) 1/24 1e-3))))
  (test-case "unstable ones are left backwards in time, stable ones forwards"
    (define (size v) (+ (abs (ref v 0)) (abs (ref v 1))))
    (define (later map v) (size (from-rest (map (+ pi (ref v 0)) (ref v 1) up void))))
    (for ([points unstable])
      (define v (list-ref points 50))
      (check-= (/ (later T-back v) (size v)) decay 0.1)
      (check-true (> (later T v) (size v))))
    (for ([points stable])
      (define v (list-ref points 50))
      (check-= (/ (later T v) (size v)) decay 0.1)
      (check-true (> (later T-back v) (size v))))))
