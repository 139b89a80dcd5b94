#lang mechanics
;; Exercise 4.4 (SICM 4.2.3): quartets of multipliers
;; Checked: a symplectic map with multipliers R exp(±iφ), exp(±iφ)/R, and the orbits near it
;; How: the map is made of a turn that stretches; its matrix, volumes, and orbits in two planes

;; Coordinates (x, y) turn by φ and grow by R; so that the map is symplectic, their momenta turn
;; as well and shrink by R.
(define ((turned a) u v) (up (- (* (cos a) u) (* (sin a) v)) (+ (* (sin a) u) (* (cos a) v))))
(define ((near R phi) (up t q p))
  (define (turn v) ((turned phi) (ref v 0) (ref v 1)))
  (up (+ t 1) (* R (turn q)) (/ (turn p) R)))

(define-values (R phi) (values 1.1 0.7))
(define T (near R phi))

;; Near the fixed point: two pairs, of which each is the inverse of the other.
(define origin (find-fixed-point T (up 0 (up 0.1 0.2) (up 0.3 0.1))))
(define multipliers (fixed-point-multipliers origin))
(map magnitude multipliers)
(map (lambda (z) (abs (angle z))) multipliers)

;; It keeps the sum of the products of coordinates and momenta, Σ dq ∧ dp.
(define (form a b)
  (for/sum ([k 2])
    (- (* (ref a 1 k) (ref b 2 k)) (* (ref b 1 k) (ref a 2 k)))))
(define (displacement name)
  (define (entry k) (string->symbol (format "~a_~a" name k)))
  (up 0 (up (entry 0) (entry 1)) (up (entry 2) (entry 3))))
(define-values (a b) (values (displacement 'a) (displacement 'b)))
(define any (near 'R 'phi))
(define kept (verify-equal (form (any a) (any b)) (form a b)))
kept

;; An attempt at the orbits: outwards on a spiral in one plane, inwards in the other.  The slip:
;; that they stay near, as they turn.
(define orbit
  (for/fold ([all '()] [s (up 0 (up 0.01 0.) (up 1. 0.))] #:result (reverse all)) ([k 40])
    (values (cons s all) (T s))))
(define (radius s k) (sqrt (+ (square (ref s k 0)) (square (ref s k 1)))))
(define outwards (map (lambda (s) (radius s 1)) orbit))
(define inwards (map (lambda (s) (radius s 2)) orbit))
(list (car outwards) (car (reverse outwards)) (car inwards) (car (reverse inwards)))

(module+ test
  (require rackunit)
  (test-case "a quartet"
    (check-equal? (length multipliers) 4)
    (for ([z multipliers] [size (list R R (/ R) (/ R))]) (check-= (magnitude z) size 1e-12))
    (for ([z multipliers]) (check-= (abs (angle z)) phi 1e-12))
    (check-= (fixed-point-determinant origin) 1 1e-12)
    (check-false (eq? (fixed-point-kind origin) 'elliptic)))
  (test-case "the form is kept"
    (check-pred proved? kept))
  (test-case "spirals, outwards and inwards"
    (check-true (apply < outwards))
    (check-true (apply > inwards))))
