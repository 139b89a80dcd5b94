#lang racket/base
;; Vectors carried parallel along curves, in numbers.
;;
;; In a chart a vector u that is carried along a curve with velocity v changes at the rates
;; −Σ Γᵃ_bk uᵇ vᵏ.  The curve may be a motion on a manifold; then u is followed in the charts in
;; which that was, and told in one.

(require (only-in racket/list append-map)
         "geodesic-motion.rkt" "Lagrangian-in-chart.rkt" "../manifold-chart.rkt"
         "../manifold-point.rkt"
         "motion-on-manifold.rkt" "motion-stretch.rkt"
         "../../calculus/derivative.rkt"
         "../../error/complain.rkt"
         "../../generic/arithmetic.rkt" "../../generic/define-plain.rkt"
         "../../generic/describe.rkt"
         "../../generic/up-down.rkt" "../../generic/wrong-argument.rkt"
         "../../lagrangian/local-tuple.rkt"
         "../../motion/evolve-trajectory.rkt" "../../motion/integration-plan.rkt"
         "../../motion/system/check.rkt" "../../motion/trajectory.rkt"
         "../../value/shape.rkt")

(provide evolve-parallel-transport)

;; path : time -> coordinates in C or a point, or a motion on the manifold
;; u : the vector at the time `from`, components in C -> a trajectory of states (up t u)
(define-plain (evolve-parallel-transport c C path u from to #:tolerance [tolerance #f])
  (define who 'evolve-parallel-transport)
  (check-coordinate-system who C)
  (check-argument who procedure? path
                  "a path: a function from the time to coordinates, or a motion on a manifold")
  (check-argument who (lambda (u) (not (down? u))) u "a vector, an up tuple of components")
  (check-real who "time" from)
  (check-real who "time" to)
  (define n (coordinate-system-dimension C))
  (unless (= n (length (scalars u)))
    (complain who "a vector has ~a component~a here\n  given: ~a" n (if (= n 1) "" "s")
              (describe-with-value u)))
  (define plan (make-plan who tolerance #f))
  (define (carried B local-at u from to)
    (define Gamma (coefficients-of who c B))
    (define (rates state)
      (define-values (q v) (local-at (time state)))
      (up 1 (turning Gamma B q (coordinate state) v)))
    (flonum-trajectory plan rates (up from u) to '() #f))
  (if (manifold-trajectory? path)
      (joined (carried-by-pieces carried C (pieces-between path from to) u) C)
      (carried C (along-path who path C from) u from to)))

;; time -> coordinates and velocities
(define (along-path who given C from)
  (define (path t)
    (define q (given t))
    (if (point? q) ((chart C) q) q))
  (define q (path from))
  (unless (same-shape? q (coordinate-tuple (coordinate-system-symbols C)))
    (complain-showing who "the path has other coordinates than the chart"
                      "chart" C "path" q))
  (lambda (t) (value-and-derivative-along path t 1)))

;; A piece of a motion, followed in one chart
(struct piece (stretch from to) #:authentic)

;; The pieces between the times, in the order from the one to the other
(define (pieces-between motion from to)
  (unless (and (between? (trajectory-start motion) from (trajectory-end motion))
               (between? (trajectory-start motion) to (trajectory-end motion)))
    (complain-showing 'evolve-parallel-transport "the motion does not last so long"
                      "from" from "to" to "motion" motion))
  (define-values (low high) (values (min from to) (max from to)))
  (define pieces
    (for*/list ([s (in-vector (manifold-trajectory-stretches motion))]
                [a (in-value (stretch-start s))]
                [b (in-value (stretch-end s))]
                [first (in-value (max low (min a b)))]
                [last (in-value (min high (max a b)))]
                #:when (or (< first last) (= low high first)))
      (if (<= from to) (piece s first last) (piece s last first))))
  (sort pieces (if (<= from to) < >) #:key piece-from))

;; -> a list of (piece . trajectory in its chart)
(define (carried-by-pieces carried C pieces u)
  (let loop ([pieces pieces] [B C] [u u])
    (cond [(null? pieces) '()]
          [else
           (define p (car pieces))
           (define s (piece-stretch p))
           (define B* (stretch-chart s))
           (define start (if (same-chart? B B*)
                             u
                             (vector-in B* B u (coordinates-of s B (piece-from p)))))
           (define (local-at t)
             (define local (local-state-at s t))
             (values (coordinate local) (velocity local)))
           (define tr (carried B* local-at start (piece-from p) (piece-to p)))
           (cons (cons p tr)
                 (loop (cdr pieces) B* (coordinate (trajectory-final-state tr))))])))

;; Of the point at a time, in the chart B
(define (coordinates-of s B t)
  ((transition (stretch-chart s) B) (local-state-at s t)))

;; u : components in A at the coordinates q there -> in B
(define (vector-in B A u q)
  (if (same-chart? A B)
      u
      (g:* ((D (lambda (q) ((transition A B) (up 0 q)))) q) u)))

;; The trajectory of them all, with components in C
(define (joined carried C)
  (define steps
    (append-map
     (lambda (one)
       (define s (piece-stretch (car one)))
       (define tr (cdr one))
       (define B (stretch-chart s))
       (define (state t)
         (up t (vector-in C B (coordinate (tr t)) (coordinates-of s B t))))
       (for/list ([st (in-vector (trajectory-steps tr))])
         (step (step-from st) (step-to st) state (step-to st))))
     carried))
  (trajectory (list->vector steps) '()
              (reading real->double-flonum values (lambda (s t) ((step-inside s) t)))
              (trajectory-method (cdr (car carried)))))
