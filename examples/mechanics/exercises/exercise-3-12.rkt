#lang mechanics
;; Exercise 3.12 (SICM 3.8): what becomes of an area of phase space
;; Checked: a square of starts of a pendulum has the same area later, however it is deformed
;; How: the polygon of its edge is followed; and the determinant of the linearized flow

(require mechanics/book)

(define H (Lagrangian->Hamiltonian (L-pendulum 1 1 1)))
(define advance (state-advancer (lambda () (Hamiltonian->state-derivative H))))
(define (moved t) (lambda (point) (advance (up 0 (ref point 0) (ref point 1)) t 1e-12)))
(define (in-plane s) (up (coordinate s) (momentum s)))

;; The edge of a square about (1.2, 0.8), 400 points.
(define side 0.6)
(define (edge k)
  (define-values (n i) (quotient/remainder k 100))
  (define u (- (/ i 100.) 0.5))
  (up (+ 1.2 (* side (list-ref (list u 0.5 (- u) -0.5) n)))
      (+ 0.8 (* side (list-ref (list -0.5 u 0.5 (- u)) n)))))
(define square-edge (for/list ([k 400]) (edge k)))

;; The area within a polygon.
(define (area points)
  (for/sum ([p points] [q (append (cdr points) (list (car points)))])
    (* 1/2 (- (* (ref p 0) (ref q 1)) (* (ref q 0) (ref p 1))))))
(define (edge-after t) (map (lambda (p) (in-plane ((moved t) p))) square-edge))
(define at-first (area square-edge))
(define later (map (lambda (t) (area (edge-after t))) '(2. 5. 8.)))
at-first
later

;; An attempt: each small area keeps its size, for the determinant is 1.
(define (determinant-later t)
  (define slope (lambda () (Hamiltonian->state-derivative H)))
  (define J ((linearized-flow slope) (up 0. 1.2 0.8) t 1e-13))
  (- (* (ref J 1 1) (ref J 2 2)) (* (ref J 1 2) (ref J 2 1))))
(determinant-later 8.)

;; A slip: that its shape is kept, too.  The edge gets longer.
(define (length-of points)
  (for/sum ([p points] [q (append (cdr points) (list (car points)))])
    (sqrt (+ (square (- (ref p 0) (ref q 0))) (square (- (ref p 1) (ref q 1)))))))
(define stretched (/ (length-of (edge-after 8.)) (length-of square-edge)))
stretched

(module+ test
  (require rackunit)
  (test-case "areas are kept"
    (check-= at-first (square side) 1e-12)
    (for ([a later]) (check-= a at-first 1e-4))
    (check-= (determinant-later 8.) 1 1e-10))
  (test-case "shapes are not"
    (check-true (> stretched 1.5))))
