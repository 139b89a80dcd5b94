#lang racket/base
;; A minimum of a function of several variables with its gradient, by the method of
;; Broyden, Fletcher, Goldfarb and Shanno (Nocedal and Wright, Numerical
;; Optimization, 2nd ed. 2006, 6.1).
;;
;; H approximates the inverse of the matrix of second derivatives.  The step
;; p = −H g, g being the gradient, would reach the minimum of a quadratic function;
;; it is halved until the function falls by a fair part of the promise of g.  The
;; change s of the point and y of the gradient then correct H:
;;
;;     H ← (1 − ρ s yᵀ) H (1 − ρ y sᵀ) + ρ s sᵀ,     ρ = 1/(y·s),
;;
;; where y·s is positive.  The search ends when p is shorter than the tolerance.  On
;; a quadratic function of n variables that takes about n steps.
;;
;; Near a minimum the function's values differ by the square of the distance, and
;; rounding hides that before it hides the gradient.  Where no part of a step lowers
;; the function, one is taken that flattens it along p and does not raise it by more
;; than rounding may (W. W. Hager and H. Zhang, SIAM J. Optim. 16, 2005, 170).  If there
;; is none the search is stuck: at a kink, or where the gradient is not that of the
;; function; unless the gain still to be had, p·g/2, is itself no more than rounding.

(require racket/flonum
         "../constants.rkt" "../finite-number.rkt" "../flvector.rkt"
         "../../error/failure.rkt")

(provide quasi-newton)

;; value-and-gradient : x -> value, gradient; flvectors and a flonum
;; observe            : called with each point reached and the value there
;; argument           : the user's form of a point
;; stuck              : called with the point where no step leads down; may escape
;; metric             : the first H, a vector of rows, or #f for the unit matrix
;; -> point, value, gradient, evaluations
(define (quasi-newton value-and-gradient start
                      #:tolerance [tolerance 1e-8]
                      #:limit [limit 1000]
                      #:observe [observe void]
                      #:argument [argument flvector->list]
                      #:stuck [stuck void] #:metric [metric #f]
                      #:name [who 'minimize])
  (define I (scaled-unit (flvector-length start) 1.0))
  (define-values (at evaluations) (counted value-and-gradient))
  (define-values (f0 g0) (at start))
  (let loop ([x start] [f f0] [g g0] [H (or metric I)] [scale (flabs f0)] [steps 0] [gain +inf.0])
    (observe x f)
    (define p (flvector-scaled -1.0 (product H g)))
    (define slope (dot g p))
    (define (found) (values x f g (evaluations)))
    (define (not-found what)
      (raise-no-minimum who what (argument x) (greatest p) f g (evaluations)))
    (cond
      [(not (and (finite? f) (finite? slope)))
       (not-found "the function is not finite, or its gradient")]
      [(<= (greatest p) (* tolerance (+ 1.0 (greatest x)))) (found)]
      [(>= steps limit) (not-found "too many steps")]
      [else
       (define-values (next f* g*) (line-search at x f g p (noise f scale)))
       (cond
         [next (loop next f* g* (corrected H (difference next x) (difference g* g) (eq? H I))
                     (max scale (flabs f*)) (+ steps 1) +inf.0)]
         [(not (unit? H)) (loop x f g I scale (+ steps 1) (* -0.5 slope))] ; it may be wrong
         [(<= (min gain (* -0.5 slope)) (* 1e-14 (+ scale (flabs f)))) (found)]
         [else (stuck x) (not-found "the gradient does not vanish, yet nothing near is lower")])])))

;; -> the function, and a procedure that returns the number of its calls
(define (counted value-and-gradient)
  (define count 0)
  (define (at x)
    (set! count (+ count 1))
    (value-and-gradient x))
  (values at (lambda () count)))

;; The rounding by which values near f may differ.
(define (noise f scale) (+ (* 1e-6 (flabs f)) (* 1e-14 scale)))

(define (raise-no-minimum who what argument error f g evaluations)
  (raise-not-convergent who (string-append "no minimum found: " what) argument error
                        "value there" f
                        "size of the gradient there" (norm g)
                        "evaluations" evaluations))

;; ---------------------------------------------------------------------------
;; The line

(define fair-part 1e-4)
(define halvings 40)

;; -> point, value and gradient, or #f three times
(define (line-search at x f g p noise)
  (define slope (dot g p))
  (define (lower? a f* g*) (<= f* (+ f (* fair-part a slope))))
  (define (flatter? a f* g*)
    (and (<= f* (+ f noise)) (<= (flabs (dot g* p)) (* 0.9 (flabs slope)))))
  (define hidden? (<= (- slope) (* epsilon (flabs f))))        ; its promise, by rounding
  (if (< slope 0.0)
      (let-values ([(next f* g*) (if hidden? (values #f #f #f) (first-part at x p lower?))])
        (if next (values next f* g*) (first-part at x p flatter?)))
      (values #f #f #f)))

;; At the first of x + p, x + p/2, … that is good.
(define (first-part at x p good?)
  (let loop ([a 1.0] [left halvings])
    (define next (along x a p))
    (define-values (f* g*) (at next))
    (cond [(and (finite? f*) (good? a f* g*)) (values next f* g*)]
          [(= left 0) (values #f #f #f)]
          [else (loop (* 0.5 a) (- left 1))])))

;; ---------------------------------------------------------------------------
;; The matrix, as a vector of rows

(define (scaled-unit n c) (build-vector n (lambda (i) (flvector-scaled c (unit-flvector i n)))))

(define (unit? H) (equal? H (scaled-unit (vector-length H) 1.0)))

;; Before the first correction, H is given the size of the curvature met; a negative one, which
;; corrects nothing, makes steps longer where it is small.
(define (corrected H s y first?)
  (define-values (ys yy ss) (values (dot y s) (dot y y) (dot s s)))
  (define (unit c) (scaled-unit (flvector-length s) c))
  (cond [(> ys (* 1e-14 (sqrt (* yy ss)))) (correct (if first? (unit (/ ys yy)) H) s y (/ 1.0 ys))]
        [(and first? (< 0.0 yy ss)) (unit (sqrt (/ ss yy)))]
        [else H]))

;; Written out, H is symmetric: H − ρ (s (Hy)ᵀ + (Hy) sᵀ) + ρ (1 + ρ y·Hy) s sᵀ.
(define (correct H s y rho)
  (define Hy (product H y))
  (define c (* rho (+ 1.0 (* rho (dot y Hy)))))
  (for/vector #:length (vector-length H)
              ([row (in-vector H)] [si (in-flvector s)] [hi (in-flvector Hy)])
    (for/flvector #:length (flvector-length s)
                  ([h (in-flvector row)] [sj (in-flvector s)] [hj (in-flvector Hy)])
      (+ (- h (* rho (+ (* si hj) (* hi sj)))) (* c si sj)))))

(define (product H v)
  (for/flvector #:length (flvector-length v) ([row (in-vector H)]) (dot row v)))
