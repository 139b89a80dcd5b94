#lang racket/base
;; How fast an orbit goes around, in turns for each step of the map (SICM 4.4).
;;
;; The mean of the steps of the angle converges as 1/n, for its ends are cut off.  With weights
;; that vanish at both ends with all their derivatives,
;;
;;     w(t) = exp(−1/(t (1 − t))),   0 < t < 1,
;;
;; it converges faster than any power of 1/n if the orbit is quasiperiodic (Das, Saiki, Sander
;; and Yorke 2017).  On a chaotic orbit it does not: there the means over the two halves of the
;; orbit differ.  That is how one is told from the other.

(require racket/flonum
         "compiled-map.rkt" "map-of-the-plane.rkt" "map-on-tuples.rkt" "plane-points.rkt"
         "../error/complain.rkt"
         "../generic/compare.rkt" "../generic/define-plain.rkt" "../generic/describe.rkt"
         "../generic/up-down.rkt" "../generic/value-struct.rkt"
         "../numeric/constants.rkt" "../numeric/finite.rkt" "../numeric/whole-turns.rkt")

(provide rotation-number rotation? rotation-value rotation-error rotation-regular?)

;; value : turns for each step; error : how much the means over the halves differ
(value-struct rotation (value error regular?)
  #:text (lambda (r) (rotation->text r)))

;; Means that differ by more are not those of a regular orbit.
(define least-irregular 1e-5)

;; about : the point around which angles are taken, or #f if the first coordinate is one
(define-plain (rotation-number map start [n 10000] #:about [about #f])
  (define who 'rotation-number)
  (check-map who map)
  (unless (and (exact-integer? n) (>= n 100))
    (raise-argument-error who "the length of the orbit, an integer of 100 or more" n))
  (define p (point who start))
  (define angle
    (if about (angle-about who map (point who about)) (lambda (p) (flvector-ref p 0))))
  (define steps (angle-steps who map p angle n (not about)))
  (define (mean from to) (fl/ (weighted-mean steps from to) :2pi))
  (define half (quotient n 2))
  (define error (flabs (fl- (mean 0 half) (mean half n))))
  (rotation (mean 0 n) error (fl< error least-irregular)))

(define (point who p)
  (define-values (x y) (values (comparand (abscissa p)) (comparand (ordinate p))))
  (unless (and (finite? x) (finite? y))
    (complain who "expected a point (up x y) of real numbers; given ~a" (describe-with-value p)))
  (flvector (real->double-flonum x) (real->double-flonum y)))

;; Counterclockwise.  Coordinates of the map that are angles are taken by the shorter way.
(define (angle-about who map center)
  (define angles
    (map-on-tuples-angles
     (make-map-on-tuples who map (up (flvector-ref center 0) (flvector-ref center 1)) 1)))
  (define (off p k angle?)
    (define d (fl- (flvector-ref p k) (flvector-ref center k)))
    (if angle? (whole-turns-less d) d))
  (lambda (p) (atan (off p 1 (cadr angles)) (off p 0 (car angles)))))

;; The steps of the angle, each within half a turn of the mean direction of the first ones.
(define (angle-steps who map start angle n forwards?)
  (define p (flvector-copy start))
  (define step! (orbit-stepper map (flvector-ref p 0) (flvector-ref p 1)))
  (define steps (make-flvector n))
  (for/fold ([before (angle p)]) ([k (in-range n)])
    (define-values (x y) (values (flvector-ref p 0) (flvector-ref p 1)))
    (unless (step! p) (raise-no-image who map x y))
    (define after (angle p))
    (flvector-set! steps k (fl- after before))
    after)
  (define middle (mean-direction steps forwards?))
  (for ([k (in-range n)])
    (define off (fl- (flvector-ref steps k) middle))
    (flvector-set! steps k (fl+ middle (fl- off (fl* :2pi (flround (fl/ off :2pi)))))))
  steps)

;; From 0 to a turn, or to half a turn on both sides.
(define (mean-direction steps forwards?)
  (define-values (c s)
    (for/fold ([c 0.0] [s 0.0]) ([x (in-flvector steps)])
      (values (fl+ c (flcos x)) (fl+ s (flsin x)))))
  (define a (atan s c))
  (if (and forwards? (fl< a 0.0)) (fl+ a :2pi) a))

(define (weighted-mean steps from to)
  (define-values (sum weights)
    (for/fold ([sum 0.0] [weights 0.0]) ([k (in-range from to)])
      (define t (fl/ (fl+ (->fl (- k from)) 1.0) (fl+ (->fl (- to from)) 1.0)))
      (define w (flexp (fl/ -1.0 (fl* t (fl- 1.0 t)))))
      (values (fl+ sum (fl* w (flvector-ref steps k))) (fl+ weights w))))
  (fl/ sum weights))

(define (rotation->text r)
  (if (rotation-regular? r)
      (format "rotation number ~a, to about ~a" (rotation-value r) (rounded (rotation-error r)))
      (format
       (string-append "rotation number about ~a, if there is one:"
                      "\n  the orbit does not look regular; over its halves it differs by ~a")
       (/ (round (* 100 (rotation-value r))) 100) (rounded (rotation-error r)))))

;; To one digit, as 3e-14
(define (rounded x)
  (cond [(= x 0) 0]
        [else
         (define power (inexact->exact (floor (/ (log (abs x)) (log 10)))))
         (define digit (inexact->exact (round (/ x (expt 10.0 power)))))
         (real->double-flonum (* digit (expt 10 power)))]))
