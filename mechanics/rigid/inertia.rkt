#lang racket/base
;; Moments of inertia (SICM 2.3–2.4, pp. 128–135): of point masses, and of homogeneous bodies
;; by their formulas.
;;
;; The inertia tensor about the origin is Σ m (x·x 1 − x xᵀ), a matrix I with the kinetic
;; energy ½ ω·I ω.  Of a body of mass M with the tensor I about its centre of mass it is, about
;; the point d away from there (Steiner), I + M (d·d 1 − d dᵀ).

(require racket/list
         "three-vector.rkt"
         "../error/complain.rkt" "../error/hint.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/describe.rkt"
         "../generic/scalar.rkt" "../generic/wrong-argument.rkt"
         "../numeric/finite-number.rkt"
         "../value/exact-root.rkt" "../value/simplify.rkt" "../value/structure.rkt"
         "../value/matrix/decompositions.rkt" "../value/matrix/eigenvalues.rkt"
         "../value/matrix/linear-algebra.rkt" "../value/matrix/matrix.rkt"
         "../value/matrix/polynomial-roots.rkt")

(provide inertia-tensor parallel-axes point-inertia
         principal-moments principal-axes
         box-inertia ball-inertia shell-inertia rod-inertia ellipsoid-inertia
         cylinder-inertia cone-inertia torus-inertia)

;; ---------------------------------------------------------------------------
;; Point masses

