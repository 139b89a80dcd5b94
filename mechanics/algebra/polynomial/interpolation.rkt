#lang racket/base
;; Interpolation over prime fields.
;;
;; Newton: the polynomial of least degree with given values at given points.
;;
;; Power sums: find c₁ ... cₙ from the sums bₜ = Σ cⱼ mⱼ^t, t = 1 ... n.  With
;; M(z) = ∏ (z - mᵢ) and M(z)/(z - mⱼ) = Σ aₜ z^t, the combination Σ aₜ bₜ₊₁ keeps
;; the j-th term alone: it is cⱼ mⱼ ∏_{i≠j} (mⱼ - mᵢ).  That costs n² products.

(require racket/fixnum
         "modular.rkt")

(provide make-newton solve-power-sums)

;; A procedure from values at the points, a list, to the coefficients by
;; ascending degree, a fxvector.
;; points : list of distinct residues
(define (make-newton points P)
  (define xs (apply fxvector points))
  (define n (fxvector-length xs))
  (define inverses (inverse-distances xs P))
  (lambda (ys)
    (define differences (apply fxvector ys))
    (divided-differences! differences inverses P)
    ;; Horner from the last difference: result := result (z - xᵢ) + differenceᵢ
    (define result (make-fxvector n 0))
    (for ([i (in-range (fx- n 1) -1 -1)])
      (multiply-by-root! result (fx- n i 1) (fxvector-ref xs i) P)
      (fxvector-set! result 0
                     (mod+ (fxvector-ref result 0) (fxvector-ref differences i) P)))
    result))

;; Vector by i of fxvectors by j < i of 1/(xᵢ - xⱼ).
(define (inverse-distances xs P)
  (for/vector #:length (fxvector-length xs) ([x (in-fxvector xs)] [i (in-naturals)])
    (for/fxvector #:length i ([y (in-fxvector xs)] [j (in-range i)])
      (mod-inverse (mod- x y P) P))))

(define (divided-differences! d inverses P)
  (define n (fxvector-length d))
  (for* ([k (in-range 1 n)] [i (in-range (fx- n 1) (fx- k 1) -1)])
    (define rise (mod- (fxvector-ref d i) (fxvector-ref d (fx- i 1)) P))
    (define inverse (fxvector-ref (vector-ref inverses i) (fx- i k)))
    (fxvector-set! d i (mod* rise inverse P))))

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
