#lang racket/base
;; Of which order the expansions of the Taylor method are, and how long its steps.
;;
;; With ρ_k = ‖y_k‖^(−1/k), near the radius of convergence, the step is
;;
;;     h = q min(ρ_{n−1}, ρ_n),   where q^(n+1)/(1 − q) = ε/200,
;;
;; as all terms left out are then.  Jorba and Zou's are twice as much: they take
;; n = ⌈1 − ½ ln ε⌉ and q near e⁻², so that the work for a unit of time is least if an expansion
;; takes n² operations.  But it takes a + b n + c n², and the smaller the system, the more of
;; that are a and b; so n is the one for which (a + b n + c n²)/q is least.

(require racket/flonum
         racket/list
         (only-in "../constants.rkt" rounding)
         (only-in "../Taylor/expansion.rkt" work-of-order))

(provide order-for log-share term-tolerance)

;; w : what an expansion takes (numeric/Taylor/expansion.rkt)
(define (order-for tolerance w)
  (define least (max 4 (fl->exact-integer (ceiling (- 1.0 (* 0.5 (log tolerance)))))))
  (argmin (lambda (n) (/ (work-of-order w n) (exp (log-share n tolerance))))
          (range least (* 2 least))))

;; ln q, by repetition.
(define (log-share n tolerance)
  (for/fold ([l -2.0]) ([_ (in-range 8)])
    (/ (+ (log (* 0.005 tolerance)) (log (- 1.0 (exp l)))) (+ n 1.0))))

;; Of the terms left out, which do not need a tenth; or if that is no more than rounding, they
;; are to be nothing beside rounding.
(define (term-tolerance tolerated)
  (if (fl<= tolerated rounding) least-term (fl* 10.0 tolerated)))

(define least-term 1e-17)
