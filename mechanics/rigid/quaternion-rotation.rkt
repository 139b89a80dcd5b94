#lang racket/base
;; Quaternions as rotations (SICM 2.12, pp. 182–185).
;;
;; The rotation by θ about the unit vector n is q = (cos θ/2, n sin θ/2), which takes v to the
;; vector part of q v q*; its matrix is made of products of two parts of q.  Any multiple of q
;; serves as well when the result is divided by q q*: so q and −q are one rotation.

(require (only-in racket/list argmax index-of)
         "rotation.rkt" "three-vector.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/describe.rkt"
         "../generic/elementary.rkt" "../generic/printed-function.rkt"
         "../generic/wrong-argument.rkt"
         "../value/quaternion.rkt" "../value/structure.rkt"
         "../value/matrix/matrix.rkt")

(provide angle-axis->quaternion quaternion->angle-axis quaternion->RM
         quaternion->rotation-matrix rotation-matrix->quaternion
         quaternion->4x4 4x4->quaternion q:rotate)

;; ---------------------------------------------------------------------------
;; Angle and axis

(define (angle-axis->quaternion theta n)
  (define-values (x y z) (three 'angle-axis->quaternion "the axis" n))
  (check-unit 'angle-axis->quaternion "the axis" (up x y z))
  (define half (g:/ theta 2))
  (real&3vector->quaternion (g:cos half) (g:* (g:sin half) (up x y z))))

;; (continue angle axis)
(define (quaternion->angle-axis q [continue list])
  (check-quaternion 'quaternion->angle-axis q)
  (define v (quaternion->3vector q))
  (define size (euclidean-norm v))
  (when (g:zero? size)
    (complain 'quaternion->angle-axis
              "a quaternion without a vector part turns nothing and has no axis; given ~a"
              (describe-with-value q)))
  (continue (g:* 2 (g:atan size (quaternion->real-part q)))
            (g:/ v size)))

;; By angle and axis
(define (quaternion->RM q) (quaternion->angle-axis q angle-axis->rotation-matrix))

;; ---------------------------------------------------------------------------
;; Matrices

(define (quaternion->rotation-matrix q)
  (check-quaternion 'quaternion->rotation-matrix q)
  (define-values (r x y z) (apply values (structure->list (quaternion->vector q))))
  (define-values (rr xx yy zz) (values (g:square r) (g:square x) (g:square y) (g:square z)))
  (define m^2 (g:+ rr xx yy zz))
  (when (g:zero? m^2)
    (complain 'quaternion->rotation-matrix "the quaternion 0 is no rotation"))
  (define (twice a b) (g:* 2 (g:+ a b)))
  (define (less a b) (g:* 2 (g:- a b)))
  (define (row . entries) (for/list ([e (in-list entries)]) (g:/ e m^2)))
  (matrix-by-rows
   (row (g:- (g:+ rr xx) yy zz) (less (g:* x y) (g:* r z)) (twice (g:* x z) (g:* r y)))
   (row (twice (g:* x y) (g:* r z)) (g:- (g:+ rr yy) xx zz) (less (g:* y z) (g:* r x)))
   (row (less (g:* x z) (g:* r y)) (twice (g:* y z) (g:* r x)) (g:- (g:+ rr zz) xx yy))))

;; Four times the square of each part of q is a sum of diagonal entries, and four times a
;; product of two a sum or difference of entries opposite each other.  The greatest part is
;; found first, for to divide by it loses least; of symbols, the real part.
(define (rotation-matrix->quaternion M)
  (check-rotation 'rotation-matrix->quaternion M)
  (define (at i j) (matrix-ref M i j))
  (define-values (a b c) (values (at 0 0) (at 1 1) (at 2 2)))
  (define (four-times i)
    (case i
      [(0) (g:+ 1 a b c)]
      [(1) (g:- (g:+ 1 a) b c)]
      [(2) (g:- (g:+ 1 b) a c)]
      [else (g:- (g:+ 1 c) a b)]))
  (define k (place-of-greatest (map comparand (map four-times '(0 1 2 3)))))
  (define part (g:* 1/2 (g:sqrt (four-times k))))
  (apply quaternion
         (for/list ([j (in-range 4)])
           (if (= j k) part (g:/ (product-of at (min j k) (max j k)) (g:* 4 part))))))

;; 4 qⱼ qₖ of the entries of the matrix
(define (product-of at j k)
  (define (opposite combine i l) (combine (at i l) (at l i)))
  (case (list j k)
    [((0 1)) (opposite g:- 2 1)]
    [((0 2)) (opposite g:- 0 2)]
    [((0 3)) (opposite g:- 1 0)]
    [((1 2)) (opposite g:+ 0 1)]
    [((1 3)) (opposite g:+ 0 2)]
    [else (opposite g:+ 1 2)]))

;; The place of the greatest of the numbers; 0 where some have no order
(define (place-of-greatest xs)
  (if (andmap real? xs) (index-of xs (argmax values xs)) 0))

;; r 1 + x i + y j + z k
(define (quaternion->4x4 q)
  (check-quaternion 'quaternion->4x4 q)
  (define-values (r x y z) (apply values (structure->list (quaternion->vector q))))
  (define-values (-x -y -z) (values (g:negate x) (g:negate y) (g:negate z)))
  (matrix-by-rows (list r x y z)
                  (list -x r -z y)
                  (list -y z r -x)
                  (list -z -y x r)))

(define (4x4->quaternion M)
  (unless (matrix-of? M 4 4)
    (complain-of-argument '4x4->quaternion "a 4 by 4 matrix" M))
  (make-quaternion (m:nth-row M 0)))

;; ((q:rotate q) v), for a unit quaternion
(define-printed (q:rotate q)
  (check-quaternion 'q:rotate q)
  (check-unit 'q:rotate "the quaternion" (quaternion->vector q))
  (lambda (v)
    (define-values (x y z) (three 'q:rotate "a vector" v))
    (quaternion->3vector (g:* q (g:* (quaternion 0 x y z) (q:conjugate q))))))
