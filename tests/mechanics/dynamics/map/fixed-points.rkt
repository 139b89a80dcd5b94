#lang racket/base
;; Fixed and periodic points, and what maps do near them.

(require (only-in racket/flonum flvector)
         mechanics
         mechanics/book
         (only-in mechanics/dynamics/map/displacement-index index-round)
         (only-in mechanics/dynamics/map/map-on-tuples make-map-on-tuples returns-after)
         "../../support/checks.rkt" "../../support/close.rkt" "../../support/messages.rkt"
         "../../support/notes.rkt")

(define (found map guess [period 1]) (find-fixed-point map guess #:period period))

(test-case "of the standard map, where the formulas say, for several K"
  (for ([K '(0.6 1.4 3.0)])
    (define center (found (standard-map K) (up 3.0 0.1)))
    (define saddle (found (standard-map K) (up 0.1 -0.1)))
    (check-close (fixed-point-coordinates center) (up :pi 0) 1e-12)
    (check-close (fixed-point-coordinates saddle) (up 0 0) 1e-12)
    (check-equal? (map fixed-point-kind (list center saddle)) '(elliptic hyperbolic))
    ;; the trace is 2 - K, and 2 + K
    (check-close (fixed-point-rotation-angle center) (acos (- 1 (/ K 2))) 1e-12)
    (check-close (+ (car (fixed-point-multipliers saddle)) (cadr (fixed-point-multipliers saddle)))
                 (+ 2 K) 1e-12)
    (check-false (fixed-point-rotation-angle saddle))
    (check-close (map fixed-point-determinant (list center saddle)) '(1 1) 1e-12)))

(test-case "multipliers at (0, 0), as published"
  (check-close (fixed-point-multipliers (found (standard-map 1.4) (up 0 0)))
               '(3.07477270848675 .325227291513248) 1e-13))

(test-case "multipliers of maps that are linear, the greatest first"
  (define (turning-over x y return fail) (return (* -2 x) (* -1/2 y)))
  (check-close (fixed-point-multipliers (found turning-over (up 0.1 0.1))) '(-2 -1/2) 1e-9)
  (define (falling x y return fail) (return (* 0.9 x) (* 0.1 y)))
  (check-close (fixed-point-multipliers (found falling (up 0.1 0.2))) '(0.9 0.1) 1e-9)
  (define (of-three s) (up (ref s 0) (up (* 2 (ref s 1 0)) (* 1/2 (ref s 1 1))) (* -3 (ref s 2))))
  (check-close (fixed-point-multipliers (found of-three (up 0 (up 0.1 0.1) 0.1))) '(-3 2 1/2) 1e-9))

(test-case "of two complex ones that above the real axis first, whichever way they point"
  (for ([turn '(0.5 2.0 2.9)])
    (define (turning x y return fail)
      (return (- (* (cos turn) x) (* (sin turn) y)) (+ (* (sin turn) x) (* (cos turn) y))))
    (define p (found turning (up 0.1 0.2)))
    (check-close (angle (car (fixed-point-multipliers p))) turn 1e-9)
    (check-close (fixed-point-rotation-angle p) turn 1e-9)))

(test-case "a saddle that turns over need not keep areas"
  (define (turning-over x y return fail) (return (* -2 x) (* -0.4 y)))
  (check-equal? (fixed-point-kind (found turning-over (up 0.1 0.1))) 'reflection-hyperbolic)
  (define (mirroring x y return fail) (return (* -2 x) (* 0.4 y)))
  (check-equal? (fixed-point-kind (found mirroring (up 0.1 0.1))) 'hyperbolic))

(test-case "beyond K = 4 the center is a saddle that turns over"
  (check-equal? (fixed-point-kind (found (standard-map 5.0) (up 3.1 0))) 'reflection-hyperbolic)
  (check-equal? (fixed-point-kind (found (standard-map 4) (up :pi 0))) 'parabolic))

(test-case "of motions: the pendulum whose pivot is shaken, stable at the bottom, or above"
  (define (kinds A ratio)
    (define T (driven-pendulum-map 1 1 9.8 A (* ratio (sqrt 9.8))))
    (for/list ([theta '(0.01 3.14)]) (fixed-point-kind (found T (up theta 0)))))
  (check-equal? (kinds .05 4.2) '(elliptic hyperbolic))
  (check-equal? (kinds .1 2) '(reflection-hyperbolic hyperbolic))
  (check-equal? (kinds .03 100) '(elliptic elliptic)))

(test-case "of states: all but the time comes back"
  (define omega (* 4.2 (sqrt 9.8)))
  (define strobe (stroboscopic-map (H-pend-sysder 1 1 9.8 .05 omega) (/ :2pi omega)))
  (define p (found strobe (up 0 3.0 0.1)))
  (check-close (fixed-point-coordinates p) (up 0 :pi 0) 1e-12)
  (check-close (apply + (fixed-point-multipliers p)) 4.63081658352 1e-10))

(test-case "in more dimensions: a start of two oscillators, one of them unstable"
  (define (T s) (up (* 2 (ref s 0)) (* 1/2 (ref s 1))))
  (check-close (fixed-point-coordinates (found T (up 1 1))) (up 0 0) 1e-14)
  (define (four s)
    (define-values (a b c d) (values (ref s 1) (ref s 2) (ref s 3) (ref s 4)))
    (up (+ 1 (ref s 0)) (* 2 a) (/ b 2) (- (* 0.6 c) (* 0.8 d)) (+ (* 0.8 c) (* 0.6 d))))
  (define p (found four (up 0 1 1 1 1)))
  (check-equal? (fixed-point-kind p) 'mixed)
  (check-close (map magnitude (fixed-point-multipliers p)) '(2 1 1 1/2) 1e-12))

(test-case "points of period 2 of the standard map: two chains, one of them elliptic"
  (define two (periodic-points (standard-map 0.6) 2 (list 0 :2pi 0 :2pi)))
  (check-equal? (map fixed-point-kind two) '(elliptic hyperbolic elliptic hyperbolic))
  (check-close (map fixed-point-coordinates two)
               (list (up 0 :pi) (up 1.4224439341263382 2.844887868252677) (up :pi :pi)
                     (up 4.860741373053247 3.43829743892691))
               1e-11)
  (for ([p two])
    (define T ((iterated-map (standard-map 0.6) 2) (abscissa (fixed-point-coordinates p))
                                                   (ordinate (fixed-point-coordinates p))
                                                   make-point void))
    (check-true ((torus-near? 1e-10) T (fixed-point-coordinates p)))))

(test-case "Poincaré and Birkhoff: an even number, half of them elliptic"
  (define five (periodic-points (Henon-map 1.32) 5 (list -0.6 0.6 -0.6 0.6) #:grid '(30 30)))
  (define kinds (map fixed-point-kind five))
  (check-equal? (length (filter (lambda (k) (eq? k 'elliptic)) kinds)) 5)
  (check-equal? (length (filter (lambda (k) (eq? k 'hyperbolic)) kinds)) 5))

;; Sitnikov's problem, by the eccentric anomaly E of the primaries, dt = (1 - e cos E) dE.  Beside
;; the point the derivatives less 1 have a determinant of -0.05, and all but one start leads plain
;; Newton steps astray.
(test-case "a start that is near finds the near point, through a narrow curved valley"
  (define (Sitnikov s)
    (define rate (- 1 (* 0.07 (cos (ref s 0)))))
    (define distance (sqrt (+ (square (/ rate 2)) (square (ref s 1)))))
    (up 1 (* rate (ref s 2)) (/ (* -1 rate (ref s 1)) (cube distance))))
  (define T (stroboscopic-map Sitnikov :2pi))
  (for ([off '((1e-3 0) (-1e-3 0) (0 1e-3) (0 -1e-3) (1e-3 1e-3) (-1e-3 -1e-3))])
    (define p (found T (up 0 (car off) (+ 1.589558038482 (cadr off)))))
    (check-close (fixed-point-coordinates p) (up 0 0 1.589558038482) 1e-10)
    (check-close (apply + (fixed-point-multipliers p)) 2.05003 5e-6)
    (check-equal? (fixed-point-kind p) 'hyperbolic)))

(test-case "the displacement turns round a rectangle as the points within it tell"
  (define (index map n x-min x-max y-min y-max)
    (index-round (make-map-on-tuples 'test map (up x-min y-min) n) x-min x-max y-min y-max))
  (check-equal? (index (Henon-map 1.32) 1 -0.2 0.2 -0.2 0.2) 1)         ; a center
  (check-equal? (index (Henon-map 1.32) 1 0.5 2 0.5 2) -1)          ; a saddle
  (check-equal? (index (Henon-map 1.32) 1 -0.2 2 -0.2 2) 0)         ; both
  (check-equal? (index (Henon-map 1.32) 5 -0.6 0.6 -0.6 0.6) 1)         ; 5 + 5 and a center
  (check-equal? (index (Henon-map 1.32) 1 0.2 0.4 -0.4 -0.2) 0))

(test-case "a grid that is too coarse is made finer while a point is missing"
  (check-equal? (length (periodic-points (Henon-map 1.32) 5 '(-0.6 0.6 -0.6 0.6) #:grid '(5 5)))
                10)
  (check-equal? (length (periodic-points (standard-map 0.9) 5 (list 0 :2pi 0 :2pi))) 40))

;; At a cube root Newton's steps lead to the other side, twice as far.
(test-case "a point that is not found is said to be missing, but where some are wanted only"
  (define (root x) (if (< x 0) (- (expt (- x) 1/3)) (expt x 1/3)))
  (define (steep x y return fail) (return (+ x (root (- x 0.1234))) (+ y (* 0.5 (- y 0.2)))))
  (define (mirror x y return fail) (return x (- 0.4 y)))
  (define (found R) (periodic-points steep 1 '(-1 1 -1 1) #:grid '(2 2) #:symmetry R))
  (check-regexp-match #rx"^; periodic-points: a point of index 1 is missing" (told (found #f)))
  (check-equal? (told (found mirror)) ""))

;; The displacement is A (z - z*), and the inverse of A has the rows (2 -2), (-2 4).
(test-case "rounding of an image leaves an error, greater where A is nearly singular"
  (define center 1000)
  (define (displaced x y return fail)
    (define-values (u v) (values (- x center) (- y center)))
    (return (+ x u (* 1/2 v)) (+ y (* 1/2 u) (* 1/2 v))))
  (define p (found displaced (up 900 1100)))
  (check-close (fixed-point-coordinates p) (up center center) 1e-9)
  (check-true (>= (fixed-point-error p) (* 5.999 center (expt 2. -53)))))

;; Fixed where y is 0 or 1 and x is 4, which is on the edge.
(test-case "points on the edges count, in their order; none is said to be missing"
  (define (steps x y return fail) (return (+ x (* 0.3 (- 4 x))) (+ y (* 0.2 y (- 1 y)))))
  (define region '(3 4 -0.5 1.5))
  (check-close (map fixed-point-coordinates (periodic-points steps 1 region))
               (list (up 4 0) (up 4 1)) 1e-9)
  (check-equal? (told (periodic-points (standard-map 0.6) 1 '(2 4 -1 1))) ""))

(test-case "a map that does not keep areas says so"
  (define (dissipative x y return fail) (return (+ 1 y (* -1.4 x x)) (* 0.3 x)))
  (define p (found dissipative (up 0.6 0.2)))
  (check-close (fixed-point-determinant p) -0.3 1e-12)
  (check-regexp-match #rx"areas are not kept: the determinant is -0[.]" (format "~a" p))
  (define (sink x y return fail) (return (* 0.5 x) (* 0.3 y)))
  (check-equal? (fixed-point-kind (found sink (up 1 1))) 'attracting))

(test-case "without a period it is a point that is left where it is, not one that goes to and fro"
  (define (to-and-fro x y return fail) (return (- (cube x)) (* 1/2 y)))
  (define p (find-fixed-point to-and-fro (up 1.01 0.1)))
  (check-close (fixed-point-coordinates p) (up 0 0) 1e-12)
  (define q (find-fixed-point to-and-fro (up 1.01 0.1) #:period 2))
  (check-equal? (fixed-point-period q) 2)
  (check-close (fixed-point-coordinates q) (up 1 0) 1e-12))

(test-case "what it prints"
  (check-equal? (format "~a" (found (standard-map 0.5) (up 0 0)))
                (string-append "hyperbolic point of period 1 at (up 0.0 0.0)\n"
                               "  multipliers: (2.0 0.5)")))

(define (sin-and-cos x y return fail) (return (sin x) (cos y)))
(define (shift x y return fail) (return (+ x 1/3) y))

(says
 [(found sin-and-cos (up 1 2 3))
  "find-fixed-point: expected a point (up x y) of real numbers; given (up 1 2 3), "
  "an up tuple of 3"]
 [(found 3 (up 1 2))
  "find-fixed-point: expected a map of the plane, or a function of a state\n"
  "  given: the number 3"]
 [(find-fixed-point standard-map (up 3 0.1))
  "find-fixed-point: the map gives another thing than it was given\n  map: standard-map\n"
  "  of: (up 3.0 0.1)\n  value: standard-map\n"
  "  parameters are supplied first: (standard-map ...)"]
 [(find-fixed-point (lambda (x y return fail) (list y x)) (up 1 2))
  "find-fixed-point: the map calls neither `return` nor `fail`\n  map: <function>\n"
  "  point: (up 1.0 2.0)\n  value: (2.0 1.0)\n"
  "  the image goes to the third argument: (return x y)"]
 [(find-fixed-point shift (up 1 2) #:period 0)
  "find-fixed-point: expected a period, a positive integer\n  given: the number 0"]
 [(periodic-points shift 2 '(1 0 0 1))
  "periodic-points: expected a region, (list x-min x-max y-min y-max)\n"
  "  given: (1 0 0 1), a list"])

(test-case "no fixed point"
  (check-exn exn:fail:mechanics? (lambda () (found shift (up 0.6 0.2))))
  (check-equal? (periodic-points shift 1 '(0 1 0 1)) '()))

(test-case "whether the period is a lesser one costs one run through the greatest of its divisors"
  (define runs 0)
  (define (third-of-a-turn x y return fail)
    (set! runs (+ runs 1))
    (return (- (* -1/2 x) (* (sqrt 3/4) y)) (+ (* (sqrt 3/4) x) (* -1/2 y))))
  (define m (make-map-on-tuples 'test third-of-a-turn (up 1.0 0.0) 12))
  (define (back? d) (for/and ([z d]) (< (abs z) 1e-9)))
  (set! runs 0)
  (check-equal? (returns-after m (flvector 1.0 0.0) back?) '(3 6))
  (check-equal? runs 6))

(test-case "a point found with a multiple of its period has its own"
  (for ([n '(2 4 6 12)])
    (define p (found (standard-map 0.6) (up 0.1 3.0) n))
    (check-equal? (fixed-point-period p) 2)
    (check-close (fixed-point-coordinates p) (up 0 :pi) 1e-12)))

;; The standard map is a product of two mirrors; this is one of them.
(test-case "points on a line of symmetry"
  (define (reversed theta I return fail) (return (- theta) (+ I (* 0.6 (sin theta)))))
  (define region (list 0 :2pi 0 :2pi))
  (define all (periodic-points (standard-map 0.6) 3 region))
  (define on-line (periodic-points (standard-map 0.6) 3 region #:symmetry reversed))
  (check-true (< 0 (length on-line) (length all)))
  (for ([p on-line])
    (define theta (abscissa (fixed-point-coordinates p)))
    (check-close (sin theta) 0 1e-8)))
