#lang racket/base
;; Decimals in answers: 1.41 a x is √2 a x, as far as it tells.
;;
;; Two expressions agree if at all points tried their difference is small beside the sizes of the
;; key's terms, and beside the key's change if its decimals, and π, are a little off.  The
;; symbols' values are of very different sizes, so that no term hides behind another at all points.
;;
;; Where something is to be proved, decimals are read as the exact numbers that they stand for.

(require (only-in racket/math pi)
         "answer-parts.rkt"
         "../../algebra/expression/expression.rkt" "../../algebra/expression/flat-graph.rkt"
         "../../algebra/expression/substitute.rkt" "../../algebra/expression/symbols.rkt"
         "../../algebra/zero/decimal-readings.rkt"
         "../../calculus/expression-function.rkt"
         "../../generic/irrational.rkt" "../../generic/rounding.rkt" "../../generic/scalar.rkt"
         "../../value/simplify.rkt")

(provide real-value value-at scattered has-decimals? decimals-agree? with-exact-decimals)

;; d : a datum
(define (with-exact-decimals d)
  (cond [(pair? d) (cons (with-exact-decimals (car d)) (with-exact-decimals (cdr d)))]
        [(and (flonum? d) (read-decimal d)) => expression->datum]
        [else d]))

;; -> a flonum, or #f
(define (real-value x) (flonum-or-false (and (scalar? x) (g:exact->inexact (simplify x)))))

;; point : ((symbol . number) ...) -> a flonum, or #f where there is no real value
(define (value-at e point)
  (define all (cons (cons ':pi pi) point))
  (flonum-or-false (with-handlers ([exn:fail? (lambda (x) #f)]) (evaluate-generically e all))))

(define (flonum-or-false n)
  (define x (irrational-as-decimal n))
  (and (real? x) (rational? x) (real->double-flonum x)))

(define (has-decimals? e) (and (expression? e) (some-leaf? flonum? e)))

(define (decimals-agree? key answer tolerance)
  (define terms (terms-of key))
  (define decimal-key (substitute-expression key (list (cons ':pi pi))))
  (define names (append (symbols-in key) (symbols-in answer)))
  (define found
    (for*/list ([i (in-range 40)]
                [point (in-value (point-of names i))]
                [k (in-value (value-at key point))]
                #:when k)
      (define a (value-at answer point))
      (define size
        (max (for/sum ([t (in-list terms)]) (abs (or (value-at t point) 0)))
             (doubt decimal-key k point)))
      (and a (<= (abs (- a k)) (* tolerance size)))))
  (and (pair? found) (andmap values found)))

;; The change of e, whose value is x, as each decimal in it changes: the sum of |c ∂e/∂c|
(define (doubt e x point)
  (for/sum ([c (in-list (decimals-in (expression->plain-tape e)))])
    (define changed
      (value-at (substitute-expression e (list (cons c (* c (+ 1 step))))) point))
    (if changed (/ (abs (- changed x)) step) 0)))

(define step 1e-6)

;; From 1/50 to 50
(define (point-of names i)
  (for/list ([s (in-list names)] [j (in-naturals)])
    (cons s (expt 50. (- (* 2 (scattered i j)) 1)))))

;; Between 0 and 1, the same every time
(define (scattered i j)
  (define x (* (+ i 1) (sqrt (+ 2 (* 3 j)))))
  (exact->inexact (- x (floor x))))
