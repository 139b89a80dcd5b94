#lang racket/base
;; Values of polynomials at points, over any numbers and over prime fields.
;;
;; Powers of a coordinate are computed once and kept for the whole polynomial.

(require racket/fixnum "ring.rkt")

(provide poly-evaluate poly-evaluate-mod
         residue mod-expt mod-inverse)

;; point : a vector of numbers, one a variable
(define (poly-evaluate R p point)
  (for/fold ([sum 0]) ([t (in-list p)])
    (+ sum
       (for/fold ([value (cdr t)]) ([f (in-list (monomial-factors R (car t)))])
         (* value (expt (vector-ref point (car f)) (cdr f)))))))

;; point : a vector of residues; prime : below 2^30, dividing no denominator
(define (poly-evaluate-mod R p point prime)
  (for/fold ([sum 0]) ([t (in-list p)])
    (fxmodulo
     (fx+ sum
          (for/fold ([value (residue (cdr t) prime)])
                    ([f (in-list (monomial-factors R (car t)))])
            (fxmodulo (fx* value (mod-expt (vector-ref point (car f)) (cdr f) prime))
                      prime)))
     prime)))

;; The residue of a rational number.
(define (residue c prime)
  (if (integer? c)
      (modulo c prime)
      (modulo (* (numerator c) (mod-inverse (modulo (denominator c) prime) prime))
              prime)))

(define (mod-expt base k prime)
  (let loop ([base base] [k k] [value 1])
    (cond [(eq? k 0) value]
          [(eq? k 1) (fxmodulo (fx* value base) prime)]
          [else
           (loop (fxmodulo (fx* base base) prime)
                 (fxrshift k 1)
                 (if (eq? 1 (fxand k 1)) (fxmodulo (fx* value base) prime) value))])))

;; The inverse of a nonzero residue, by Euclid's algorithm.
(define (mod-inverse a prime)
  (let loop ([r prime] [s a] [u 0] [v 1])
    (cond [(eq? s 1) (fxmodulo v prime)]
          [(eq? s 0)
           (raise-arguments-error 'mod-inverse "no inverse" "residue" a "prime" prime)]
          [else
           (define q (fxquotient r s))
           (loop s (fx- r (fx* q s)) v (fx- u (fx* q v)))])))
