#lang racket/base
;; The invariant curve of a twist map that has a given rotation number (SICM 4.6, pp. 322 to
;; 330).
;;
;; The points of an orbit on such a curve follow each other around the circle as those of a
;; rotation do.  So an orbit and the rotation are followed together, from one angle.  Only the
;; points nearest to that angle, before it and behind it, need be kept: when the rotation comes
;; nearer than ever, the orbit must as well, on the same side.  If it does not it is ahead, or
;; behind: by the sum of its steps' excess over the rotation's, for two angles on either
;; side of half a turn from the start do not tell.  That sum stays below a turn where the rotation
;; numbers are the same (Poincaré).  Where actions turn faster the greater they are, bisection
;; finds the curve.

(require racket/flonum
         "../map/compiled-map.rkt" "../map/map-of-the-plane.rkt"
         "../../error/complain.rkt"
         "../../generic/compare.rkt" "../../generic/define-plain.rkt" "../../generic/describe.rkt"
         "../../generic/number-argument.rkt" "../../generic/wrong-argument.rkt"
         "../../numeric/constants.rkt" "../../numeric/whole-turns.rkt"
         "../../search/find-root.rkt")

(provide find-invariant-curve which-way?
         ;; for invariant circles
         curve-between)

;; -> the action of the curve at the angle theta0
(define (find-invariant-curve map rotation-number theta0 Jmin Jmax eps)
  (curve-between 'find-invariant-curve map rotation-number theta0 Jmin Jmax eps))

;; hint : end of the message where there is no curve
(define (curve-between who map rotation-number theta0 Jmin Jmax eps [hint ""])
  (check-map who map rotation-number theta0 Jmin Jmax)
  (check-numbers who (list rotation-number theta0 Jmin Jmax)
                 '("rotation number" "angle" "least action" "greatest action"))
  (positive-number who eps "a positive tolerance")
  (define (ahead J) (which-way? rotation-number theta0 J map))
  (define-values (low high) (values (ahead Jmin) (ahead Jmax)))
  (when (= low high (if (= low 0) 1 low)) (raise-no-bracket who rotation-number Jmin Jmax low hint))
  (bisect ahead Jmin Jmax eps))

(define (raise-no-bracket who rotation-number Jmin Jmax way hint)
  (complain who
            (string-append
             "the orbits from both ends are ~a the rotation: no curve is between them"
             "\n  rotation number: ~a\n  actions: ~a and ~a~a")
            (if (> way 0) "ahead of" "behind") (value->text rotation-number)
            (value->text Jmin) (value->text Jmax) hint))

;; -> 1 if the orbit from (x0, y0) is ahead of the rotation, -1 if it is behind, 0 if neither
;; shows within most-steps.
(define-plain (which-way? rotation-number x0 y0 map [most-steps 20000000])
  (when (ormap map? (list rotation-number x0 y0))
    (complain 'which-way? "the map comes last: (which-way? rotation-number x0 y0 map)"))
  (check-map 'which-way? map)
  (check-numbers 'which-way? (list rotation-number x0 y0) '("rotation number" "angle" "action"))
  (check-argument 'which-way? exact-nonnegative-integer? most-steps
                  "how many steps at most, a natural number")
  (define start (real->double-flonum (comparand x0)))
  (define turn (fl* :2pi (real->double-flonum (comparand rotation-number))))
  (define low (fl- start pi))
  (define orbit (flvector start (real->double-flonum (comparand y0))))
  (define step! (orbit-stepper map orbit))
  ;; -> the angle at the next step
  (define (later)
    (define-values (x y) (values (flvector-ref orbit 0) (flvector-ref orbit 1)))
    (unless (step! orbit) (raise-no-image 'which-way? map x y))
    (define angle (wrapped (flvector-ref orbit 0) low))
    (flvector-set! orbit 0 angle)
    angle)
  (define period (denominator (inexact->exact (comparand rotation-number))))
  (if (<= period longest-period)
      (compare-after period start turn later)
      (compare-order start turn low later most-steps)))

;; A rotation by a fraction with at most this denominator is compared after one period: it never
;; comes nearer to its start than then.
(define longest-period 100)

;; Compares the orbit with the rotation after a period.
(define (compare-after period start turn later)
  (define-values (excess _x)
    (for/fold ([excess 0.0] [x start]) ([_ (in-range period)])
      (define next (later))
      (values (fl+ excess (whole-turns-less (fl- (fl- next x) turn))) next)))
  (cond [(fl> excess 0.0) 1] [(fl< excess 0.0) -1] [else 0]))

;; z : the rotation's angle, x : the orbit's; ahead : how far the orbit is ahead of the rotation,
;; a step being as many turns as bring it nearest to the rotation's; the nearest to the start so
;; far: z- and x- before it, z+ and x+ behind it
(define (compare-order start turn low later most-steps)
  (let loop ([n 0] [z start] [x start] [ahead 0.0]
             [z- (fl- start :2pi)] [x- (fl- start :2pi)]
             [z+ (fl+ start :2pi)] [x+ (fl+ start :2pi)])
    (define (on z- x- z+ x+)
      (define next (later))
      (loop (+ n 1) (wrapped (fl+ z turn) low) next
            (fl+ ahead (whole-turns-less (fl- (fl- next x) turn)))
            z- x- z+ x+))
    (define (decided) (if (fl> ahead 0.0) 1 -1))
    (cond [(> n most-steps) 0]
          [(fl> (flabs ahead) :2pi) (decided)]
          [(fl< start z z+) (if (fl< start x x+) (on z- x- z x) (decided))]
          [(fl< z- z start) (if (fl< x- x start) (on z x z+ x+) (decided))]
          [else (on z- x- z+ x+)])))

(define (wrapped x low)
  (if (and (fl<= low x) (fl< x (fl+ low :2pi)))
      x
      (fl- x (fl* :2pi (flfloor (fl/ (fl- x low) :2pi))))))
