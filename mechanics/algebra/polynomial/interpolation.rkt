#lang racket/base
;; Interpolation over prime fields.
;;
;; Newton: the polynomial of least degree with given values at given points.
;;
;; Power sums: find c₁ ... cₙ from the sums bₜ = Σ cⱼ mⱼ^t, t = 1 ... n.  With
;; M(z) = ∏ (z - mᵢ) and M(z)/(z - mⱼ) = Σ aₜ z^t, the combination Σ aₜ bₜ₊₁ keeps
;; the j-th term alone: it is cⱼ mⱼ ∏_{i≠j} (mⱼ - mᵢ).  That costs n² products.

(require racket/fixnum "modular.rkt")

(provide newton-coefficients solve-power-sums)

;; -> fxvector of the coefficients by ascending degree.
;; points, values : fxvectors of equal length, the points distinct
(define (newton-coefficients points values P)
  (define n (fxvector-length points))
  (define differences (divided-differences points values P))
  (define result (make-fxvector n 0))
  ;; Horner from the last difference: result := result (z - pointᵢ) + differenceᵢ
  (for ([i (in-range (fx- n 1) -1 -1)])
    (multiply-by-root! result (fx- n i 1) (fxvector-ref points i) P)
    (fxvector-set! result 0 (mod+ (fxvector-ref result 0) (fxvector-ref differences i) P)))
  result)

(define (divided-differences points values P)
  (define d (fxvector-copy values))
  (define n (fxvector-length d))
  (for* ([k (in-range 1 n)] [i (in-range (fx- n 1) (fx- k 1) -1)])
    (define rise (mod- (fxvector-ref d i) (fxvector-ref d (fx- i 1)) P))
    (define run (mod- (fxvector-ref points i) (fxvector-ref points (fx- i k)) P))
    (fxvector-set! d i (mod* rise (mod-inverse run P) P)))
  d)

;; v, of degree below k, times (z - root), in place.
(define (multiply-by-root! v k root P)
  (define minus (fx- P root))
  (for ([i (in-range (fxmin k (fx- (fxvector-length v) 1)) 0 -1)])
    (fxvector-set! v i
                   (fxremainder (fx+ (fxvector-ref v (fx- i 1))
                                     (fx* minus (fxvector-ref v i)))
                                P)))
  (fxvector-set! v 0 (mod* minus (fxvector-ref v 0) P)))

;; The vector of c, or #f when two m agree.
;; ms, sums : fxvectors; the first (length of ms) sums are used
(define (solve-power-sums ms sums P)
  (define n (fxvector-length ms))
  (define master (make-fxvector (fx+ n 1) 0))
  (fxvector-set! master 0 1)
  (for ([j (in-range n)])
    (multiply-by-root! master (fx+ j 1) (fxvector-ref ms j) P))
  (define result (make-fxvector n 0))
  (define distinct?
    (for/and ([j (in-range n)])
      (define m (fxvector-ref ms j))
      (define-values (combination scale) (combine master m sums n P))
      (define divisor (mod* m scale P))
      (unless (eq? 0 divisor)
        (fxvector-set! result j (mod* combination (mod-inverse divisor P) P)))
      (not (eq? 0 divisor))))
  (and distinct? result))

;; Synthetic division of the master polynomial by (z - m), from the top, summing
;; aₜ bₜ₊₁ and aₜ m^t on the way.
(define (combine master m sums n P)
  (for/fold ([combination 0] [scale 0] [a 0] #:result (values combination scale))
            ([t (in-range (fx- n 1) -1 -1)])
    (define next
      (fxremainder (fx+ (fxvector-ref master (fx+ t 1)) (fx* m a)) P))
    (values (fxremainder (fx+ combination (fx* next (fxvector-ref sums t))) P)
            (fxremainder (fx+ next (fx* m scale)) P)
            next)))
