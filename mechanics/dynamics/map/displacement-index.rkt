#lang racket/base
;; How often the displacement of a map of the plane turns round along the edge of a rectangle: the
;; sum of the indices of the fixed points within, where the displacement is smooth there.

(require racket/flonum
         (only-in racket/math exact-round)
         "map-on-tuples.rkt"
         "../../error/refusal.rkt"
         "../../numeric/constants.rkt" "../../numeric/flvector.rkt" "../../numeric/whole-turns.rkt")

(provide index-round displacement-at smooth?)

;; The displacement at a point, or #f where it has none
(define (displacement-at m x y)
  (define d
    (if-raised refusal? #f
      (displacement m (flvector (real->double-flonum x) (real->double-flonum y)))))
  (and d (flvector-finite? d) d))

;; Whole turns of angles are left out of a displacement, which jumps where half a turn is passed.
(define (smooth? m d)
  (for/and ([x (in-flvector d)] [angle? (in-list (map-on-tuples-angles m))])
    (or (not angle?) (fl< (flabs x) 3.0))))

;; The edge is parted until the displacement turns by less from each point to the next.
(define greatest-turn 1.0)
(define most-halvings 12)
(define first-parts 16)

;; -> the number of turns, an integer; #f where it cannot be told
(define (index-round m x-min x-max y-min y-max)
  (define corners (list (cons x-min y-min) (cons x-max y-min) (cons x-max y-max)
                        (cons x-min y-max) (cons x-min y-min)))
  (define turned
    (for/fold ([sum 0.0]) ([a (in-list corners)] [b (in-list (cdr corners))])
      (define (on-edge part s) (+ (part a) (* s (- (part b) (part a)))))
      (define (at s) (displacement-at m (on-edge car s) (on-edge cdr s)))
      (define part (and sum (turn-along m at)))
      (and part (fl+ sum part))))
  (and turned (exact-round (fl/ turned :2pi))))

;; The angle by which (at s) turns from s = 0 to 1; #f where there is a jump or no value
(define (turn-along m at)
  (define (direction s)
    (define d (at s))
    (and d (smooth? m d) (fl> (norm d) 0.0) (atan (flvector-ref d 1) (flvector-ref d 0))))
  (define (between s a r b left)
    (define turn (and a b (whole-turns-less (fl- b a))))
    (cond [(not turn) #f]
          [(fl< (flabs turn) greatest-turn) turn]
          [(eqv? left 0) #f]
          [else
           (define middle (* 0.5 (+ s r)))
           (define c (direction middle))
           (define-values (one other)
             (values (between s a middle c (- left 1)) (between middle c r b (- left 1))))
           (and one other (fl+ one other))]))
  (for/fold ([sum 0.0]) ([k (in-range first-parts)])
    (define-values (s r) (values (/ k 1.0 first-parts) (/ (+ k 1.0) first-parts)))
    (define part (and sum (between s (direction s) r (direction r) most-halvings)))
    (and part (fl+ sum part))))
