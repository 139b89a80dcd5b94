#lang racket/base
;; A zero of a function of one variable between two points where its signs differ,
;; by Brent's method (R. P. Brent, Algorithms for Minimization without Derivatives,
;; 1973, ch. 4).
;;
;; Kept are the best point b, a point c across the zero from it, and the best point
;; before, a.  The parabola x(y) through the three has at y = 0, the weights of
;; Lagrange's formula having the sum 1, the distance
;;
;;     x(0) − b = (a − b) rs/((1 − r)(1 − s)) + (c − b) uv/((1 − u)(1 − v)),
;;     r = f(b)/f(a),  s = f(c)/f(a),  u = f(a)/f(c),  v = f(b)/f(c),
;;
;; from b; where only two points are different the line through them takes its
;; place.  That is the next step if it stays within the three quarters of the
;; bracket next to b and is shorter than half the step before the last one, and half
;; the bracket is otherwise.  So convergence is of order 1.8 for smooth functions and
;; never much slower than bisection.

(require "point.rkt"
         "../checked-arguments.rkt"
         "../../error/complain.rkt" "../../error/failure.rkt")

;; (method f low high) -> root, bound of its error, evaluations
(provide bracketed-root bisected-root)

;; The root is right to `tolerance` times its own size or, near zero, times a
;; hundredth of the width of the interval; (observe x y) for each point tried.  After
;; `limit` evaluations (give-up root error count), which does not return; where the sign changes at
;; a jump, (jump who point point) with the points on both sides.
(define (bracketed-root f low high
                        #:tolerance [tolerance 1e-14]
                        #:limit [limit 200]
                        #:observe [observe void]
                        #:name [who 'find-root]
                        #:give-up [give-up (giving-up who)]
                        #:jump [jump raise-jump])
  (define-values (at a b nearest) (begin-search who f low high tolerance observe))
  (define-values (root across half count) (narrow a b a nearest at limit give-up))
  (check-not-pole who root a b)
  (cond [(jumps? f root across a b)
         (define-values (p q) (side-by-side f root across))
         (when (jumps? f p q a b) (jump who p q))
         (values (point-x p) (abs half) count)]
        [else (values (point-x root) (if (= (point-y root) 0.0) 0.0 (abs half)) count)]))

;; -> (x -> point), the points at both ends, and how near two trials near x may be
(define (begin-search who f low high tolerance observe)
  (check-interval who low high)
  (check-tolerance who tolerance)
  (define at (observed who f observe))
  (define a (at (real->double-flonum low)))
  (define b (at (real->double-flonum high)))
  (when (same-side? a b) (raise-no-change who a b))
  (values at a b (resolution tolerance (- (point-x b) (point-x a)))))

(define (same-side? p q)
  (or (< 0.0 (min (point-y p) (point-y q))) (> 0.0 (max (point-y p) (point-y q)))))

;; Never nearer than rounding.
(define ((resolution tolerance width) x)
  (max (* 0.5 (real->double-flonum tolerance) (max (abs x) (* 1e-2 (abs width))))
       (* 4.5e-16 (abs x))
       1e-300))

(define ((giving-up who) x error count)
  (raise-not-convergent who "no root found" x error "evaluations" count))

;; -> the best point, that across the zero, half of the bracket, evaluations
(define (narrow a b c nearest at limit give-up)
  (define all (- (point-x c) (point-x b)))
  (let loop ([a a] [b b] [c c] [last all] [before all] [count 2])
    (define near (nearest (point-x b)))
    (define half (* 0.5 (- (point-x c) (point-x b))))
    (cond
      [(< (abs (point-y c)) (abs (point-y b))) (loop b c b last before count)]
      [(or (= (point-y b) 0.0) (<= (abs half) near)) (values b c half count)]
      [(>= count limit)
       (give-up (point-x b) (abs (* 2.0 half)) count)]
      [else
       (define step (interpolated-step a b c before near))
       (define next (at (+ (point-x b) (at-least near (or step half)))))
       (define-values (d e) (if step (values step last) (values half half)))
       (if (same-side? next c)
           (loop b next b (- (point-x next) (point-x b)) (- (point-x next) (point-x b)) (+ count 1))
           (loop b next c d e (+ count 1)))])))

;; From b, or #f if it is not to be trusted.
(define (interpolated-step a b c before near)
  (define width (- (point-x c) (point-x b)))
  (define step
    (and (> (abs before) near)
         (< (abs (point-y b)) (abs (point-y a)))
         (if (distinct? a b c)
             (+ (* (- (point-x a) (point-x b)) (weight a b c))
                (* width (weight c a b)))
             (/ (* width (point-y b)) (- (point-y b) (point-y c))))))
  (and step
       (< 0.0 (/ step width) 0.75)
       (< (abs step) (* 0.5 (abs before)))
       step))

(define (distinct? a b c)
  (not (or (= (point-y a) (point-y b)) (= (point-y a) (point-y c)))))

;; Of p in the parabola through p, q and r, at y = 0.
(define (weight p q r)
  (define u (/ (point-y q) (point-y p)))
  (define v (/ (point-y r) (point-y p)))
  (/ (* u v) (* (- 1.0 u) (- 1.0 v))))

;; ---------------------------------------------------------------------------
;; Bisection: where the sign changes, at a jump too.

;; The tolerance is that of `bracketed-root`, down to numbers side by side.
(define (bisected-root f low high
                       #:tolerance [tolerance 1e-15]
                       #:observe [observe void]
                       #:name [who 'bisect])
  (define-values (at a b nearest) (begin-search who f low high tolerance observe))
  (let loop ([a a] [b b] [count 2])
    (define x (* 0.5 (+ (point-x a) (point-x b))))
    (define half (* 0.5 (abs (- (point-x b) (point-x a)))))
    (cond [(= (point-y a) 0.0) (values (point-x a) 0.0 count)]
          [(= (point-y b) 0.0) (values (point-x b) 0.0 count)]
          [(<= half (nearest x)) (values x half count)]
          [else
           (define middle (at x))
           (if (same-side? a middle)
               (loop middle b (+ count 1))
               (loop a middle (+ count 1)))])))

;; ---------------------------------------------------------------------------

(define (raise-no-change who a b)
  (complain-showing
   who "the function has the same sign at both ends of the interval"
   "from" (point-x a) "to" (point-x b)
   "value at the first" (point-y a) "value at the second" (point-y b)))

;; Where a sign changes through infinity, the values grow as the bracket shrinks.
(define (check-not-pole who root a b)
  (when (> (abs (point-y root)) (max (abs (point-y a)) (abs (point-y b))))
    (raise-singular who "the function changes its sign at a pole or a jump, not at a zero"
                    (point-x root)
                    "near" (point-x root) "value there" (point-y root))))

;; At a jump the values on both sides differ by more than those of each side among themselves, even
;; from a distance at which slopes count.
(define (jumps? f p q a b)
  (define gap (abs (- (point-y p) (point-y q))))
  (define far (* 1e-5 (- (point-x b) (point-x a))))
  (define outwards (if (same-order? p q a b) far (- far)))
  (define (spread p outwards)
    (define ys
      (cons (point-y p)
            (for/list ([part '(0.1 1.0)])
              (real->double-flonum (f (within (+ (point-x p) (* part outwards)) a b))))))
    (- (apply max ys) (apply min ys)))
  (and (not (= (point-y p) 0.0))
       (> gap (* 1e-6 (max (abs (point-y a)) (abs (point-y b)))))
       (> gap (* 10.0 (+ (spread p (- outwards)) (spread q outwards))))))

;; The points between p and q where the sign changes from one number to the next, first that
;; nearer to zero
(define (side-by-side f p q)
  (define x (* 0.5 (+ (point-x p) (point-x q))))
  (cond [(or (= x (point-x p)) (= x (point-x q)))
         (if (<= (abs (point-y p)) (abs (point-y q))) (values p q) (values q p))]
        [else
         (define middle (point x (real->double-flonum (f x))))
         (if (same-side? p middle) (side-by-side f middle q) (side-by-side f p middle))]))

;; Does the way from p to q lead from a towards b?
(define (same-order? p q a b)
  (eq? (< (point-x p) (point-x q)) (< (point-x a) (point-x b))))

(define (within x a b)
  (define-values (low high) (values (point-x a) (point-x b)))
  (max (min low high) (min (max low high) x)))

(define (raise-jump who p q)
  (define-values (left right) (if (< (point-x p) (point-x q)) (values p q) (values q p)))
  (raise-singular who "the function changes its sign at a jump, not at a zero; bisect finds jumps"
                  (point-x p)
                  "near" (point-x p)
                  "value to the left" (point-y left) "value to the right" (point-y right)))
