#lang racket/base
;; Systems kept with the state derivatives that they were made of.
;;
;; To evolve a system again costs the integration alone: the code compiled for a state derivative
;; is kept as long as the program holds that derivative.  The data of the derivative may have
;; changed, though: a mass was set anew, a table was filled.  So its values at two points are kept
;; as well, and must be the same to the last digit.  For the state derivative of a Lagrangian they
;; are values of the Lagrangian's gradient, which takes less time; for a constrained system there
;; are those of the constraints as well.  The system of a derivative that decides by numbers is not
;; kept, since its values at two points may not show that its decisions have changed.

(require racket/list
         "../../calculus/gradient.rkt"
         "../../compile/code-check.rkt"
         "../../error/refusal.rkt"
         "../../generic/up-down.rkt"
         "../../lagrangian/state-derivative.rkt"
         "../../value/shape.rkt")

(provide keeping-system clear-kept-systems)

;; shape  : a state; mark : other values that a system was made for; points : flvectors
;; values : of the function watched there; system : the one that was made
(struct kept (shape mark points values system) #:authentic)

;; state derivative -> its latest systems, for states of different shapes
(define table (box (make-ephemeron-hasheq)))
(define (clear-kept-systems) (set-box! table (make-ephemeron-hasheq)))
(define most-shapes 4)

;; (make) : -> a system; (keep? system), (good? system) : may it be kept, and used for the state?
;; watched : function of the state, by default that of watched-of; mark : compared by equal?
(define (keeping-system derivative state #:make make #:keep? keep? #:good? good?
                        #:watched [given #f] #:mark [mark #f])
  (define watched (or given (watched-of derivative)))
  (define known (hash-ref (unbox table) derivative '()))
  (define same
    (findf (lambda (k) (and (same-shape? (kept-shape k) state) (equal? mark (kept-mark k)))) known))
  (cond [(and same (unchanged? watched same) (good? (kept-system same))) (kept-system same)]
        [else
         (define s (make))
         (define k (and (keep? s) (keep watched state mark s)))
         (define others (remq same known))
         (define few (take others (min (length others) (- most-shapes 1))))
         (hash-set! (unbox table) derivative (if k (cons k few) others))
         s]))

(define (watched-of derivative)
  (if (Lagrangian-derivative? derivative)
      (gradient (Lagrangian-derivative-Lagrangian derivative))
      derivative))

;; #f where the function has no value at one of the points.
(define (keep watched state mark s)
  (define points (points-about (structure->flvector state (lambda (x) 0.0)) (shape-length state)))
  (define found (values-at watched state points))
  (and found (kept state mark points found s)))

(define (unchanged? watched k)
  (equal? (kept-values k) (values-at watched (kept-shape k) (kept-points k))))

(define (values-at f state points)
  (if-raised raised? #f
    (for/list ([v (in-list points)]) (scalars (f (flvector->structure state v))))))
