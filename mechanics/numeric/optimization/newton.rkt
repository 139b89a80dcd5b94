#lang racket/base
;; A zero of n functions of n variables with their derivatives, by Newton's method,
;; damped (P. Deuflhard, Newton Methods for Nonlinear Problems, 2004, ch. 3).
;;
;; With J the matrix of derivatives at x, the step p = −J⁻¹ f(x) would lead to a zero
;; if f were linear.  Far from one it may lead astray; then a part λ of it is taken,
;; the largest of 1, 1/2, 1/4 ... for which the next step by the same J at the new point
;; is closer to zero,
;;
;;     |J⁻¹ f(x + λp)| ≤ (1 − λ/2) |p|.
;;
;; Both sides are lengths in x: how the equations are scaled or combined makes no
;; difference.  The search ends with a step shorter than the tolerance.  Near a zero
;; where J has an inverse each step squares the error.

(require racket/flonum
         "../finite-number.rkt" "../flvector.rkt" "../checked-arguments.rkt"
         "../linear-algebra/flonum-systems.rkt" "../linear-algebra/row-matrix.rkt"
         "../../error/failure.rkt")

(provide newton difference-rows
         ;; for the method beside it
         solution size no-inverse raise-no-step)

(define least-part (expt 0.5 30))

;; value    : x -> f(x), flvectors of one length
;; jacobian : x -> vector of rows, the derivatives of each component of f
;; observe  : called with each point reached and the value there
;; argument : the user's form of a point
;; -> the point and the length of the last step, about the error before it
(define (newton value jacobian start
                #:tolerance [tolerance 1e-12]
                #:limit [limit 100]
                #:observe [observe void]
                #:argument [argument flvector->list]
                #:name [who 'find-root])
  (check-tolerance who tolerance)
  (define (not-found what x p f count)
    (raise-not-convergent who (string-append "no root found: " what) (argument x) (greatest p)
                          "values there" (flvector->list f)
                          "steps" count))
  (let loop ([x start] [f (value start)] [count 0])
    (observe (argument x) (flvector->list f))
    (unless (flvector-finite? f) (raise-no-step who "the functions are not finite" (argument x) f))
    (define J (and (> (greatest f) 0.0) (jacobian x)))
    (define p (and J (or (solution J f) (raise-no-step who (no-inverse f) (argument x) f))))
    (cond
      [(not p) (values x 0.0)]
      [(short? p x (real->double-flonum tolerance)) (values (along x 1.0 p) (greatest p))]
      [(>= count limit) (not-found "too many steps" x p f count)]
      [else
       (define-values (next f*) (descend value J x p))
       (unless next (not-found "no step leads closer to a root" x p f count))
       (loop next f* (+ count 1))])))

(define (no-inverse f)
  (if (= (flvector-length f) 1)
      "no root seen: the derivative is 0 here, and the value is not"
      "the derivatives of the functions have no inverse"))

;; −J⁻¹ f, or #f
(define (solution J f)
  (define rows
    (and (all-entries? finite? J)
         (floating-solutions J (for/vector ([y (in-flvector f)]) (vector (- y))))))
  (and (vector? rows)
       (for/flvector #:length (flvector-length f) ([row (in-vector rows)]) (vector-ref row 0))))

;; -> point and value there, or #f twice
(define (descend value J x p)
  (define length (size p x))
  (let loop ([part 1.0])
    (define next (along x part p))
    (define f (value next))
    (define q (and (flvector-finite? f) (solution J f)))
    (cond [(and q (<= (size q x) (* (- 1.0 (* 0.5 part)) length))) (values next f)]
          [(< part least-part) (values #f #f)]
          [else (loop (* 0.5 part))])))

;; The derivatives of f from differences over steps of that part of 1 + |x|, a vector of rows
(define (difference-rows f x part)
  (define n (flvector-length x))
  (define (moved j h)
    (define y (flvector-copy x))
    (flvector-set! y j (+ h (flvector-ref x j)))
    (f y))
  (rows-transpose
   (for/vector #:length n ([j (in-range n)])
     (define h (* part (+ 1.0 (abs (flvector-ref x j)))))
     (for/vector #:length n ([a (in-flvector (moved j h))] [b (in-flvector (moved j (- h)))])
       (/ (- a b) (* 2.0 h))))))

;; ---------------------------------------------------------------------------

;; Each component beside 1 + |x|.
(define (size p x)
  (flsqrt (for/fold ([sum 0.0]) ([u (in-flvector p)] [v (in-flvector x)])
            (define q (fl/ u (fl+ 1.0 (flabs v))))
            (fl+ sum (fl* q q)))))

(define (raise-no-step who what x f)
  (raise-singular who what x
                  "at" x
                  "values there" (flvector->list f)))
