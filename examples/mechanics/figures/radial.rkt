#lang mechanics
;; The construction of Poincaré and Birkhoff for the driven rotor, the driven pendulum without
;; gravity, m = l = 1, A = 0.1 m and ω = 4.2 √9.8, for figures 4.16 to 4.19.
;;
;; C₀ is the curve of points to which k iterates of the map leave their angle, and C₁ its image, at
;; a height above it at each angle.  Where the curves cross is a fixed point of the k iterates.

(require mechanics/plot mechanics/book)

(provide rotor-map omega turn unchanged-angle height draw-construction crossings net-height
         kind-from-curves)

(define omega (* 4.2 (sqrt 9.8)))
(define rotor-map (driven-pendulum-map 1. 1. 0. 0.1 omega))
(define turn (principal-value :pi))

;; middle : angle -> a momentum by less than `half` beside that of C₀
;; -> the function of the angle of which C₀ is the graph; what was found once it remembers
(define (unchanged-angle k middle half)
  (define known (make-hash))
  (define (search theta)
    (define p (middle theta))
    (radially-mapping-points (iterated-map rotor-map k) (- p half) (+ p half) theta 1e-11))
  (lambda (theta) (hash-ref! known theta (lambda () (search theta)))))

(define ((height k C_0) theta)
  (define p (C_0 theta))
  ((iterated-map rotor-map k) theta p (lambda (theta-after p-after) (- p-after p)) void))

(define (draw-construction picture k C_0)
  (plot-function picture C_0 :-pi :pi 0.06)
  (plot-function picture (lambda (theta) (+ (C_0 theta) ((height k C_0) theta)))
                 :-pi :pi 0.06 #:style 'dot #:width 2)
  (for ([v (crossings k C_0)])
    (plot-point picture (turn (ref v 0)) (ref v 1) #:size 7 #:color 'red)))

;; From the angle −3 to that a turn on.
(define (crossings k C_0)
  (define f (height k C_0))
  (define angles (for/list ([j 25]) (+ -3. (* j (/ :2pi 24)))))
  (define heights (map f angles))
  (for/list ([a angles] [b (cdr angles)] [fa heights] [fb (cdr heights)]
             #:when (negative? (* fa fb)))
    (define theta (bisect f a b 1e-9))
    (up theta (C_0 theta))))

;; The mean of the height, for the map keeps areas.
(define (net-height k C_0)
  (define n 24)
  (/ (for/sum ([j n]) ((height k C_0) (* j (/ :2pi n)))) n))

;; Points above C₀ go to greater angles.  So where C₁ comes from above, as angles grow, and goes
;; below, steps lead around the crossing; else they lead away from it.
(define (kind-from-curves k C_0 v)
  (define (beside side) ((height k C_0) (+ (ref v 0) (* side 1e-3))))
  (if (> (beside -1) (beside 1)) 'elliptic 'hyperbolic))
