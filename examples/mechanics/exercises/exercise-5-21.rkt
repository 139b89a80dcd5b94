#lang mechanics
;; Exercise 5.21 (SICM 5.8): heliocentric, Jacobi's and hierarchical coordinates
;; Checked: momenta, kinetic energies, and where the centre of mass is
;; How: linking transformations by a generating function, against those of the library

(define (bodies n)
  (define (named mark) (for/list ([i n]) (string->symbol (format "~a~a" mark i))))
  (up 't (list->up (named "x")) (list->down (named "p"))))
(define ((kinetic masses) state)
  (for/sum ([m masses] [i (in-naturals)]) (/ (square (ref (momentum state) i)) (* 2 m))))

;; a. Heliocentric coordinates: F₂ = P X + Σ pᵢ' (xᵢ − x₀).
(define three '(m0 m1 m2))
(define (F2 t x p)
  (+ (* (ref p 0) (/ (+ (* 'm0 (ref x 0)) (* 'm1 (ref x 1)) (* 'm2 (ref x 2)))
                     (+ 'm0 'm1 'm2)))
     (* (ref p 1) (- (ref x 1) (ref x 0)))
     (* (ref p 2) (- (ref x 2) (ref x 0)))))
(define heliocentric
  (verify-equal ((F2->C F2) (bodies 3)) ((heliocentric-canonical three) (bodies 3))))
heliocentric
(define T ((compose (kinetic three) (F2->C F2)) (bodies 3)))
(define mixed-term (coefficient (coefficient (expand T) 'p1 1) 'p2 1))
mixed-term

;; b. Jacobi's: links of 0 and 1, 1 and 2, and so on; the kinetic energy stays a sum of squares.
(define (diagonal masses links)
  (define n (length masses))
  (verify-equal ((compose (kinetic masses) (linked-canonical masses links)) (bodies n))
                ((kinetic (linked-masses masses links)) (bodies n))))
(define Jacobi (diagonal three (Jacobi-links 3)))
Jacobi

;; c. Six bodies as two triples, each a pair with a third one.
(define six '(m0 m1 m2 m3 m4 m5))
(define triples '((0 1) (1 2) (3 4) (4 5) (2 5)))
(define right (diagonal six triples))
right
(define canonical (verify-canonical (linked-canonical six triples) (bodies 6)))
canonical
(center-of-mass-of-links 6 triples)
(linked-masses three (Jacobi-links 3))

;; The slip: body 0 linked again after its place holds a way.
(define slip '((0 1) (0 2)))
(center-of-mass-of-links 3 slip)

(module+ test
  (require rackunit)
  (test-case "momenta and kinetic energies"
    (for ([v (list heliocentric Jacobi right canonical)]) (check-pred proved? v))
    (check-pred proved? (verify-equal mixed-term (/ 1 'm0))))
  (test-case "the centre of mass is left where all links join bodies"
    (check-equal? (center-of-mass-of-links 6 triples) 5)
    (check-false (center-of-mass-of-links 3 slip))))
