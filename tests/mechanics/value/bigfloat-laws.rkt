#lang racket/base
;; Numbers of higher precision obey the laws of fields and derivations, alone, mixed with
;; Racket's numbers and differentiated, to all their digits.

(require (only-in mechanics bigfloat D partial)
         mechanics/calculus/dual
         mechanics/calculus/perturbed-value
         mechanics/generic/kind
         "../support/checks.rkt"
         "../support/bigfloats.rkt" "../support/random.rkt" "../support/skip.rkt"
         "../support/laws/derivation.rkt" "../support/laws/law.rkt" "../support/laws/ring.rkt"
         "../support/random/element.rkt")

(define least-bits 150)
(define tag (fresh-tag))

(define (random-bigfloat)
  (bigfloat (random-rational) (random-integer least-bits (+ 100 least-bits))))

(define (random-number)
  ((random-choice random-bigfloat random-bigfloat random-rational)))

;; To the digits of the least precise ones; of dual numbers, part by part.
(define (same? a b)
  (cond [(or (perturbed? a) (perturbed? b))
         (for/and ([x (parts-list a)] [y (parts-list b)]) (same? x y))]
        [else
         (define x (comparand a))
         (define y (comparand b))
         (<= (abs (- x y)) (* (expt 2 (- 20 least-bits)) (max 1 (abs x) (abs y))))]))

;; The number itself and the coefficients of its ε.
(define (parts-list x)
  (cond [(perturbed? x)
         (define found '())
         ((parts-map (parts-of x)) (lambda (part) (set! found (cons part found)) part) x)
         (reverse found)]
        [else (list x 0)]))

(define field-laws (append ring-laws commutativity-laws power-laws division-laws))
(define generic-derivation (derivation D (lambda (i f) ((partial i) f))))

(skip-unless bigfloats? no-bigfloats
  (check-laws "bigfloats" field-laws generic-ring random-bigfloat same? #:seed 301)
  (check-laws "bigfloats and fractions" field-laws generic-ring random-number same? #:seed 302)
  (check-laws "bigfloats in dual numbers" field-laws generic-ring
              (lambda () (make-dual tag (random-bigfloat) (random-number))) same? #:seed 303)
  (check-laws "D at bigfloats" derivation-laws generic-derivation
              (draw-functions random-bigfloat random-function) same? #:seed 304)
  (check-laws "partial at bigfloats" partial-laws generic-derivation
              (draw-functions random-bigfloat random-function-of-two) same? #:seed 305)

  (test-case "results have the digits that the laws are checked to"
    (check-true (other-number? (bigfloat 1 least-bits)))
    (check-false (same? (bigfloat 1/3 200) (bigfloat 1/3 100)))))
