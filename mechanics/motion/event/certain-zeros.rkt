#lang racket/base
;; Does a truncated Taylor polynomial show where a function is 0?
;;
;; The coefficients are those of the function along a part of a step, the part being 1, up to some
;; order.  The last two of them estimate the remainder.  It must be small beside all of them; or
;; beside the uncertainty of the function, as for a conserved one, whose coefficients are rounding.
;;
;; The remainder and the rounding must be small where the function is small, too: exp(100 x) - 1 is
;; 10⁴³ where a step begins, and -1 where it ends, which the sum of the coefficients does not show.
;; Nor may the terms grow, however small they are yet: those of exp(-200 x²) - 1/2 grow far from 0,
;; where the function is -1/2, and announce a zero farther on.

(require racket/flonum
         racket/unsafe/ops
         "../../numeric/constants.rkt" "../../numeric/unboxed-loop.rkt")

(provide tells-zeros? total scaled places-for usual-places)

;; uncertain : -> the uncertainty of the function, which costs another evaluation
(define (tells-zeros? c tolerance uncertain)
  (define n (flvector-length c))
  (define rest (fl+ (flabs (flvector-ref c (- n 1))) (flabs (flvector-ref c (- n 2)))))
  (define varying (total c 1))
  (define all (fl+ (flabs (flvector-ref c 0)) varying))
  (and (or (and (fl<= rest (fl* (fl* 10.0 tolerance) all))
                (fl<= rest (fl* most-of-varying varying)))
           (fl<= rest (fl* 0.1 (uncertain))))
       (known-all-along? c (fl+ rest (fl* epsilon all)) all)))

;; Two of twenty terms have a tenth of the sum if they are all alike.
(define most-of-varying 0.05)

;; by : the error of the values
(define (known-all-along? c by all)
  (for/and ([x (in-list '(0.25 0.5 0.75 1.0))])
    (define size (size-near c x))
    (or (fl>= size (fl* 1e-3 all)) (fl>= size (fl* 1e8 by)))))

;; Of the value and, lest there is a zero, of slope and curvature, over a length in which the last
;; of n terms may change.
(define (size-near c x)
  (define n (->fl (flvector-length c)))
  (let loop ([k (unsafe-fx- (flvector-length c) 1)] [value 0.0] [slope 0.0] [bend 0.0])
    (if (unsafe-fx< k 0)
        (fl+ (flabs value) (fl/ (fl+ (flabs slope) (fl/ (flabs bend) n)) n))
        (loop (unsafe-fx- k 1)
              (unsafe-fl+ (unsafe-flvector-ref c k) (unsafe-fl* x value))
              (unsafe-fl+ value (unsafe-fl* x slope))
              (unsafe-fl+ slope (unsafe-fl* x bend))))))

(define (total c [from 0])
  (let loop ([k (unsafe-fx- (flvector-length c) 1)] [sum 0.0])
    (if (unsafe-fx< k from)
        (unboxed sum)
        (loop (unsafe-fx- k 1) (unsafe-fl+ sum (unsafe-flabs (unsafe-flvector-ref c k)))))))

;; c_k span^k; 0 where c_k is 0, even if the power is infinite
(define (scaled row order span)
  (define c (make-flvector (+ order 1)))
  (let loop ([k 0] [power 1.0])
    (when (unsafe-fx<= k order)
      (define x (at row k))
      (put! c k (if (unsafe-fl= x 0.0) 0.0 (unsafe-fl* power x)))
      (loop (unsafe-fx+ k 1) (unsafe-fl* span power))))
  c)

;; ---------------------------------------------------------------------------
;; Places to look at where it does not

(define usual-places 8)
(define most-places 400)

;; Six places for each radius of convergence.
(define (places-for c)
  (define n (- (flvector-length c) 1))
  (define (ratio k)
    (flexpt (fl/ (flabs (flvector-ref c k)) (fl+ 1e-300 (flabs (flvector-ref c 0))))
            (fl/ 1.0 (->fl k))))
  (define wanted (fl* 6.0 (flmax (ratio n) (ratio (- n 1)))))
  (if (fl< wanted (->fl most-places)) (max usual-places (fl->exact-integer (ceiling wanted)))
      most-places))
