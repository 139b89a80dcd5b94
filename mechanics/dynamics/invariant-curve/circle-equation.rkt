#lang racket/base
;; The equation of an invariant circle, at n angles, and Newton's steps towards its solution
;; (invariant-circle.rkt has the mathematics).

(require racket/flonum
         racket/vector
         "../map/compiled-map.rkt" "../map/map-of-the-plane.rkt"
         "../../calculus/derivative.rkt"
         "../../compile/compile-function.rkt"
         "../../generic/up-down.rkt"
         "../../numeric/constants.rkt" "../../numeric/flvector.rkt"
         "../../numeric/periodic-function.rkt"
         "../../numeric/whole-turns.rkt")

(provide circle-equation solve-circle curve-of-orbit)

;; image! : flvector of x, y -> flvector x', y', and the four derivatives
(struct equation (image! omega))

(define (circle-equation who map y omega)
  (define image (image-at who map))
  (define (both p)
    (define slopes (derivative-at image p))
    (up (image p) slopes))
  (define run! (compiled-function-runner (compile-function both (up 0.1 y) #:name who)))
  (equation run! omega))

;; ---------------------------------------------------------------------------
;; A curve to begin with: an orbit near the circle, its points in the order of the rotation's.

;; -> a function from n to x and y of the curve at n angles, and the greatest difference of x
;; between neighbours.  The start is no point of the curve: a map of the torus may return to it
;; whole turns away.
(define (curve-of-orbit map y0 omega)
  (define count 16384)
  (define p (flvector 0.0 y0))
  (define step! (orbit-stepper map p))
  (define points
    (for/vector #:length count ([k (in-range 1 (+ count 1))])
      (unless (step! p) (raise-no-image 'invariant-circle map 0.0 y0))
      (define turned (fl* (->fl k) omega))
      (define theta (fl- turned (fl* :2pi (flfloor (fl/ turned :2pi)))))
      (flvector theta (whole-turns-less (fl- (flvector-ref p 0) theta)) (flvector-ref p 1))))
  (vector-sort! points (lambda (a b) (fl< (flvector-ref a 0) (flvector-ref b 0))))
  (values (lambda (n) (values (interpolated points n 1) (interpolated points n 2)))
          (greatest-gap points)))

;; On a curve neighbours in the order of the rotation's angles are near each other.
(define (greatest-gap points)
  (for/fold ([most 0.0]) ([p (in-vector points)] [q (in-vector points 1)])
    (flmax most (flabs (whole-turns-less (fl- (flvector-ref q 1) (flvector-ref p 1)))))))

;; Interpolates column k of the points linearly at n equally distant angles.
(define (interpolated points n k)
  (define count (vector-length points))
  (define column (make-flvector n))
  (for/fold ([i 0]) ([j (in-range n)])
    (define theta (node-angle j n))
    (define next
      (let seek ([i i])
        (if (and (< i count) (fl< (flvector-ref (vector-ref points i) 0) theta)) (seek (+ i 1)) i)))
    (define-values (before after)
      (values (vector-ref points (modulo (- next 1) count))
              (vector-ref points (modulo next count))))
    (define (angle-from p) (whole-turns-less (fl- (flvector-ref p 0) theta)))
    (define-values (a b) (values (angle-from before) (angle-from after)))
    (define part (if (fl= a b) 0.0 (fl/ (fl- 0.0 a) (fl- b a))))
    (flvector-set! column j (fl+ (fl* (fl- 1.0 part) (flvector-ref before k))
                                 (fl* part (flvector-ref after k))))
    next)
  column)

;; ---------------------------------------------------------------------------
;; Newton's method

;; -> x, y and the residual, once that no longer halves
(define (solve-circle q start-x start-y)
  (define n (flvector-length start-x))
  (define-values (x0 y0) (both-smoothed start-x start-y))
  (let improve ([x x0] [y y0] [best-x x0] [best-y y0] [best +inf.0] [count 0])
    (define m (mismatch q x y n))
    (define error (greatest-residual m))
    (cond [(and (fl< error +inf.0) (fl> error enough) (< count 20)
                (or (fl< error (fl* 0.5 best)) (= count 0)))
           (define-values (dx dy) (correction q m x y))
           (define-values (next-x next-y)
             (both-smoothed (flvector-map fl+ x dx) (flvector-map fl+ y dy)))
           (improve next-x next-y x y error (+ count 1))]
          [(fl< error best) (values x y (flmax error (residual-between q x y n)))]
          [else (values best-x best-y (flmax best (residual-between q best-x best-y n)))])))

;; Newton's method ends at a residual below `enough`.  Fourier terms below `noise` are the rounding
;; of the map's values and of sums.
(define-values (enough noise) (values 5e-15 5e-17))

;; The residual in the middle between the angles, for which the equation was not solved.
(define (residual-between q x y n)
  (define half (fl* 0.5 (node-angle 1 n)))
  (define-values (x-between y-between) (both-shifted x y half))
  (define moved (flvector-map (lambda (u) (fl+ u half)) x-between))
  (greatest-residual (mismatch q moved y-between n)))

;; x, y : distance of the image from the curve; a ... d : derivatives of the map
(struct mismatch-of (x y a b c d))

(define (mismatch q x y n)
  (define-values (x+ y+) (both-shifted x y (equation-omega q)))
  (define columns (for/list ([_ (in-range 6)]) (make-flvector n)))
  (define-values (in out) (values (make-flvector 2) (make-flvector 6)))
  (for ([j (in-range n)])
    (define theta (node-angle j n))
    (flvector-set! in 0 (fl+ theta (flvector-ref x j)))
    (flvector-set! in 1 (flvector-ref y j))
    ((equation-image! q) in out)
    (define turned (fl+ (fl+ theta (equation-omega q)) (flvector-ref x+ j)))
    (define row
      (list (whole-turns-less (fl- (flvector-ref out 0) turned))
            (whole-turns-less (fl- (flvector-ref out 1) (flvector-ref y+ j)))
            (flvector-ref out 2) (flvector-ref out 4) (flvector-ref out 3) (flvector-ref out 5)))
    (for ([column (in-list columns)] [z (in-list row)]) (flvector-set! column j z)))
  (apply mismatch-of columns))

(define (greatest-residual m)
  (for/fold ([most 0.0]) ([u (in-flvector (mismatch-of-x m))] [v (in-flvector (mismatch-of-y m))])
    (define size (flmax (flabs u) (flabs v)))
    (if (fl<= size most) most (if (fl< size +inf.0) size +inf.0))))

;; -> the corrections of x and y
(define (correction q m x y)
  (define omega (equation-omega q))
  (define n (flvector-length x))
  (define-syntax-rule (at-nodes (z f) ... body)
    (for/flvector #:length n ([z (in-flvector f)] ...) body))
  (define-values (slope a2) (both-slopes x y))
  (define a1 (at-nodes (u slope) (fl+ 1.0 u)))
  (define (over-square f sign)
    (at-nodes (u f) (v a1) (w a2) (fl/ (fl* sign u) (fl+ (fl* v v) (fl* w w)))))
  (define-values (b1 b2) (values (over-square a2 -1.0) (over-square a1 1.0)))
  (define-values (a1+ a2+) (both-shifted a1 a2 omega))
  (define-values (b1+ b2+) (both-shifted b1 b2 omega))
  (define shear
    (at-nodes (a (mismatch-of-a m)) (b (mismatch-of-b m))
              (c (mismatch-of-c m)) (d (mismatch-of-d m))
              (u b1) (v b2) (u+ b1+) (v+ b2+)
              (fl- (fl* (fl+ (fl* a u) (fl* b v)) v+) (fl* (fl+ (fl* c u) (fl* d v)) u+))))
  (define-values (ex ey) (values (mismatch-of-x m) (mismatch-of-y m)))
  (define eta (at-nodes (e ex) (f ey) (u b1+) (v b2+) (fl- (fl* f u) (fl* e v))))
  (define kappa (at-nodes (e ex) (f ey) (u a1+) (v a2+) (fl- (fl* e v) (fl* f u))))
  (define varying (periodic-unshifted kappa omega noise))
  (define (product f g) (at-nodes (u f) (v g) (fl* u v)))
  (define mean
    (fl/ (fl- (periodic-mean eta) (periodic-mean (product shear varying))) (periodic-mean shear)))
  (define zeta (at-nodes (u varying) (fl+ u mean)))
  (define xi
    (periodic-unshifted (at-nodes (u eta) (s shear) (z zeta) (fl- u (fl* s z))) omega noise))
  (values (at-nodes (u xi) (v a1) (z zeta) (w b1) (fl+ (fl* u v) (fl* z w)))
          (at-nodes (u xi) (v a2) (z zeta) (w b2) (fl+ (fl* u v) (fl* z w)))))
