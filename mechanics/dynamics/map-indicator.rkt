#lang racket/base
;; Is the orbit of a map from here regular or chaotic?  Displacements of the start tell it, as they
;; do for motions (chaos-indicator.rkt), with steps k = 1 ... n in place of the time.
;;
;; FLI is the greatest length that a displacement reaches, as a decimal logarithm (Froeschlé, Lega
;; and Gonczi, Celestial Mechanics 67, 1997): of a regular orbit it grows as log n, of a chaotic one
;; as n; so a thousand steps tell, where an exponent needs many more.  With a(k) the logarithm of
;; the growth in step k, MEGNO is the mean of Y(k) = 2/k Σ j a(j) over all steps.  SALI of a map of
;; the plane falls as 1/n² where the orbit is regular, since all displacements turn towards the
;; invariant curve, and as an exponential where it is chaotic.
;;
;; The map and its derivative along the displacement are compiled as one function, which many
;; starts use on all cores at once.

(require racket/flonum
         racket/future
         "map/jacobian.rkt" "map/compiled-map.rkt" "map/map-of-the-plane.rkt" "map/plane-points.rkt"
         "../calculus/derivative.rkt"
         "../compile/compile-function.rkt"
         (only-in "../error/progress.rkt" call-counting)
         "../generic/up-down.rkt"
         (only-in "../numeric/flvector.rkt" flvector-finite? flvector-map)
         (only-in "../value/structure.rkt" ref))

(provide fast-Lyapunov-indicator map-indicator indicator-grid)

(define (fast-Lyapunov-indicator map start [n 1000])
  (map-indicator 'fast-Lyapunov-indicator map start n 'FLI))

;; The indicator of one orbit; +nan.0 where it ends.
(define (map-indicator who map start n kind)
  (check-map who map start)
  (check-steps who n)
  (define-values (x y) (start-coordinates who start))
  (define-values (make-step! compiled?) (displacement-stepper who map x y))
  ((indicator-of-kind kind) (make-step!) x y n))