;; masses and positions : lists, or tuples, of the same length
(define (inertia-tensor masses positions)
  (define ms (parts 'inertia-tensor "masses" masses))
  (define xs (parts 'inertia-tensor "positions" positions))
  (unless (= (length ms) (length xs))
    (complain 'inertia-tensor "each mass has a position; given ~a masses and ~a positions"
              (length ms) (length xs)))
  (when (null? ms) (complain 'inertia-tensor "expected at least one mass"))
  (for/fold ([sum (point-inertia 'inertia-tensor (car ms) (car xs))])
            ([m (in-list (cdr ms))] [x (in-list (cdr xs))])
    (g:+ sum (point-inertia 'inertia-tensor m x))))

(define (parts who what x)
  (cond [(list? x) x]
        [(tuple? x) (structure->list x)]
        [else (complain who "expected a list of ~a; given ~a" what (describe-with-value x))]))

(define (point-inertia who m position)
  (define-values (x y z) (three who "a position" position))
  (define-values (xx yy zz) (values (g:square x) (g:square y) (g:square z)))
  (define (product a b) (g:negate (g:* a b)))
  (g:* m
       (matrix-by-rows (list (g:+ yy zz) (product x y) (product x z))
                       (list (product y x) (g:+ zz xx) (product y z))
                       (list (product z x) (product z y) (g:+ xx yy)))))

;; I, about the centre of mass of a body of mass M -> about a point the tuple d away from there
(define (parallel-axes I M d)
  (check-tensor 'parallel-axes I)
  (g:+ I (point-inertia 'parallel-axes M d)))

;; ---------------------------------------------------------------------------
;; Principal axes

(define (check-tensor who I)
  (unless (matrix-of? I 3 3)
    (complain-of-argument who "an inertia tensor, a 3 by 3 matrix" I
                          (list-hint I "(matrix-by-rows ...)")))
  (define turned (g:- I (transpose I)))
  (unless (for*/and ([i (in-range 3)] [j (in-range i)])
            (negligible? (matrix-ref turned i j) (g:+ (matrix-ref I i i) (matrix-ref I j j))))
    (complain who "an inertia tensor is symmetric; given ~a" (describe-with-value I))))

(define (negligible? x size)
  (if (and (real? x) (real? size))
      (<= (abs x) (* 1e-12 (abs size)))
      (g:zero? (simplify x))))

;; The moments, in rising order where they are numbers: (up A B C)
(define (principal-moments I)
  (list->up (map car (axes 'principal-moments I))))

;; The rotation whose columns are the axes of these: Mᵀ I M is diagonal
(define (principal-axes I)
  (define vectors (map cdr (axes 'principal-axes I)))
  (define-values (a b) (values (first vectors) (second vectors)))
  (matrix-by-columns a b (map-leaves simplify (cross-product a b))))

;; -> list of three (moment . axis), the axes up tuples, orthogonal and of length 1
(define (axes who given)
  (check-tensor who given)
  (define I (map-leaves simplify given))
  (define found
    (append*
     (for/list ([entry (in-list (moments-and-axes I))])
       (for/list ([v (in-list (orthonormal (cdr entry)))]) (cons (car entry) v)))))
  (if (andmap real? (map car found)) (sort found < #:key car) found))

;; -> list of (moment axis ...): by formulas for symbols, exact where all moments are rational
(define (moments-and-axes I)
  (define entries (for*/list ([i (in-range 3)] [j (in-range 3)]) (matrix-ref I i j)))
  (define roots
    (if (andmap exact-rational? entries)
        (polynomial-roots (characteristic-polynomial I 'x) 'x)
        '(0.0)))
  (cond [(not (andmap real? entries)) (eigenvectors I)]
        [(andmap exact-rational? roots)
         (for/list ([moment (in-list (remove-duplicates roots))])
           (cons moment (null-space (g:- I moment))))]
        [else (eigenvectors (floating I))]))

;; As flonums, exactly symmetric
(define (floating I)
  (m:generate 3 3 (lambda (i j)
                    (exact->inexact (/ (+ (matrix-ref I i j) (matrix-ref I j i)) 2)))))

;; Gram and Schmidt
(define (orthonormal vectors)
  (for/fold ([done '()] #:result (reverse done)) ([given (in-list vectors)])
    (define v
      (for/fold ([v given]) ([u (in-list done)]) (g:- v (g:* (dot-product given u) u))))
    (define size (exact-root (simplify (g:square v))))
    (cons (map-leaves simplify (g:/ v size)) done)))

;; ---------------------------------------------------------------------------
;; Homogeneous bodies of mass M about their centres of mass, on their axes of symmetry

(define (diagonal a b c) (matrix-by-rows (list a 0 0) (list 0 b 0) (list 0 0 c)))

;; k M (y² + z²), k M (z² + x²), k M (x² + y²)
(define (from-squares who k M x y z)
  (check-scalars who M x y z)
  (define-values (xx yy zz) (values (g:square x) (g:square y) (g:square z)))
  (g:* k M (diagonal (g:+ yy zz) (g:+ zz xx) (g:+ xx yy))))

(define (check-scalars who . xs)
  (for ([x (in-list xs)])
    (unless (scalar? x)
      (complain who "the mass and lengths are numbers; given ~a" (describe-with-value x)))))

;; Of edges a, b, c along x, y, z
(define (box-inertia M a b c) (from-squares 'box-inertia 1/12 M a b c))
;; Of half axes a, b, c
(define (ellipsoid-inertia M a b c) (from-squares 'ellipsoid-inertia 1/5 M a b c))
(define (ball-inertia M R) (from-squares 'ball-inertia 1/5 M R R R))
;; A hollow sphere
(define (shell-inertia M R) (from-squares 'shell-inertia 1/3 M R R R))
;; A thin one along z
(define (rod-inertia M l) (from-squares 'rod-inertia 1/12 M 0 0 l))

;; About z, with two lengths R and r: k M (a R² + b r²) across it, l M (c R² + d r²) along it
(define (about-axis who M R r k a b l c d)
  (check-scalars who M R r)
  (define (moment k a b) (g:* k M (g:+ (g:* a (g:square R)) (g:* b (g:square r)))))
  (define across (moment k a b))
  (diagonal across across (moment l c d)))

;; Of radius R and height h
(define (cylinder-inertia M R h) (about-axis 'cylinder-inertia M R h 1/12 3 1 1/2 1 0))
;; Of base radius R and height h; its centre of mass is h/4 above the base.
(define (cone-inertia M R h) (about-axis 'cone-inertia M R h 3/80 4 1 3/10 1 0))
;; A disc of radius r whose centre goes round on a circle of radius R
(define (torus-inertia M R r) (about-axis 'torus-inertia M R r 1/8 4 5 1/4 4 3))
