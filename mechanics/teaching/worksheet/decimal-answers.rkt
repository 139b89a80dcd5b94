#lang racket/base
;; Decimals in answers: 1.41 a x is √2 a x, as far as it tells.
;;
;; Two expressions agree if at all points tried their difference is small beside the sum of the
;; sizes of the key's terms.  The symbols' values are of very different sizes, so that no term hides
;; behind another at all points.

(require "answer-parts.rkt"
         "../../algebra/expression/expression.rkt" "../../algebra/expression/symbols.rkt"
         "../../calculus/expression-function.rkt"
         "../../generic/rounding.rkt"
         "../../value/simplify.rkt")

(provide real-value value-at has-decimals? decimals-agree? scattered)

;; -> a flonum, or #f
(define (real-value x) (flonum-or-false (and (expression? x) (g:exact->inexact (simplify x)))))

;; point : ((symbol . number) ...) -> a flonum, or #f where there is no real value
(define (value-at e point)
  (flonum-or-false
   (with-handlers ([exn:fail? (lambda (x) #f)]) (evaluate-generically e point))))

(define (flonum-or-false n) (and (real? n) (rational? n) (real->double-flonum n)))

(define (has-decimals? e) (and (expression? e) (some-leaf? flonum? e)))

(define (decimals-agree? key answer tolerance)
  (define terms (terms-of key))
  (define names (append (symbols-in key) (symbols-in answer)))
  (define found
    (for*/list ([i (in-range 40)]
                [point (in-value (point-of names i))]
                [k (in-value (value-at key point))]
                #:when k)
      (define a (value-at answer point))
      (define size (for/sum ([t (in-list terms)]) (abs (or (value-at t point) 0))))
      (and a (<= (abs (- a k)) (* tolerance size)))))
  (and (pair? found) (andmap values found)))

;; From 1/50 to 50
(define (point-of names i)
  (for/list ([s (in-list names)] [j (in-naturals)])
    (cons s (expt 50. (- (* 2 (scattered i j)) 1)))))

;; Between 0 and 1, the same every time
(define (scattered i j)
  (define x (* (+ i 1) (sqrt (+ 2 (* 3 j)))))
  (exact->inexact (- x (floor x))))
