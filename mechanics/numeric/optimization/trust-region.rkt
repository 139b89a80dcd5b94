#lang racket/base
;; A zero of functions with their derivatives that is near the start: a trust region, with Powell's
;; dogleg (J. Nocedal and S. Wright, Numerical Optimization, 2nd ed. 2006, ch. 4.1 and 11.2).
;;
;; Where J has nearly no inverse Newton's step −J⁻¹ f is long, and part of it leads far from the
;; start.  Here a step is no longer than a radius, within which |f + J p| has been seen to foretell
;; |f|: Newton's step if that is short enough, else a point on the way from the lowest point along
;; the steepest descent to the end of Newton's step.  The radius grows where |f| falls as foretold,
;; and shrinks where it does not.
;;
;; In a narrow valley that is curved |f| falls only in tiny steps.  There the step p is bent along
;; the valley: f at its end, less f + J p that was foretold, is the curvature, which −J⁻¹ of it
;; takes away (R. Fletcher's second-order correction; ch. 15.6).
;;
;; Steps are measured beside 1 + |x|.  There may be more functions than variables, and directions
;; in which nothing changes: with #:deficient? the shortest of Newton's steps is taken, so that
;; the nearest of a curve of zeros is found.

(require racket/flonum
         "newton.rkt"
         "../constants.rkt" "../flvector.rkt"
         "../linear-algebra/row-matrix.rkt" "../linear-algebra/singular-values.rkt"
         "../../error/failure.rkt")

(provide trust-region shortest-solution)

;; The first radius, and a Newton step below which a zero is one as far as rounding tells.
(define first-radius 0.1)
(define rounding-step 1e-7)
;; Where directions are left out, values above this are no zeros.
(define least-value 1e-7)

;; value, jacobian, argument : as of newton; -> the point, and the length of the last Newton step
(define (trust-region value jacobian start
                      #:tolerance [tolerance 1e-12] #:limit [limit 100]
                      #:deficient? [deficient? #f]
                      #:argument [argument flvector->list] #:name [who 'find-root])
  (define (not-found what x p f count)
    (raise-not-convergent who (string-append "no root found: " what) (argument x) (greatest p)
                          "values there" (flvector->list f) "steps" count))
  (define (step J f x) (if deficient? (shortest-solution J f (beside-one x)) (solution J f)))
  (define (newton-step J f x)
    (or (step J f x) (raise-no-step who (no-inverse f) (argument x) f)))
  (let loop ([x start] [f (value start)] [radius first-radius] [count 0])
    (unless (flvector-finite? f) (raise-no-step who "the functions are not finite" (argument x) f))
    (define J (and (fl> (greatest f) 0.0) (jacobian x)))
    (define full (and J (newton-step J f x)))
    (define no-zero? (and deficient? (fl> (norm f) least-value)))
    (cond
      [(not full) (values x 0.0)]
      [(and (fl< (size full x) tolerance) no-zero?)
       (not-found "the values are least here, and not 0" x full f count)]
      [(fl< (size full x) tolerance) (values (along x 1.0 full) (greatest full))]
      [(>= count limit) (not-found "too many steps" x full f count)]
      [else
       (define-values (next f* wider) (descend value step J f x full radius))
       (cond [next (loop next f* wider (+ count 1))]
             [(and (fl< (size full x) rounding-step) (not no-zero?)) (values x (greatest full))]
             [else (not-found "no step leads closer to a root" x full f count)])])))

;; The scales by which steps are measured
(define (beside-one x) (flvector-map (lambda (u) (fl+ 1.0 (flabs u))) x))

;; -> the next point, the values there and the next radius; or #f thrice
(define (descend value step J f x full given-radius)
  (let loop ([radius given-radius])
    (define p (dogleg J f x full radius))
    (define linear (along f 1.0 (rows-times J p)))
    (define foretold (fl- (norm f) (norm linear)))
    (define (share f*) (if (flvector-finite? f*) (fl/ (fl- (norm f) (norm f*)) foretold) -1.0))
    (define-values (next f*) (bent value step J x p linear share))
    (cond [(fl> (share f*) 1e-3)
           (define long? (fl> (size p x) (fl* 0.9 radius)))
           (values next f* (cond [(fl< (share f*) 0.25) (fl* 0.5 radius)]
                                 [(and (fl> (share f*) 0.75) long?) (fl* 2.0 radius)]
                                 [else radius]))]
          [(fl< radius (fl* 8.0 epsilon)) (values #f #f #f)]
          [else (loop (fl* 0.25 (flmin radius (size p x))))])))

;; The end of the step p, or of the bent one where that is better; and the values there
(define (bent value step J x p linear share)
  (define next (along x 1.0 p))
  (define f (value next))
  (define q (and (fl< -1e6 (share f) 0.5) (step J (difference f linear) x)))
  (cond [(and q (fl< (size q x) (size p x)))
         (define further (along next 1.0 q))
         (define g (value further))
         (if (fl> (share g) (share f)) (values further g) (values next f))]
        [else (values next f)]))

;; The point of Powell's path at this distance, or its end
(define (dogleg J f x full radius)
  (define d (beside-one x))
  (define (scaled v) (flvector-map fl/ v d))
  (define (unscaled v) (flvector-map fl* v d))
  (define newton (scaled full))
  (define slope (unscaled (rows-times (rows-transpose J) f)))
  (define fall (norm slope))
  (define along-slope (norm (rows-times J (unscaled slope))))
  (define lowest (fl/ (fl* fall (fl* fall fall)) (fl* along-slope along-slope)))
  (define (steepest length) (flvector-scaled (fl/ (fl- 0.0 length) fall) slope))
  (unscaled
   (cond [(fl<= (norm newton) radius) newton]
         [(not (fl< lowest radius)) (steepest radius)]
         [else (between (steepest lowest) newton radius)])))

;; The point of the line from a to b at the distance r from 0; a is nearer, b farther
(define (between a b r)
  (define d (difference b a))
  (define-values (A B C) (values (dot d d) (dot a d) (fl- (dot a a) (fl* r r))))
  (along a (fl/ (fl- (flsqrt (fl- (fl* B B) (fl* A C))) B) A) d))

;; ---------------------------------------------------------------------------

;; Singular values below this part of the greatest are zeros.
(define rank-tolerance 1e-9)

;; The p with least |p / scales| of those for which |f + J p| is least; #f if J is not finite
(define (shortest-solution J f scales)
  (and (all-entries? rational? J)
       (let-values ([(us sizes vs) (singular-values (map flvector-times (columns-of J)
                                                         (flvector->list scales)))])
         (define least (fl* rank-tolerance (car sizes)))
         (flvector-map fl* scales
                       (for/fold ([p (make-flvector (flvector-length scales))])
                                 ([u (in-list us)] [s (in-list sizes)] [v (in-list vs)]
                                  #:when (fl> s least))
                         (along p (fl/ (fl- 0.0 (dot u f)) s) v))))))

(define (flvector-times v a) (flvector-scaled a v))
