#lang racket/base
;; The range of an expression's real values, as far as its structure tells: cos x is from
;; -1 to 1, so cos x - 2 is negative and √((cos x - 2)²) is 2 - cos x.
;;
;; A range is an interval with its ends, which are exact or infinite.  What is dependent
;; is taken for independent, so the range may be too wide, and never too narrow.

(require racket/math
         "signs.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt" "../expression/pi.rkt")

(provide range-signs
         leaf-range node-range interval-signs)   ; the same, step by step

;; -> the signs that values of e may have
(define (range-signs e) (interval-signs (node-fold e leaf-range node-range)))

(define (interval-signs r)
  (cond [(positive? (interval-low r)) positive]
        [(negative? (interval-high r)) negative]
        [(>= (interval-low r) 0) nonnegative]
        [(<= (interval-high r) 0) nonpositive]
        [else any-sign]))

(struct interval (low high) #:authentic)

(define everything (interval -inf.0 +inf.0))
(define not-negative (interval 0 +inf.0))
(define unit (interval -1 1))
(define around-pi (interval pi-digits (+ pi-digits (expt 10 -50))))
(define quarter-turn 11/7)              ; a little more than π/2

(define (leaf-range leaf)
  (cond [(pi-multiple leaf) => (lambda (k) (product (interval k k) around-pi))]
        [(and (rational? leaf) (exact? leaf)) (interval leaf leaf)]
        [else everything]))

;; parts : the ranges of its arguments
(define (node-range n parts)
  (define head (node-head n))
  (cond [(eq? head op:+) (for/fold ([s (car parts)]) ([r (in-list (cdr parts))]) (sum s r))]
        [(eq? head op:-) (sum (car parts) (product (interval -1 -1) (cadr parts)))]
        [(square? n) (power (car parts) 2)]
        [(eq? head op:*) (for/fold ([p (car parts)]) ([r (in-list (cdr parts))]) (product p r))]
        [(eq? head op:/) (quotient-range (car parts) (cadr parts))]
        [(eq? head op:expt) (power (car parts) (cadr (node-args n)))]
        [(eq? head op:abs) (magnitude-range (car parts))]
        [(eq? head op:atan) (interval (* (length parts) (- quarter-turn))
                                      (* (length parts) quarter-turn))]
        [(hash-ref ranges (and (operation? head) (operation-name head)) #f)]
        [else everything]))

(define ranges
  (hasheq 'sin unit 'cos unit 'tanh unit
          'sqrt not-negative 'exp not-negative
          'cosh (interval 1 +inf.0)
          'asin (interval (- quarter-turn) quarter-turn)
          'acos (interval 0 (* 2 quarter-turn))))

;; ---------------------------------------------------------------------------

;; Is it x x?
(define (square? n)
  (define args (node-args n))
  (and (eq? (node-head n) op:*) (= (length args) 2) (equal? (car args) (cadr args))))

(define (sum r s)
  (interval (+ (interval-low r) (interval-low s)) (+ (interval-high r) (interval-high s))))

(define (product r s)
  (define corners
    (for*/list ([x (in-list (list (interval-low r) (interval-high r)))]
                [y (in-list (list (interval-low s) (interval-high s)))])
      (if (or (eqv? x 0) (eqv? y 0)) 0 (* x y))))
  (interval (apply least corners) (apply greatest corners)))

;; `min` and `max` make everything a flonum where one is infinite.
(define (least x . more) (for/fold ([m x]) ([y (in-list more)]) (if (< y m) y m)))
(define (greatest x . more) (for/fold ([m x]) ([y (in-list more)]) (if (> y m) y m)))

(define (quotient-range r s)
  (cond [(or (> (interval-low s) 0) (< (interval-high s) 0))
         (product r (interval (reciprocal (interval-high s)) (reciprocal (interval-low s))))]
        [else everything]))

(define (reciprocal x) (if (infinite? x) 0 (/ 1 x)))

(define (power r n)
  (cond [(and (exact-positive-integer? n) (<= n most-power))
         (define (raised x) (expt x n))
         (if (even? n)
             (let ([m (magnitude-range r)])
               (interval (raised (interval-low m)) (raised (interval-high m))))
             (interval (raised (interval-low r)) (raised (interval-high r))))]
        [(and (real? n) (not (integer? n))) not-negative]
        [else everything]))

(define most-power 64)

(define (magnitude-range r)
  (define-values (low high) (values (interval-low r) (interval-high r)))
  (cond [(>= low 0) r]
        [(<= high 0) (interval (- high) (- low))]
        [else (interval 0 (greatest (- low) high))]))
