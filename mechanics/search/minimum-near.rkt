#lang racket/base
;; A minimum near a point, in any number of variables, and its kind.
;;
;; A search goes by the gradient, or, of a function that has none everywhere, by values alone.
;; Where it ends the point is looked at (critical-point.rkt): from a saddle, or a plateau with a way
;; down, the search goes on; a point like a minimum gets some steps of Newton's.

(require "minimum.rkt" "critical-point.rkt" "objective.rkt"
         "../error/failure.rkt"
         "../numeric/flvector.rkt"
         "../numeric/optimization/curvature.rkt"
         (prefix-in numeric: "../numeric/optimization/nelder-mead.rkt")
         "../numeric/optimization/quasi-newton.rkt")

(provide minimum-near judged-minimum)

;; The point where a search ended, its value, and the evaluations
(struct end (x y count) #:authentic)

(define most-rounds 20)

;; method : 'quasi-newton, 'nelder-mead or #f; watch : called with each point reached and the
;; value there -> minimum, and the same point as flvector
(define (minimum-near t method tolerance watch)
  (let loop ([x (objective-start t)] [method* method] [first-metric #f]
             [best #f] [count 0] [round 0])
    (define e (search t x method* tolerance watch first-metric))
    (define all (+ count (end-count e)))
    (define better? (or (not best) (< (end-y e) (end-y best))))
    (define e* (if better? e best))
    (define o (look t (end-x e*) (end-y e*) (eq? method 'nelder-mead)))
    (define (again x method* first-metric) (loop x method* first-metric e* all (+ round 1)))
    (cond
      [(or (not better?) (= round most-rounds)) (judged t e* o all)]
      [(outlook-lower o) => (lambda (lower) (again lower method #f))]
      [(and (eq? (outlook-kind o) 'unsettled) (not (eq? method 'nelder-mead)))
       (again (end-x e) method (metric (outlook-curvatures o)))]
      [(and (or (plateau? o) (eq? (outlook-kind o) 'saddle)) (not method*))
       (again (end-x e) 'nelder-mead #f)]
      [else (judged t e* o all)])))

;; -> minimum and flvector, for a point that another search found to its own precision
(define (judged-minimum t x y count)
  (define o (look t x y))
  (cond [(eq? (outlook-kind o) 'unsettled)
         (define-values (x* y* g) (polished t x y (outlook-gradient o) (outlook-curvatures o)))
         (judged t (end x* y* count) (look t x* y*) count)]
        [else (judged t (end x y count) o count)]))

(define (judged t e o count)
  (define kind (case (outlook-kind o) [(unsettled) 'degenerate] [else (outlook-kind o)]))
  (define-values (x y g)
    (if (and (eq? kind 'minimum) (outlook-gradient o))
        (polished t (end-x e) (end-y e) (outlook-gradient o) (outlook-curvatures o))
        (values (end-x e) (end-y e) (outlook-gradient o))))
  (define c (outlook-curvatures o))
  (values (minimum (objective-argument t x) y kind
                   (and g (not (eq? kind 'kink)) (norm g))
                   (and c (not (eq? kind 'kink)) (least-curvature c))
                   count)
          x))

;; Takes Newton's steps, with the second derivatives at the first point, while the gradient shrinks.
(define (polished t x y g c [left 3])
  (define next (along x 1.0 (downward-step c g)))
  (define-values (y* g*) (objective-value-and-gradient t next))
  (if (and (> left 0) (< (norm g*) (norm g)) (<= y* (+ y (* 1e-12 (abs y)))))
      (polished t next y* g* c (- left 1))
      (values x y g)))

;; ---------------------------------------------------------------------------

(define (search t x method tolerance watch metric)
  (case method
    [(quasi-newton) (by-gradient t x tolerance watch metric void)]
    [(nelder-mead) (by-values t x tolerance watch)]
    [else (if (objective-gradient t x)
              (by-either t x tolerance watch metric)
              (by-values t x tolerance watch))]))

;; A finer tolerance needs Newton's method.
(define finest 1e-10)

(define (by-gradient t x tolerance watch metric stuck)
  (define-values (found y slope count)
    (quasi-newton (lambda (x) (objective-value-and-gradient t x)) x
                  #:tolerance (max tolerance finest) #:name (objective-who t) #:observe watch
                  #:argument (lambda (x) (objective-argument t x)) #:stuck stuck #:metric metric))
  (end found y count))

(define (by-values t x tolerance watch)
  (define-values (found y count)
    (numeric:nelder-mead (lambda (x) (objective-value t x)) x
                         #:tolerance tolerance #:name (objective-who t) #:observe watch
                         #:argument (lambda (x) (objective-argument t x))))
  (end found y count))

;; Searches by the gradient, then by values from the point where it leads no further.
(define (by-either t x tolerance watch metric)
  (let/ec return
    (define stuck-at
      (with-handlers ([exn:fail:mechanics:singular? (lambda (e) x)])
        (let/ec stuck
          (return (by-gradient t x tolerance watch metric stuck)))))
    (by-values t stuck-at tolerance watch)))
