#lang racket/base
;; Second derivatives at a point where a function may be least.
;;
;; With gradient g and matrix H of second derivatives, λₖ its eigenvalues and vₖ its
;; eigenvectors, Newton's step is −Σ vₖ (vₖ·g)/λₖ.  Taken with |λₖ| it leads down also where
;; an eigenvalue is negative, away from saddles.  All λₖ positive: the step that g asks for is
;; short, or the point is not yet the minimum.  The least one negative: the function falls
;; along its vector, however g may vanish.  Zero to rounding: values decide.

(require racket/flonum
         "../flvector.rkt"
         "../linear-algebra/symmetric-eigenvalues.rkt")

(provide curvatures least-curvature direction
         downward-step metric vanishing? all-vanishing?
         curvature-along difference-curvatures)

;; values : flvector, the least first; vectors : a list of flvectors; noise : an eigenvalue up to
;; this size counts as 0
(struct curvatures* (values vectors noise) #:authentic)

;; second : n² entries row by row; noise : of an entry beside the greatest
(define (curvatures second n [noise 1e-14])
  (define-values (values vectors) (symmetric-eigenvalues (symmetric second n) n))
  (curvatures* values vectors (* noise n (greatest values))))

(define (symmetric m n)
  (for*/flvector #:length (* n n) ([i (in-range n)] [j (in-range n)])
    (fl* 0.5 (fl+ (flvector-ref m (+ (* i n) j)) (flvector-ref m (+ (* j n) i))))))

(define (least-curvature c) (flvector-ref (curvatures*-values c) 0))
(define (direction c [k 0]) (list-ref (curvatures*-vectors c) k))

;; Does the k-th eigenvalue count as 0?
(define (vanishing? c k)
  (<= (abs (flvector-ref (curvatures*-values c) k)) (curvatures*-noise c)))

(define (all-vanishing? c)
  (for/and ([k (in-range (flvector-length (curvatures*-values c)))]) (vanishing? c k)))

;; Sizes of the eigenvalues, those that count as 0 replaced by the noise.
(define (sizes c)
  (define floor (max (curvatures*-noise c) 1e-300))
  (flvector-map (lambda (l) (flmax (flabs l) floor)) (curvatures*-values c)))

(define (downward-step c g)
  (for/fold ([p (make-flvector (flvector-length g))])
            ([v (in-list (curvatures*-vectors c))] [l (in-flvector (sizes c))])
    (along p (fl- 0.0 (fl/ (dot v g) l)) v)))

;; The matrix that makes this step of the gradient, as a vector of rows
(define (metric c)
  (define n (flvector-length (curvatures*-values c)))
  (define ls (sizes c))
  (for/vector #:length n ([i (in-range n)])
    (for/flvector #:length n ([j (in-range n)])
      (for/fold ([sum 0.0]) ([v (in-list (curvatures*-vectors c))] [l (in-flvector ls)])
        (fl+ sum (fl/ (fl* (flvector-ref v i) (flvector-ref v j)) l))))))

;; v·Hv for the entries of H
(define (curvature-along second v)
  (define n (flvector-length v))
  (for*/fold ([sum 0.0]) ([i (in-range n)] [j (in-range n)])
    (fl+ sum (fl* (fl* (flvector-ref v i) (flvector-ref v j))
                  (flvector-ref second (+ (* i n) j))))))

;; ---------------------------------------------------------------------------
;; From values alone

;; Second differences over steps h beside 1 + |x|; value : flvector -> flonum
(define (difference-curvatures value x h)
  (define n (flvector-length x))
  (define steps (flvector-map (lambda (u) (fl* h (fl+ 1.0 (flabs u)))) x))
  (define (at . moves)                  ; (i . sign) ...
    (define y (flvector-copy x))
    (for ([m (in-list moves)])
      (define i (car m))
      (flvector-set! y i (fl+ (flvector-ref y i) (fl* (cdr m) (flvector-ref steps i)))))
    (value y))
  (define middle (value x))
  (define (twice i) (fl+ (at (cons i 1.0)) (fl- (at (cons i -1.0)) (fl* 2.0 middle))))
  (define (mixed i j)
    (fl* 0.25 (fl- (fl+ (at (cons i 1.0) (cons j 1.0)) (at (cons i -1.0) (cons j -1.0)))
                   (fl+ (at (cons i 1.0) (cons j -1.0)) (at (cons i -1.0) (cons j 1.0))))))
  (for*/flvector #:length (* n n) ([i (in-range n)] [j (in-range n)])
    (fl/ (if (= i j) (twice i) (mixed (min i j) (max i j)))
         (fl* (flvector-ref steps i) (flvector-ref steps j)))))
