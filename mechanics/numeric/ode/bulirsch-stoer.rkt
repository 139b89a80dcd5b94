#lang racket/base
;; Extrapolation: the method of Gragg, Bulirsch and Stoer (Hairer, Nørsett and
;; Wanner, II.9).
;;
;; A step of length H is taken by the midpoint rule in n substeps, smoothed at the
;; end (Gragg 1965).  The error of the result has only even powers of H/n, so that
;; results for several n can be extrapolated to H/n = 0 by polynomials in (H/n)²
;; (Aitken and Neville): with n = 2, 4, 6 ... each row of the scheme
;;
;;     T(j, 0)
;;     T(j, k) = T(j, k−1) + (T(j, k−1) − T(j−1, k−1)) / ((n_j / n_{j−k})² − 1)
;;
;; wins two orders.  Eight rows make order 16; the last two of the diagonal differ by
;; the error of the poorer one, of order 14.

(require racket/flonum
         "shorter-step.rkt" "stepper.rkt" "vector-formulas.rkt"
         "../flvector.rkt"
         (only-in "../linear-algebra/row-matrix.rkt" [entry T]))

(provide bulirsch-stoer)

(define rows 8)
(define (substeps j) (* 2 (+ j 1)))

(define (start f! y0)
  (define n (flvector-length y0))
  (define-vectors n e w k u)
  (define y (flvector-copy y0))
  (define scheme (make-scheme n))
  (define best (T scheme (- rows 1) (- rows 1)))
  (define before (T scheme (- rows 1) (- rows 2)))
  (define (try! h slope)
    (for ([j (in-range rows)])
      (midpoint-rule! f! n y (slope) h (substeps j) u w k (T scheme j 0))
      (extrapolate-row! n scheme j))
    (weighted-sum! n e [1.0 best] [-1.0 before])
    (root-mean-square e y best n))
  (stepper-by-shorter-steps start f! y best try!))

;; The smoothed midpoint rule from y, where the slope is `first`, in so many steps; u and w
;; are the last two points, k is room for a slope.
(define (midpoint-rule! f! n y first h count u w k out)
  (define sub (fl/ h (->fl count)))
  (flvector-copy! u y)
  (combine! n w y sub [1.0 first])
  (for ([_ (in-range 1 count)])
    (f! w k)
    (combine! n u u (fl* 2.0 sub) [1.0 k])
    (exchange! u w))
  (f! w k)
  (combine! n out w 0.5 [1.0 u] [-1.0 w])
  (combine! n out out (fl* 0.5 sub) [1.0 k]))

;; Rows of flvectors, from T(j, 0) to T(j, j)
(define (make-scheme n)
  (for/vector #:length rows ([j (in-range rows)])
    (build-vector (+ j 1) (lambda (k) (make-flvector n)))))

;; Row j, of which the first entry is known.
(define (extrapolate-row! n scheme j)
  (for ([k (in-range 1 (+ j 1))])
    (define ratio (fl/ (->fl (substeps j)) (->fl (substeps (- j k)))))
    (define factor (fl/ 1.0 (fl- (fl* ratio ratio) 1.0)))
    (define-values (here above) (values (T scheme j (- k 1)) (T scheme (- j 1) (- k 1))))
    (combine! n (T scheme j k) here factor [1.0 here] [-1.0 above])))

(define bulirsch-stoer (adaptive-method 'bulirsch-stoer (* 2 (- rows 1)) start))
