#lang mechanics
;; Exercise 3.13 (SICM 3.9): Hénon's quadratic map
;; Checked: its inverse, areas, its fixed points, what happens between α = 1.32 and α = 1.2
;; How: with symbols; numbers at α = 1.32 against formulas; the ring of five as α falls

(require mechanics/book)

(define alpha 1.32)
(define H (Henon-map alpha))

;; The inverse undoes it, and the determinant of its derivatives is 1, whatever α.
(define back
  ((Henon-map 'alpha) 'x 'y
                      (lambda (x y) ((Henon-map-inverse 'alpha) x y up void))
                      void))
(define undone (verify-equal back (up 'x 'y)))
undone
(define (image p) ((Henon-map 'alpha) (ref p 0) (ref p 1) up void))
(define J ((D image) (up 'x 'y)))
(define keeps-areas
  (verify-equal (- (* (ref J 0 0) (ref J 1 1)) (* (ref J 0 1) (ref J 1 0))) 1))
keeps-areas

;; The origin is fixed, and near it the map is a rotation by α.
(define origin (find-fixed-point H (up 0.01 0.01)))
(fixed-point-rotation-angle origin)

;; An attempt at the other fixed point.  It turns (x, y − x²) back into (x, y): so the two have
;; the same length, y = x²/2, and the angle between them is α: y = x tan (α/2).  Hence
;; x = 2 tan (α/2).  The slip leaves out the 2.
(define x (* 2 (tan (/ alpha 2))))
(define attempt (up x (* 1/2 (square x))))
(define slip (up (/ x 2) (* 1/2 (square (/ x 2)))))
(define (distance-moved p)
  (define q (H (ref p 0) (ref p 1) up void))
  (sqrt (+ (square (- (ref q 0) (ref p 0))) (square (- (ref q 1) (ref p 1))))))
(map distance-moved (list attempt slip))
(define saddle (find-fixed-point H (up 1.5 1.2)))
(list (fixed-point-kind saddle) (fixed-point-multipliers saddle))

;; Between them, around the island, five fixed points of the fifth iterate in a ring.
(define five (periodic-points H 5 (list -0.8 0.8 -0.8 0.8)))
(map fixed-point-kind five)

;; Between α = 1.32 and 1.2: at the origin a fifth of a turn is passed, at α = 2π/5.
;; The ring comes in as √(α − 2π/5), and is gone.  At 1.2 orbits that turn a sixth are far enough
;; out to be seen: a ring of six.
(define fifth (/ :2pi 5))
(define (radius p)
  (define v (fixed-point-coordinates p))
  (sqrt (+ (square (ref v 0)) (square (ref v 1)))))
(define (ring alpha n)
  (filter (lambda (p) (eq? (fixed-point-kind p) 'elliptic))
          (periodic-points (Henon-map alpha) n (list -0.9 0.9 -0.9 0.9))))
(define (mean-radius alpha) (/ (apply + (map radius (ring alpha 5))) 5))
(define-values (near nearer) (values (mean-radius (+ fifth 0.02)) (mean-radius (+ fifth 0.005))))
(list near nearer (length (ring 1.25 5)) (length (ring 1.2 6)))

(module+ test
  (require rackunit)
  (test-case "inverse and areas"
    (check-pred proved? undone)
    (check-pred proved? keeps-areas))
  (test-case "fixed points"
    (check-= (fixed-point-rotation-angle origin) alpha 1e-9)
    (check-= (distance-moved attempt) 0 1e-14)
    (check-true (> (distance-moved slip) 0.1))
    (check-equal? (fixed-point-kind saddle) 'hyperbolic)
    (check-= (ref (fixed-point-coordinates saddle) 0) x 1e-12))
  (test-case "points of period 5, as many stable as not"
    (define kinds (map fixed-point-kind five))
    (check-equal? (length (filter (lambda (k) (eq? k 'elliptic)) kinds)) 5)
    (check-equal? (length (filter (lambda (k) (eq? k 'hyperbolic)) kinds)) 5))
  (test-case "the ring of five comes into the origin, and one of six is left"
    (check-= (/ near nearer) 2 0.1)
    (check-equal? (length (ring (+ fifth 0.005) 5)) 5)
    (check-equal? (ring (- fifth 0.005) 5) '())
    (check-equal? (ring 1.2 5) '())
    (check-equal? (length (ring 1.2 6)) 6)))
