#lang racket/base
;; Bessel functions of the first kind and whole order.
;;
;; From 2k/x J_k = J_{k−1} + J_{k+1}, downwards from an order where J is nothing beside what
;; is looked for: what grows that way is J, and J₀ + 2 (J₂ + J₄ + ⋯) = 1 gives the scale
;; (Miller; Abramowitz and Stegun, 9.12).

(require racket/flonum)

(provide Bessel-J)

;; n : a natural number; x : a flonum, at least 0
(define (Bessel-J n x)
  (cond [(fl= x 0.0) (if (eqv? n 0) 1.0 0.0)]
        [(fl< (fl* x x) (fl* 1e-16 (->fl (add1 n)))) (leading-term n x)]
        [else (by-recurrence n x)]))

;; (x/2)ⁿ/n!
(define (leading-term n x)
  (for/fold ([term 1.0]) ([k (in-range 1 (add1 n))])
    (fl/ (fl* term (fl* 0.5 x)) (->fl k))))

(define (by-recurrence n x)
  (let loop ([k (starting-order n x)] [above 0.0] [here 1e-250] [sum 0.0] [wanted 0.0])
    (define found (if (eqv? k n) here wanted))
    (cond [(eqv? k 0) (fl/ found (fl+ here (fl* 2.0 sum)))]
          [(fl> (flabs here) 1e200)
           (loop k (fl* 1e-250 above) (fl* 1e-250 here) (fl* 1e-250 sum) (fl* 1e-250 found))]
          [else
           (loop (sub1 k)
                 here
                 (fl- (fl* (fl/ (->fl (* 2 k)) x) here) above)
                 (if (even? k) (fl+ sum here) sum)
                 found)])))

;; Beyond n and x, J falls faster than any power; an even order.
(define (starting-order n x)
  (define greater (max n (fl->exact-integer (flceiling x))))
  (define beyond (fl->exact-integer (flceiling (fl* 12.0 (flexpt (->fl greater) (fl/ 1.0 3.0))))))
  (* 2 (quotient (+ greater beyond 41) 2)))
