#lang racket/base
;; Functions of an angle, as flvectors of their values at n equally distant angles, n a power of
;; two; what is done to them term by term in their Fourier series Σ cₖ exp(ikθ).

(require racket/flonum
         "Fourier.rkt"
         "constants.rkt")

(provide node-angle periodic-mean periodic-shifted periodic-slope periodic-unshifted
         periodic-smoothed periodic-value-at)

(define (node-angle j n) (fl/ (fl* :2pi (->fl j)) (->fl n)))

(define (periodic-mean f)
  (fl/ (for/fold ([sum 0.0]) ([x (in-flvector f)]) (fl+ sum x)) (->fl (flvector-length f))))

;; f(θ + a)
(define (periodic-shifted f a)
  (filtered f (lambda (k) (values (flcos (fl* k a)) (flsin (fl* k a))))))

;; f'(θ)
(define (periodic-slope f) (filtered f (lambda (k) (values 0.0 k))))

;; g with the mean 0 and g(θ) − g(θ + a) = f(θ) but for the mean of f
(define (periodic-unshifted f a)
  (filtered f (lambda (k)
                (if (fl= k 0.0)
                    (values 0.0 0.0)
                    ;; 1/(1 − exp(ika))
                    (let ([half (fl* 0.5 (fl* k a))])
                      (values 0.5 (fl/ (fl* 0.5 (flcos half)) (flsin half))))))))

;; Term k multiplied by what (factor k) gives, the real and the imaginary part, and term −k by
;; its conjugate.  The term n/2, of which only the sum with −n/2 is known, is left out.
(define (filtered f factor)
  (define n (flvector-length f))
  (define-values (re im) (terms f))
  (define half (quotient n 2))
  (define (multiply! k c s)
    (define-values (x y) (values (flvector-ref re k) (flvector-ref im k)))
    (flvector-set! re k (fl- (fl* c x) (fl* s y)))
    (flvector-set! im k (fl+ (fl* s x) (fl* c y))))
  (for ([k (in-range half)])
    (define-values (c s) (factor (->fl k)))
    (multiply! k c s)
    (unless (= k 0) (multiply! (- n k) c (fl- 0.0 s))))
  (multiply! half 0.0 0.0)
  (inverse-fourier-transform! re im)
  re)

(define (terms f)
  (define-values (re im) (values (flvector-copy f) (make-flvector (flvector-length f))))
  (fourier-transform! re im)
  (values re im))

;; The same without the terms of the upper third, where products of two functions are wrong.
(define (periodic-smoothed f)
  (define third (fl/ (->fl (flvector-length f)) 3.0))
  (filtered f (lambda (k) (values (if (fl< k third) 1.0 0.0) 0.0))))

;; -> (angle -> value)
(define (periodic-value-at f)
  (define n (flvector-length f))
  (define-values (re im) (terms f))
  (lambda (theta)
    (for/fold ([sum (fl/ (flvector-ref re 0) (->fl n))]) ([k (in-range 1 (quotient n 2))])
      (define a (fl* (->fl k) theta))
      (fl+ sum (fl* (fl/ 2.0 (->fl n))
                    (fl- (fl* (flvector-ref re k) (flcos a))
                         (fl* (flvector-ref im k) (flsin a))))))))
