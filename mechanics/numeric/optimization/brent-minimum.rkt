#lang racket/base
;; A minimum of a function of one variable on an interval, by Brent's method
;; (R. P. Brent, Algorithms for Minimization without Derivatives, 1973, ch. 5).
;;
;; A bracket [low, high] and the three best points are kept.  The next trial is
;; the vertex of the parabola through the three points if it falls inside the
;; bracket and moves less than half as far as the step before the last one did;
;; otherwise the larger part of the bracket is cut in the golden ratio.  No two
;; trials are nearer to each other than the tolerance.  When the bracket
;; reaches no farther than twice the tolerance from the best point, that is the
;; result.
;;
;; An exactly quadratic function takes five steps or so: two golden ones to have
;; three points, the parabola, which hits the minimum, and one on either side of
;; it to close the bracket.
;;
;; Function values near a minimum differ by the square of the distance, so a
;; relative tolerance below the square root of 2⁻⁵² asks for more than they can
;; tell; on equal values the best point stays where it is.

(require "point.rkt"
         "../constants.rkt" "../record-fields.rkt" "../checked-arguments.rkt"
         "../../error/failure.rkt")

(provide minimize)     ; (minimize f low high) -> (list argument value steps)

;; best, second, third : points by value; last, before : the last two steps;
;; count : steps taken.
(struct search (low high best second third last before count) #:authentic)

;; (observe x y) is called for each point tried.
;; The argument is right to `tolerance` times its own size or, near zero, times
;; the width of the interval.  A function without a minimum inside gives a point
;; as near to the lower end as the tolerance.
(define (minimize f low high
                  #:tolerance [tolerance 1e-8]
                  #:limit [limit 200]
                  #:observe [observe void]
                  #:name [who 'minimize])
  (check-interval who low high)
  (check-tolerance who tolerance)
  (define at (observed who f observe))
  (define a (real->double-flonum (min low high)))
  (define b (real->double-flonum (max low high)))
  (define start (at (+ a (* golden-part (- b a)))))
  (descend (search a b start start start 0.0 0.0 0)
           (resolution tolerance (- b a)) at limit who))

;; How close two trials near x may be.
(define ((resolution tolerance width) x)
  (* (real->double-flonum tolerance) (max (abs x) (* 1e-2 width))))

(define (descend s nearest at limit who)
  (define-fields search s low high best count)
  (define near (nearest (point-x best)))
  (cond [(closed? s near) (list (point-x best) (point-y best) count)]
        [(>= count limit)
         (raise-not-convergent who "no minimum found" (point-x best) (- high low)
                               "steps" count)]
        [else (descend (advance s near at) nearest at limit who)]))

(define (closed? s near)
  (define-fields search s low high best)
  (define x (point-x best))
  (<= (max (- x low) (- high x)) (* 2.0 near)))

;; ---------------------------------------------------------------------------
;; One step

(define (advance s near at)
  (define x (point-x (search-best s)))
  (define vertex (parabolic-step s near))
  (define reach (golden-reach s))
  (define step (or vertex (* golden-part reach)))
  (define trial (at (+ x (at-least near step))))
  (update s trial step (if vertex (search-last s) reach)))

;; From the best point to the farther end of the bracket.
(define (golden-reach s)
  (define-fields search s low high best)
  (define up (- high (point-x best)))
  (define down (- low (point-x best)))
  (if (>= up (- down)) up down))

;; From the best point to the vertex of the parabola, or #f if that is not to be
;; trusted.  Steps too near to an end of the bracket are turned inwards.
(define (parabolic-step s near)
  (define-fields search s low high best second third before)
  (define x (point-x best))
  (define step (and (> (abs before) near) (vertex-offset best second third)))
  (and step
       (< (abs step) (* 0.5 (abs before)))
       (< low (+ x step) high)
       (if (or (< (- (+ x step) low) (* 2.0 near))
               (< (- high (+ x step)) (* 2.0 near)))
           (if (> (golden-reach s) 0.0) near (- near))
           step)))

;; With u = x₂ − x, v = x₃ − x and the slopes r = (y₂ − y)/u, s = (y₃ − y)/v of
;; the chords, the parabola's second divided difference is (r − s)/(u − v) and
;; its slope at x is r − u (r − s)/(u − v); the vertex is at minus half the
;; latter over the former.
(define (vertex-offset best second third)
  (define u (- (point-x second) (point-x best)))
  (define v (- (point-x third) (point-x best)))
  (define r (/ (- (point-y second) (point-y best)) u))
  (define s (/ (- (point-y third) (point-y best)) v))
  (define curvature (/ (- r s) (- u v)))                ; no number where two of them are one
  (and (> curvature 0.0)
       (* -0.5 (- (/ r curvature) u))))

;; The trial replaces one of the three points and one end of the bracket.
(define (update s trial step before)
  (define-fields search s low high best second third count)
  (define-values (inner outer)        ; the bracket is cut at outer, keeps inner
    (if (< (point-y trial) (point-y best))
        (values trial best)
        (values best trial)))
  (define above? (> (point-x outer) (point-x inner)))
  (define-values (b2 b3)
    (cond [(eq? inner trial) (values best second)]
          [(or (eq? second best) (<= (point-y trial) (point-y second)))
           (values trial second)]
          [(or (eq? third best) (eq? third second)
               (<= (point-y trial) (point-y third)))
           (values second trial)]
          [else (values second third)]))
  (search (if above? low (point-x outer))
          (if above? (point-x outer) high)
          inner b2 b3 step before (+ 1 count)))
