#lang racket/base
;; With the coordinates of several particles in a tuple of tuples, the mass
;; matrix was no matrix to determinant and no system to solve-linear-left.

(require mechanics/generic/arithmetic
         mechanics/calculus/derivative
         mechanics/lagrangian/state-derivative
         mechanics/value/matrix/linear-algebra
         mechanics/value/matrix/matrix
         mechanics/value/structure
         "../support/checks.rkt")

;; Two particles in the plane, on springs.
(define (L local)
  (define q (ref local 1))
  (define v (ref local 2))
  (g:- (g:+ (g:* 1/2 3 (g:square (ref v 0))) (g:* 1/2 5 (g:square (ref v 1))))
       (g:* 1/2 'k (g:square (g:- (ref q 1) (ref q 0))))))

(define state (up 't (up (up 'x1 'y1) (up 'x2 'y2)) (up (up 'u1 'v1) (up 'u2 'v2))))
(define mass (((g:square (partial 2)) L) state))

(test-case "the determinant of a nested mass matrix is a scalar"
  (check-equal? (determinant mass) 225)
  (check-equal? (trace mass) 16)
  (check-equal?
   (determinant (down (down 2 (down 0 0)) (down (down 0 (down 3 1)) (down 0 (down 1 4)))))
   22))

(test-case "accelerations are nested as the coordinates are"
  (check-equal? ((Lagrangian->acceleration L) (up 0 (up (up 0 0) (up 1 2)) (up (up 0 0) (up 0 0))))
                (up (up (g:/ (g:* 75 'k) 225) (g:/ (g:* 150 'k) 225))
                    (up (g:/ (g:* -45 'k) 225) (g:/ (g:* -90 'k) 225)))))

(test-case "solutions satisfy nested systems, on either side"
  (define x (up (up 1 2) (up 3 4)))
  (define A (g:+ mass (g:* (down (down 1 2) (down 0 1)) (down (down 1 1) (down 2 0)))))
  (check-equal? (solve-linear-left A (g:* A x)) x)
  (check-equal? (solve-linear-right (g:* x A) A) x)
  (define B (m->s (down (down 1 1) (down 1 1))
                  (matrix-by-rows '(1 2 0 1) '(0 3 1 0) '(1 0 5 2) '(2 0 1 7))
                  (up (up 1 1) (up 1 1))))
  (define y (down (down 1 2) (down 3 4)))
  (check-equal? (solve-linear-left B (g:* B x)) x)
  (check-equal? (g:* (solve-linear-right y B) B) y))

(test-case "coordinates of several shapes in one tuple"
  (define A (down (down 2 (down 0 1)) (down (down 0 (down 3 1)) (down 1 (down 1 4)))))
  (define x (up 1 (up 2 3)))
  (check-equal? (solve-linear-left A (g:* A x)) x))

(test-case "what is not square is refused"
  (check-exn #rx"^determinant: expected as many components in each component"
             (lambda () (determinant (down (down (down 1 2) 3) (down 1 2)))))
  (check-exn
   #rx"^solve-linear-left: there are more unknowns than equations: the system is underdetermined\n  unknowns: 8\n  equations: 2"
   (lambda () (solve-linear-left mass (down 1 2))))
  (check-exn
   #rx"^transpose: expected components of one length that hold scalars; .*[(]transpose s x[)]$"
   (lambda () (transpose mass)))
  (check-exn #rx"^transpose: expected components of one length"
             (lambda () (transpose (up (down 1 2) (down 1)))))
  (check-exn #rx"^transpose: expected a tuple of tuples\n  given: [(]up[)]"
             (lambda () (transpose (up)))))
