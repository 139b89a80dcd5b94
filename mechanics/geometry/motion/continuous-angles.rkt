#lang racket/base
;; Coordinates of a chart along a motion that is followed elsewhere, with angles that do not jump.
;;
;; A chart gives its angles up to whole turns.  Between two times near enough to each other an angle
;; changes by less than a radian; so the time between is divided until all angles do.  Where this
;; does not end, the motion passes through a place where the chart is singular, and the angle turns
;; there by half a turn at once.

(require (only-in racket/math sgn)
         "chart-choice.rkt" "../manifold-chart.rkt"
         "../../error/refusal.rkt"
         "../../numeric/constants.rkt"
         "../../value/shape.rkt")

(provide follow-angles (struct-out track) track-coordinates (struct-out node)
         next-to own-coordinates?)

;; q-at : time -> coordinates in the chart C;  regular? : coordinates -> is the chart regular there?
;; nodes : vector, in the order of the motion
(struct track (C q-at regular? nodes) #:authentic)

;; jump? : is there a singular place between the node before and this one?
(struct node (time coordinates jump?) #:authentic)

;; times : in their order;  q0 : coordinates at the first of them
(define (follow-angles C q-at regular? times q0)
  (define (regular-at t)
    (define q (q-at t))
    (and (regular? q) q))
  (define nodes
    (for/fold ([nodes (list (node (car times) q0 #f))]) ([t (in-list (cdr times))])
      (extended C regular-at nodes t most-halvings)))
  (track C q-at regular? (list->vector (reverse nodes))))

(define most-halvings 40)

;; nodes : the last first
(define (extended C q-at nodes t halvings)
  (define before (car nodes))
  (define q (q-at t))
  (define near (and q (next-to (node-coordinates before) q C)))
  (define small? (and near (gentle? (node-coordinates before) near C)))
  (cond [(not near) nodes]
        [(or small? (zero? halvings)) (cons (node t near (not small?)) nodes)]
        [else
         (define part (if (even? halvings) 0.45 0.6))
         (define middle (+ (node-time before) (* part (- t (node-time before)))))
         (extended C q-at (extended C q-at nodes middle (sub1 halvings)) t (sub1 halvings))]))

(define (gentle? q0 q C)
  (for/and ([a (in-list (scalars q0))] [b (in-list (scalars q))]
            [p (in-vector (coordinate-periods C))])
    (or (not p) (< (abs (- b a)) 1))))

;; At a time of the motion.  Where the chart is singular an angle that jumps is as it was before.
(define (track-coordinates tr t)
  (define q ((track-q-at tr) t))
  (define from (node-before (track-nodes tr) t))
  (define near (next-to (node-coordinates from) q (track-C tr)))
  (if ((track-regular? tr) q)
      near
      (list->structure q (for/list ([a (in-list (scalars (last-regular tr from t)))]
                                    [b (in-list (scalars near))])
                           (if (< (abs (- b a)) 1e-6) b a)))))

;; The coordinates after the node, as near to the time t as the chart is regular
(define (last-regular tr from t)
  (let closer ([q (node-coordinates from)] [way (- t (node-time from))])
    (define next ((track-q-at tr) (- t (/ way 8))))
    (if ((track-regular? tr) next)
        (closer (next-to q next (track-C tr)) (/ way 8))
        q)))

;; Bisection: the last node that is not after t.
(define (node-before nodes t)
  (define forth? (<= (node-time (vector-ref nodes 0))
                     (node-time (vector-ref nodes (sub1 (vector-length nodes))))))
  (let search ([low 0] [high (vector-length nodes)])
    (define middle (quotient (+ low high) 2))
    (define at (node-time (vector-ref nodes middle)))
    (cond [(= middle low) (vector-ref nodes low)]
          [(if forth? (<= at t) (>= at t)) (search middle high)]
          [else (search low middle)])))

;; ---------------------------------------------------------------------------

;; q with angles next to those of the coordinates `reference`
(define (next-to reference q C)
  (list->structure
   q
   (for/list ([x (in-list (scalars q))] [r (in-list (scalars reference))]
              [p (in-vector (coordinate-periods C))])
     (if p (+ r (shortest-turn r x)) x))))

;; Are the numbers q the coordinates that C gives the place there, but for whole turns?
(define (own-coordinates? C q)
  (define there (if-raised refusal? #f (place->coordinates C (coordinates->place C q))))
  (and there
       (numeric? there)
       (> ((chart-fitness C) q) 0)
       (for/and ([a (in-list (scalars q))] [b (in-list (scalars (next-to q there C)))])
         (<= (abs (- a b)) (* 1e-6 (+ 1 (abs a)))))))

;; x − r, between −π and π.  Half a turn, as through a pole, is taken towards 0, so that a motion
;; to and fro through it counts no turns.
(define (shortest-turn r x)
  (define d (- x r))
  (define short (- d (* 2 pi (round (/ d (* 2 pi))))))
  (if (and (> (abs short) (- pi 1e-5)) (> (* r short) 0))
      (- short (* 2 pi (sgn short)))
      short))
