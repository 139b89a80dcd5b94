#lang racket/base
;; Oscillators of equal or near frequencies, told apart.
;;
;; Let complex vectors v span all that oscillates with frequencies near one.  Two forms are
;; Hermitian on it: twice the energy, T = v*A v, and the area, S = v*Jv/2i, which is aᵀJb for
;; v = a + i b.  An oscillator ω is a vector with T = 2ω S.  The sign of its energy is that of S;
;; the sign of the imaginary part of an eigenvalue tells nothing, as each comes with its conjugate.
;;
;; Rotations make S diagonal, ±1.  Then pairs of vectors are turned until T is diagonal, too: two of
;; one sign by rotations, which always succeed; two of opposite signs, with T = (α τ; τ* β), by
;; hyperbolic ones, which exist while |α + β| > 2|τ|.  Where both are equal, H is not semisimple;
;; beyond, the oscillators have made a pair that grows and one that decays (Krein).  So the
;; difference is a distance from that.

(require "quadratic-pair.rkt"
         "../../numeric/complex-vector.rkt"
         "../../numeric/linear-algebra/Jacobi-rotation.rkt"
         "../../numeric/vector-map.rkt")

(provide Hermitian-modes area-of energy-of)

;; v*Jw
(define (area-of v w)
  (define n (quotient (vector-length v) 2))
  (for/sum ([j (in-range n)])
    (- (* (conjugate (vector-ref v j)) (vector-ref w (+ n j)))
       (* (conjugate (vector-ref v (+ n j))) (vector-ref w j)))))

;; v*A w
(define (energy-of A v w)
  (define (image row) (for/sum ([a (in-vector row)] [y (in-vector w)]) (* a y)))
  (inner v (vector-map image A)))

;; vectors : a basis, orthonormal;  size : of the entries of A
;; -> a list of blocks, or #f if some of the vectors grow
(define (Hermitian-modes A vectors size tolerance stop)
  (define V (list->vector vectors))
  (define m (vector-length V))
  (define (S v w) (/ (area-of v w) 0+2i))
  (define (T v w) (energy-of A v w))
  (turn-all-pairs! m (lambda (p q) (rotate! V S p q 1e-15)))
  (for ([v (in-vector V)] [k (in-naturals)])
    (vector-set! V k (times (/ (sqrt (abs (real-part (S v v))))) v)))
  (define signs (for/vector #:length m ([v (in-vector V)]) (if (> (real-part (S v v)) 0) 1 -1)))
  (let/ec return
    (define (turn! p q)
      (if (= (vector-ref signs p) (vector-ref signs q))
          (rotate! V T p q (* 1e-15 size))
          (rotate-hyperbolically! V T p q size tolerance stop (lambda () (return #f)))))
    (turn-all-pairs! m turn!)
    (for/list ([v (in-vector V)] [s (in-vector signs)])
      (oscillator v s (/ (real-part (T v v)) 2)))))

;; The form's entry of vectors p and q becomes 0, unless it is small.  -> was it turned?
(define (rotate! V form p q small)
  (define-values (off diagonal-p diagonal-q) (real-entries! V form p q))
  (and (> off small)
       (let-values ([(tangent c s) (rotation (/ (- diagonal-q diagonal-p) (* 2 off)))])
         (mix! V p q c (- s) s c)
         #t)))

;; Vector q gets a phase with which the entry is not negative.  -> the entry, and the diagonal's
(define (real-entries! V form p q)
  (define-values (v w) (values (vector-ref V p) (vector-ref V q)))
  (define off (form v w))
  (define size (magnitude off))
  (when (> size 0) (vector-set! V q (times (/ (conjugate off) size) w)))
  (values size (real-part (form v v)) (real-part (form w w))))

(define (mix! V p q pp pq qp qq)
  (define-values (v w) (values (vector-ref V p) (vector-ref V q)))
  (vector-set! V p (vector-sum (times pp v) (times pq w)))
  (vector-set! V q (vector-sum (times qp v) (times qq w))))

(define (rotate-hyperbolically! V T p q size tolerance stop grows)
  (define-values (off a b) (real-entries! V T p q))
  (define half (/ (abs (+ a b)) 2))
  (define distance (/ (- half off) 2 size))
  (define (give-up status)
    (define-values (mean apart)
      (values (/ (abs (- a b)) 4) (/ (sqrt (max 0.0 (- (* half half) (* off off)))) 2)))
    (stop (trouble status (list (- mean apart) (+ mean apart)) (abs distance))))
  (and (> off (* tolerance size))
       (cond [(<= (abs distance) tolerance) (give-up 'not-semisimple)]
             [(<= (abs distance) (sqrt tolerance)) (give-up 'undecided)]
             [(< distance 0) (grows)]
             [else
              (define x (/ (* -2 off) (+ a b)))                 ; tanh 2u
              (define c (sqrt (/ (+ 1 (/ (sqrt (- 1 (* x x))))) 2)))
              (define s (/ (* x (- (* 2 c c) 1)) 2 c))
              (mix! V p q c s s c)
              #t])))

;; v = a + i b with aᵀJb = sign, or its conjugate where that is −1, with a phase by which
;; reversible motions start at rest, for P = 0
(define (oscillator v sign omega)
  (define w (let ([phased (times (phase v) v)]) (times (leading-sign phased) phased)))
  (elliptic-block omega (vector-map real-part w) (times sign (vector-map imag-part w))))

(define (phase v)
  (define n (quotient (vector-length v) 2))
  (define z (for/sum ([x (in-vector v)] [k (in-naturals)]) (* (if (< k n) 1 -1) x x)))
  (define first-one
    (if (> (magnitude z) (* 1e-6 (real-part (inner v v)))) (sqrt z) (leading v)))
  (/ (conjugate first-one) (magnitude first-one)))

;; The first component that is not small
(define (leading v)
  (define greatest (for/fold ([m 0]) ([x (in-vector v)]) (max m (magnitude x))))
  (for/first ([x (in-vector v)] #:when (> (magnitude x) (* 0.3 greatest))) x))

(define (leading-sign v) (if (< (real-part (leading v)) 0) -1 1))
