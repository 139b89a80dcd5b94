#lang racket/base
;; The equations of a periodic orbit that is its own image under a symmetry R, such as the reversal
;; of time: it starts at a state that R leaves where it is, and half a period later comes to another
;; one.  There are more equations than unknowns, and they agree.

(require racket/flonum
         (only-in racket/list make-list range)
         "branch-start.rkt" "curve-step.rkt" "orbit-equations.rkt"
         "../map/map-on-tuples.rkt"
         "../../calculus/derivative.rkt"
         "../../generic/up-down.rkt"
         "../../numeric/flvector.rkt"
         (only-in "../../numeric/linear-algebra/flonum-systems.rkt" product)
         "../../numeric/linear-algebra/row-matrix.rkt"
         (only-in "../../search/implicit-root.rkt" columns->rows)
         "../../value/shape.rkt")

(provide symmetric-equations)

(define (symmetric-equations o R x0)
  (define n (length (start-of o)))
  (define (evaluate x reference)
    (define z (part x 0 n))
    (define half ((orbits-advance o) o z 0.0 (* 0.5 (flvector-ref x n))))
    (define end (flow-end half))
    (define rows (off-rows o R end))
    (define by-z (product rows (submatrix (flow-slopes half) (range n) (range n))))
    (define by-T (rows-times rows (flvector-scaled 0.5 (rates-at o end 0.0))))
    (define others (make-list (- (flvector-length x) n 1) 0.0))
    (define (by row t) (list->vector (append (vector->list row) (cons t others))))
    (define h (flvector-ref x (- (flvector-length x) 1)))
    (define kept (if (orbits-energy o) (list (- (energy-at o z) h)) '()))
    (evaluated
     (apply longer (off o R z) (append (flvector->list (off o R end)) kept))
     (apply rows-and (for/vector ([row (in-vector (off-rows o R z))]) (by row 0.0))
            (append (for/list ([row (in-vector by-z)] [t (in-flvector by-T)])
                      (by row t))
                    (if (pair? kept) (list (by (row-of (energy-slope o z)) 0.0)) '())))
     void))
  (equations evaluate (make-flvector (flvector-length x0) 1.0) #f #f))

;; How far z is from its mirror image, and the derivatives of that
(define ((image o R) v)
  (define all (scalars (R (with-unknowns (orbits-state o) (orbits-timed? o) v))))
  (apply up (if (orbits-timed? o) (cdr all) all)))
(define (off o R z) (difference z (numbers-of ((image o R) (up-of-numbers z)))))
(define (off-rows o R z)
  (define n (flvector-length z))
  (define slopes (numbers-of (derivative-at (image o R) (up-of-numbers z))))
  (rows-combine - (unit-rows n 1.0 0.0) (columns->rows n slopes)))
