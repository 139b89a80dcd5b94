#lang racket/base
;; Discrete Fourier transforms of rows whose length is a power of two (Cooley and Tukey 1965):
;;
;;     cₖ = Σ xⱼ exp(−2πi jk/n),     k = 0 ... n − 1.
;;
;; The even and the odd places are transformed by themselves; with e and o for these,
;; cₖ = eₖ + exp(−2πi k/n) oₖ, and c of k + n/2 is the same with a minus.

(require racket/flonum
         "constants.rkt" "flvector.rkt")

(provide fourier-transform! inverse-fourier-transform!)

;; re, im : flvectors, replaced by their transform
(define (fourier-transform! re im) (transform! re im -1.0))

(define (inverse-fourier-transform! re im)
  (transform! re im 1.0)
  (define scale (fl/ 1.0 (->fl (flvector-length re))))
  (for ([k (in-range (flvector-length re))])
    (flvector-set! re k (fl* scale (flvector-ref re k)))
    (flvector-set! im k (fl* scale (flvector-ref im k)))))

;; a, b <- a + w b, a - w b; in place, so that the numbers stay in registers
(define-syntax-rule (combine! re im a-place b-place c s)
  (let* ([a a-place] [b b-place]
         [x (flvector-ref re b)] [y (flvector-ref im b)]
         [u (fl- (fl* c x) (fl* s y))] [v (fl+ (fl* s x) (fl* c y))]
         [p (flvector-ref re a)] [q (flvector-ref im a)])
    (flvector-set! re a (fl+ p u))
    (flvector-set! im a (fl+ q v))
    (flvector-set! re b (fl- p u))
    (flvector-set! im b (fl- q v))))

(define (transform! re im sign)
  (define n (flvector-length re))
  (define-values (cosines sines) (roots-of-unity n sign))
  (reorder! re im)
  (let double ([half 1])
    (when (< half n)
      (define stride (quotient n (* 2 half)))
      (for* ([start (in-range 0 n (* 2 half))] [k (in-range half)])
        (define root (* k stride))
        (combine! re im (+ start k) (+ start k half)
                  (flvector-ref cosines root) (flvector-ref sines root)))
      (double (* 2 half)))))

(define (roots-of-unity n sign)
  (define (angle k) (fl* sign (fl/ (fl* :2pi (->fl k)) (->fl n))))
  (define count (max 1 (quotient n 2)))
  (values (for/flvector #:length count ([k (in-range count)]) (flcos (angle k)))
          (for/flvector #:length count ([k (in-range count)]) (flsin (angle k)))))

;; Places in the order of their binary digits read backwards.
(define (reorder! re im)
  (define n (flvector-length re))
  (for/fold ([j 0]) ([i (in-range n)])
    (when (< i j)
      (flvector-swap! re i j)
      (flvector-swap! im i j))
    (let carry ([bit (quotient n 2)] [j j])
      (if (and (> bit 0) (> (bitwise-and j bit) 0))
          (carry (quotient bit 2) (- j bit))
          (+ j bit)))))