;; The indicators of a grid of starts, xs by ys, flvectors; returns an flvector, row by row.
;; (grown all) now and then, where rows to come are -inf.0
(define (indicator-grid who map xs ys n [kind 'FLI] #:grown [grown void])
  (check-map who map)
  (check-steps who n)
  (define columns (flvector-length xs))
  (define all (make-flvector (* columns (flvector-length ys)) -inf.0))
  (define middle (lambda (v) (flvector-ref v (quotient (flvector-length v) 2))))
  (define-values (make-step! compiled?)
    (displacement-stepper who map (middle xs) (middle ys)))
  (define (row! step! j)
    (for ([x (in-flvector xs)] [i (in-naturals)])
      (flvector-set! all (+ i (* j columns)) (indicator step! x (flvector-ref ys j) n))))
  (define indicator (indicator-of-kind kind))
  (call-counting
   who "rows" (flvector-length ys)
   (lambda (count!)
     (define (tell! j)
       (count! j)
       (grown all))
     (on-cores (if compiled? (processor-count) 1) (flvector-length ys) make-step! row! tell!)))
  all)

;; Core c takes the rows c, c + cores, ..., so that all have the same work.  The user's procedure,
;; which is not compiled, is called on one core: in a future it would block.
(define (on-cores most rows make-step! row! count!)
  (define cores (min rows most))
  (define others
    (for/list ([core (in-range 1 cores)])
      (define step! (make-step!))
      (future (lambda () (for ([j (in-range core rows cores)]) (row! step! j))))))
  (define step! (make-step!))
  (for ([j (in-range 0 rows cores)])
    (count! j)
    (row! step! j))
  (for-each touch others))

;; ---------------------------------------------------------------------------
;; One orbit

;; -> a procedure: step!, x, y, n -> number
(define (indicator-of-kind kind)
  (case kind [(FLI) longest-of] [(MEGNO) mean-growth-of] [(SALI) alignment-of]))

;; A longer displacement is shortened; its length is computed after every interval of steps.
(define longest-displacement 1e100)
(define length-interval 16)

;; step! : moves a point with its displacement from p to q; returns #f where there is no image
(define (longest-of step! x y n)
  (let loop ([left n] [p (flvector x y 0.6 0.8)] [q (make-flvector 4)] [sum 0.0] [most 0.0])
    (define now (if (or (eqv? left 0) (eqv? 0 (bitwise-and left (- length-interval 1))))
                    (length-of p)
                    0.0))
    (define total (if (fl> now 0.0) (flmax most (fl+ sum (fllog now))) most))
    (cond [(eqv? left 0) (fl/ total (fllog 10.0))]
          [(fl> now longest-displacement)
           (shorten! p now)
           (loop left p q (fl+ sum (fllog now)) total)]
          [(step! p q) (loop (- left 1) q p sum total)]
          [else +nan.0])))

(define (mean-growth-of step! x y n)
  (let loop ([k 1] [p (flvector x y 0.6 0.8)] [q (make-flvector 4)] [moment 0.0] [sum 0.0])
    (cond [(> k n) (fl/ sum (->fl n))]
          [(step! p q)
           (define length (length-of q))
           (define growth (fl+ moment (fl* (->fl k) (fllog length))))
           (shorten! q length)
           (loop (+ k 1) q p growth (fl+ sum (fl* 2.0 (fl/ growth (->fl k)))))]
          [else +nan.0])))

(define (alignment-of step! x y n)
  (let loop ([left n] [p (flvector x y 0.6 0.8)] [q (make-flvector 4)]
                      [r (flvector x y -0.8 0.6)] [s (make-flvector 4)])
    (cond [(eqv? left 0) (flmin (direction-gap p r fl-) (direction-gap p r fl+))]
          [(and (step! p q) (step! r s))
           (shorten! q (length-of q))
           (shorten! s (length-of s))
           (loop (- left 1) q p s r)]
          [else +nan.0])))

(define (direction-gap p r combine) (length-of (flvector-map combine p r)))

(define (length-of p)
  (define-values (u v) (values (flvector-ref p 2) (flvector-ref p 3)))
  (flsqrt (fl+ (fl* u u) (fl* v v))))

(define (shorten! p length)
  (flvector-set! p 2 (fl/ (flvector-ref p 2) length))
  (flvector-set! p 3 (fl/ (flvector-ref p 3) length)))

;; -> a procedure that makes a step! for one thread, and whether that is compiled
(define (displacement-stepper who map x y)
  (define (moved p)
    (define-values (to change)
      (value-and-derivative-along (image-at who map)
                                  (up (ref p 0) (ref p 1)) (up (ref p 2) (ref p 3))))
    (up (ref to 0) (ref to 1) (ref change 0) (ref change 1)))
  (define code (compile-traced moved (up x y 0.6 0.8) #:name who))
  (values (if code
              (lambda () (compiled-displacement (compiled-function-runner code)))
              (lambda () (called-displacement who map x y)))
          (and code #t)))

(define ((compiled-displacement run!) p q)
  (run! p q)
  (flvector-finite? q))

;; The step! of a map that cannot be compiled.
(define (called-displacement who map x y)
  (define step! (orbit-stepper map (flvector x y) who))
  (lambda (p q)
    (define-values (x y) (values (flvector-ref p 0) (flvector-ref p 1)))
    (define-values (u v) (values (flvector-ref p 2) (flvector-ref p 3)))
    (cond [(image? who map x y)
           (flvector-set! q 0 x)
           (flvector-set! q 1 y)
           (for ([row (in-vector (map-jacobian who map x y))] [k (in-naturals 2)])
             (define change (+ (* (vector-ref row 0) u) (* (vector-ref row 1) v)))
             (flvector-set! q k (real->double-flonum change)))
           (step! q)]
          [else #f])))
