#lang racket/base
;; Functions of an angle, as flvectors of their values at n equally distant angles, n a power of
;; two; operations on them term by term in their Fourier series Σ cₖ exp(ikθ).
;;
;; Operations from real functions to real ones take two at once, as the real and the imaginary
;; part of one function: `both-...` takes half the time.

(require racket/flonum
         "Fourier.rkt"
         "constants.rkt")

(provide node-angle periodic-mean periodic-unshifted
         periodic-value-at
         both-shifted both-slopes both-smoothed both-refined)

(define (node-angle j n) (fl/ (fl* :2pi (->fl j)) (->fl n)))

(define (periodic-mean f)
  (fl/ (for/fold ([sum 0.0]) ([x (in-flvector f)]) (fl+ sum x)) (->fl (flvector-length f))))

;; f(θ + a), g(θ + a)
(define (both-shifted f g a)
  (filtered f g (lambda (k size) (values (flcos (fl* k a)) (flsin (fl* k a))))))

;; f'(θ), g'(θ)
(define (both-slopes f g) (filtered f g (lambda (k size) (values 0.0 k))))

;; g with the mean 0 and g(θ) − g(θ + a) = f(θ) but for the mean of f, and for terms of f that
;; are no greater than `rounding`: where k a is nearly a whole turn noise would come out as a term
(define (periodic-unshifted f a [rounding 0.0])
  (define (factor k size)
    (if (or (fl= k 0.0) (fl<= size rounding))
        (values 0.0 0.0)
        ;; 1/(1 − exp(ika))
        (let ([half (fl* 0.5 (fl* k a))])
          (values 0.5 (fl/ (fl* 0.5 (flcos half)) (flsin half))))))
  (define-values (g zero) (filtered f (make-flvector (flvector-length f)) factor))
  g)

;; Terms k of f and of g multiplied by (factor k size), the real and the imaginary part,
;; and terms −k by its conjugate; size : of term k of f + ig.  The term n/2, of which only the sum
;; with −n/2 is known, is left out.
(define (filtered f g factor)
  (define n (flvector-length f))
  (define-values (re im) (values (flvector-copy f) (flvector-copy g)))
  (fourier-transform! re im)
  (define half (quotient n 2))
  (define (size k)
    (define-values (x y) (values (flvector-ref re k) (flvector-ref im k)))
    (fl/ (flsqrt (fl+ (fl* x x) (fl* y y))) (->fl n)))
  (define (multiply! k c s)
    (define-values (x y) (values (flvector-ref re k) (flvector-ref im k)))
    (flvector-set! re k (fl- (fl* c x) (fl* s y)))
    (flvector-set! im k (fl+ (fl* s x) (fl* c y))))
  (for ([k (in-range half)])
    (define-values (c s) (factor (->fl k) (size k)))
    (multiply! k c s)
    (unless (= k 0) (multiply! (- n k) c (fl- 0.0 s))))
  (multiply! half 0.0 0.0)
  (inverse-fourier-transform! re im)
  (values re im))

;; The same without the terms of the upper third, where products of two functions are wrong.
(define (both-smoothed f g)
  (define third (fl/ (->fl (flvector-length f)) 3.0))
  (filtered f g (lambda (k size) (values (if (fl< k third) 1.0 0.0) 0.0))))

;; The same functions at twice as many angles.
(define (both-refined f g)
  (define half-node (fl* 0.5 (node-angle 1 (flvector-length f))))
  (define-values (f+ g+) (both-shifted f g half-node))
  (define (interleaved u v)
    (for*/flvector #:length (* 2 (flvector-length u))
                   ([k (in-range (flvector-length u))] [w (in-list (list u v))])
      (flvector-ref w k)))
  (values (interleaved f f+) (interleaved g g+)))

;; -> (angle -> value)
(define (periodic-value-at f)
  (define n (flvector-length f))
  (define-values (re im) (values (flvector-copy f) (make-flvector n)))
  (fourier-transform! re im)
  (lambda (theta)
    (for/fold ([sum (fl/ (flvector-ref re 0) (->fl n))]) ([k (in-range 1 (quotient n 2))])
      (define a (fl* (->fl k) theta))
      (fl+ sum (fl* (fl/ 2.0 (->fl n))
                    (fl- (fl* (flvector-ref re k) (flcos a))
                         (fl* (flvector-ref im k) (flsin a))))))))
