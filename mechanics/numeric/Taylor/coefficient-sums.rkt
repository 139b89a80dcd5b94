#lang racket/base
;; Sums of coefficients for a step of the Taylor method: the state at its end and within it, and its
;; rates there; and the sizes of the last coefficients.
;;
;; By machine code (polynomial-code.rkt) where the coefficients come from such, else by loops that
;; do the same operations in the same order.

(require racket/unsafe/ops
         "convolution.rkt" "expansion.rkt"
         "../unboxed-loop.rkt")

(provide motion-end! value-at! rates-at! coefficient-size last-size)

;; Of each state, its row c and s = Σ c_j u^(j − first), j from `first` on, for an action on
;; these at its index i.
(define-syntax-rule (for-each-sum e u first (i c s) do)
  (for-each-row-sum (expansion-states e) (expansion-lasts e) 0 u first (i c s) do))

;; The same of the rates of the states, all terms that are known.
(define-syntax-rule (for-each-rate e u (i c s) do)
  (for-each-row-sum (expansion-slopes e) (expansion-lasts e) 1 u 0 (i c s) do))

;; Rows that end so much before the given indices.  Two at a time, for the processor works on both
;; at once.
(define-syntax-rule (for-each-row-sum all lasts before u first (i c s) do)
  (let* ([rows all]
         [ends lasts]
         [end (unsafe-fx- (vector-length rows) 1)])
    (define-syntax-rule (row k) (unsafe-vector-ref rows k))
    (define-syntax-rule (last k) (unsafe-fx- (unsafe-fxvector-ref ends k) before))
    (let loop ([i 0])
      (cond [(unsafe-fx> i end) (void)]
            [(and (unsafe-fx< i end) (unsafe-fx= (last i) (last (unsafe-fx+ i 1))))
             (let* ([c (row i)] [next (unsafe-fx+ i 1)] [d (row next)])
               (polynomials u first (last i) ([s odd c] [t other-odd d])
                            (begin do
                                   (let ([i next] [c d] [s t]) do)))
               (loop (unsafe-fx+ i 2)))]
            [else
             (let ([c (row i)]) (polynomials u first (last i) ([s odd c]) do))
             (loop (unsafe-fx+ i 1))]))))

;; Stores in `out` the state at the time u, in units of that of the coefficients.
(define (value-at! e u out)
  (define m (expansion-machine e))
  (if (on-tape? m)
      ((tape-run-value m) u (tape-run-tape m) out)
      (for-each-sum e u 0 (i c s) (put! out i s))))

;; The same of its rates.
(define (rates-at! e u out)
  (define m (expansion-machine e))
  (if (on-tape? m)
      ((tape-run-rates m) u (tape-run-tape m) out)
      (for-each-rate e u (i c s) (put! out i s))))

;; z + rest = y + lost + Σ c_k u^k, k from 1, where rounding loses nothing that is not in `rest`
(define (motion-end! e u y lost z rest)
  (define m (expansion-machine e))
  (if (on-tape? m)
      ((tape-run-advance m) u (tape-run-tape m) y lost z rest)
      (for-each-sum e u 1 (i c sum)
        (add-exactly! i (unsafe-fl+ (unsafe-fl* u sum) (at lost i)) y z rest))))

(define (on-tape? m) (and m (not (eq? m 'later))))

;; z + rest = y + d (Knuth)
(define-syntax-rule (add-exactly! i d-form y z rest)
  (let* ([d d-form]
         [x (at y i)]
         [sum (unsafe-fl+ x d)]
         [back (unsafe-fl- sum x)])
    (put! z i sum)
    (put! rest i (unsafe-fl+ (unsafe-fl- x (unsafe-fl- sum back)) (unsafe-fl- d back)))))

;; ---------------------------------------------------------------------------
;; Sizes

;; ‖y_k‖, the greatest component relative to 1 + |y|; not less than infinite if one is not a number
(define (coefficient-size e k)
  (define states (expansion-states e))
  (let loop ([i 0] [greatest 0.0])
    (if (unsafe-fx= i (vector-length states))
        (unboxed greatest)
        (let* ([row (unsafe-vector-ref states i)]
               [scale (unsafe-fl+ 1.0 (unsafe-flabs (at row 0)))]
               [x (unsafe-fl/ (unsafe-flabs (at row k)) scale)])
          (loop (unsafe-fx+ i 1)
                (if (unsafe-fl< x +inf.0) (unsafe-flmax greatest x) +inf.0))))))

;; That of so many orders before the last one, up to three.
(define (last-size e before)
  (define m (expansion-machine e))
  (if (on-tape? m)
      (let ([x (at (tape-run-sizes m) (unsafe-fx- 3 before))])
        (if (unsafe-fl< x +inf.0) (unboxed x) +inf.0))
      (coefficient-size e (unsafe-fx- (expansion-order e) before))))
