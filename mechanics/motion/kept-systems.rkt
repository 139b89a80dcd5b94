#lang racket/base
;; Systems kept with the state derivatives that they were made of.
;;
;; To evolve a system again costs the integration alone: what was traced and compiled for a
;; state derivative is found with it as long as somebody holds it.  What it refers to may have
;; changed, though: a mass that was set anew, a table that was filled.  So its values at two
;; points are kept as well, and must be the same to the last digit; of a Lagrangian's state
;; derivative those of the Lagrangian's gradient, which take less.  One that decides by numbers
;; is not kept, since two points may not show what became of its decisions.

(require racket/list
         "../calculus/gradient.rkt"
         "../compile/compile-function.rkt"
         "../error/failure.rkt" "../error/refusal.rkt"
         "../generic/up-down.rkt"
         "../lagrangian/state-derivative.rkt"
         "../value/shape.rkt")

(provide keeping-system clear-kept-systems)

;; shape  : a state; points : flvectors; values : of the function watched there
;; system : what was made
(struct kept (shape points values system) #:authentic)

;; state derivative -> its latest systems, for states of different shapes
(define table (box (make-ephemeron-hasheq)))
(define (clear-kept-systems) (set-box! table (make-ephemeron-hasheq)))
(define most-shapes 4)

;; (make) : -> a system; (keep? system), (good? system) : may it be kept, and used for the state?
(define (keeping-system derivative state #:make make #:keep? keep? #:good? good?)
  (define known (hash-ref (unbox table) derivative '()))
  (define same (findf (lambda (k) (same-shape? (kept-shape k) state)) known))
  (cond [(and same (unchanged? derivative same) (good? (kept-system same))) (kept-system same)]
        [else
         (define s (make))
         (define k (and (keep? s) (keep derivative state s)))
         (define others (remq same known))
         (hash-set! (unbox table) derivative
                    (if k (cons k (first-few others)) others))
         s]))

(define (first-few known) (take known (min (length known) (- most-shapes 1))))

;; #f where the function has no value at one of the points.
(define (keep derivative state s)
  (define points (points-about (structure->flvector state (lambda (x) 0.0)) (shape-length state)))
  (define values (values-at derivative state points))
  (and values (kept state points values s)))

(define (unchanged? derivative k)
  (equal? (kept-values k) (values-at derivative (kept-shape k) (kept-points k))))

(define (values-at derivative state points)
  (define f
    (if (Lagrangian-derivative? derivative)
        (gradient (Lagrangian-derivative-Lagrangian derivative))
        derivative))
  (with-handlers ([no-value? (lambda (e) #f)] [raised? (lambda (e) #f)])
    (for/list ([v (in-list points)]) (scalars (f (flvector->structure state v))))))
