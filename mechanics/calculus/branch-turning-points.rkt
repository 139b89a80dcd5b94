#lang racket/base
;; Between two points where a function makes the same choices it may have made others: of
;; |x − 1/2| < 1/1000 nothing is seen at points a hundredth apart.  But the value that is chosen
;; by turns between them, towards the border.  So where of three points the middle one is
;; nearest to the border, or a value that is rounded has a maximum or minimum, that is sought;
;; and where the choices are others there, it is one more point.

(require "branch-points.rkt" "perturbed-value.rkt"
         "../numeric/optimization/golden-section.rkt")

(provide with-turning-points)

;; The samples, in order, with more between them.
(define (with-turning-points f samples)
  (define more
    (for*/list ([three (in-list (triples samples))]
                [found (in-value (apply other-choice f three))]
                #:when found)
      found))
  (if (null? more)
      samples
      (sort (append samples more) < #:key choice-sample-x)))

(define (triples samples)
  (for/list ([p (in-list samples)] [q (in-list (cdr samples))] [r (in-list (cddr samples))]
             #:when (and (same-choices? p q) (same-choices? q r)))
    (list p q r)))

(define (same-choices? p q)
  (define-values (cs ds) (values (choice-sample-made p) (choice-sample-made q)))
  (and (= (length cs) (length ds)) (alike? cs ds)))

;; A sample between p and r that makes another choice, or #f
(define (other-choice f p q r)
  (for/or ([k (in-range (length (choice-sample-made q)))])
    (define direction (turn (number-at p k) (number-at q k) (number-at r k) (sign-at q k)))
    (and direction (extreme-choice f p r q k direction))))

(define (number-at sample k)
  (define x (innermost (choice-value (list-ref (choice-sample-made sample) k))))
  (if (real? x) (exact->inexact x) +nan.0))

;; 1 or −1 for a choice by sign; #f for one by rounding
(define (sign-at sample k)
  (define c (list-ref (choice-sample-made sample) k))
  (and (eqv? 0 ((choice-between c) (choice-made c) (choice-made c)))
       (choice-made c)))

;; 1.0 if the middle value is least, and less may lie between; −1.0 if it is greatest; or #f.
;; Values in between differ by a few times as much as these.
(define (turn a b c sign)
  (define swing (* 4.0 (max (abs (- a b)) (abs (- c b)))))
  (define near? (or (not sign) (<= (abs b) swing)))
  (cond [(not near?) #f]
        [(and (< b (max a c)) (<= b (min a c)) (not (eqv? sign -1))) 1.0]
        [(and (> b (min a c)) (>= b (max a c)) (not (eqv? sign 1))) -1.0]
        [else #f]))

(define most 1e300)

(define (extreme-choice f p r q k direction)
  (define (height x)
    (define sample (sample-choices f x))
    (if (< k (length (choice-sample-made sample)))
        (* direction (number-at sample k))
        most))
  (define x
    (car (golden-section height (choice-sample-x p) (choice-sample-x r)
                         (width-at-most 1e-12))))
  (define there (sample-choices f x))
  (and (not (alike? (choice-sample-made q) (choice-sample-made there))) there))
