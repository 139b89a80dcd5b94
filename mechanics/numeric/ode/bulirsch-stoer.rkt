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
         "shorter-step.rkt" "stepper.rkt" "vectors.rkt"
         "../flvector.rkt")

(provide bulirsch-stoer)

(define rows 8)
(define (substeps j) (* 2 (+ j 1)))

(define (start f! y0)
  (define n (flvector-length y0))
  (define-vectors n e old k w u first)
  (define y (flvector-copy y0))
  (define step 0.0)
  ;; row j of the scheme, from T(j, 0)
  (define (flvectors count) (build-vector count (lambda (k) (make-flvector n))))
  (define scheme (build-vector rows (lambda (j) (flvectors (+ j 1)))))
  (define (T j k) (vector-ref (vector-ref scheme j) k))

  ;; The smoothed midpoint rule: w and u are the last two points.
  (define (midpoint-rule! h count out)
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

  (define (extrapolate! j k)
    (define ratio (fl/ (->fl (substeps j)) (->fl (substeps (- j k)))))
    (define factor (fl/ 1.0 (fl- (fl* ratio ratio) 1.0)))
    (combine! n (T j k) (T j (- k 1)) factor [1.0 (T j (- k 1))] [-1.0 (T (- j 1) (- k 1))]))

  (define (try! h)
    (set! step h)
    (for ([j (in-range rows)])
      (midpoint-rule! h (substeps j) (T j 0))
      (for ([k (in-range 1 (+ j 1))]) (extrapolate! j k)))
    (define last (- rows 1))
    (weighted-sum! n e [1.0 (T last last)] [-1.0 (T last (- last 1))])
    (root-mean-square e y (T last last) n))

  (define (accept!)
    (flvector-copy! old y)
    (flvector-copy! y (T (- rows 1) (- rows 1)))
    (f! y first))

  (define between (by-shorter-steps start f!))
  (define (interpolant) (between old y step))

  (f! y first)
  (stepper y (lambda () first) try! accept! interpolant))

(define bulirsch-stoer (adaptive-method 'bulirsch-stoer (* 2 (- rows 1)) start))
