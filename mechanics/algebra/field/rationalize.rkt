#lang racket/base
;; Denominators without roots, absolute values and sines.
;;
;; In a tower of relations xᵢ^q = u a fraction has many forms, 1/(1 + √a) and
;; (√a - 1)/(a - 1), 1/r and r/u.  A denominator h = a - y, y = b xʲ, becomes
;; free of x when numerator and denominator are multiplied by
;; aⁿ⁻¹ + aⁿ⁻² y + ... + yⁿ⁻¹, where n is the least with q | n j: the norm is
;; aⁿ - yⁿ.  Of a power of x the complement to x^q does it.  From the top of the
;; tower down, all denominators become polynomials in the independent
;; kernels, and the fraction depends on the value alone.
;;
;; Longer denominators stay as they are, as do those with more powers of x.

(require racket/list
         "field.rkt"
         "../kernel/kernel.rkt"
         "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt")

(provide rationalize rationalize-above)

;; A numerator times its conjugates, a power of the root in it replaced by the
;; radicand, may grow to this many products of terms.
(define growth-limit 200)

(define (rationalize F f)
  (for/fold ([f f]) ([r (in-list (field-relations F))])
    (if (fraction-polynomial? f) f (rationalize-by F r f))))

;; A short numerator without them instead: (√a - 1)/(a - 1) is 1/(1 + √a).  f itself
;; if nothing changes, or the ring has no room: such a form would be longer.
(define (rationalize-above F f)
  (define R (field-ring F))
  (if (and (not (fraction-polynomial? f))
           (<= 2 (poly-term-count (fraction-numerator f)) 6)
           (for/or ([i (in-list (poly-variables R (fraction-numerator f)))]) (relation-of F i)))
      (with-handlers ([exn:algebra:degree-overflow? (lambda (x) f)])
        (fraction-invert R (rationalize F (fraction-invert R f))))
      f))

(define (rationalize-by F r f)
  (for/fold ([f f]) ([h (in-list (fraction-denominator-factors f))]
                     #:when (positive? (poly-degree (field-ring F) (power-base h)
                                                    (relation-index r)))
                     #:unless (long-in-sines? F r (power-base h)))
    (define c (conjugate F r (power-base h)))
    (if (and c (modest? r f c (power-exponent h)))
        (multiplied F r f h c)
        f)))

;; The norm of m + M sin²(θ - φ), written out in θ and φ, is no denominator to read.
(define (long-in-sines? F r h)
  (and (sine? F r)
       (> (poly-term-count h) 4)
       (> (for/sum ([s (in-list (field-relations F))] #:when (sine? F s))
            (min 1 (poly-degree (field-ring F) h (relation-index s))))
          1)))

(define (sine? F r)
  (circle? (kernel-relation (field-kernel F (relation-index r)))))

(define (modest? r f c e)
  (<= (* (poly-term-count (fraction-numerator f))
         (poly-term-count (fraction-numerator (relation-radicand r)))
         (expt (poly-term-count c) (min e 20)))
      growth-limit))

;; The conjugate to multiply h by, or #f.
(define (conjugate F r h)
  (define R (field-ring F))
  (define i (relation-index r))
  (define q (relation-degree r))
  (define slices (poly-coefficients R h i))          ; highest first
  (define degree (slice-degree (first slices)))

  (cond [(>= degree q) #f]
        [(null? (rest slices)) (poly-expt R (poly-variable R i) (- q degree))]
        [(null? (rest (rest slices)))
         (define a (slice-coefficient (second slices)))
         (define y
           (poly* R (poly-negate R (slice-coefficient (first slices))) (poly-variable R i degree)))
         (geometric-sum R a y (/ q (gcd q degree)))]
        [else #f]))

;; (a^n - y^n) / (a - y)
(define (geometric-sum R a y n)
  (poly-sum R (for/list ([k (in-range n)])
                (poly* R (poly-expt R a (- n k 1)) (poly-expt R y k)))))

;; f with numerator and denominator multiplied by c^e, h^e being in it.  The norm
;; may be 0: (|x| - x)(|x| + x) is.
(define (multiplied F r f h c)
  (define R (field-ring F))
  (define (from p) (fraction-from-poly R p))
  (define p (power-base h))
  (define e (power-exponent h))
  (define norm (reduce-fraction F (lower R r (poly* R p c))))
  (define (above) (reduce-fraction F (fraction* R f (fraction-expt R (from p) e))))
  (if (fraction-zero? norm)
      f
      (reduce-fraction F
        (fraction/ R
                   (fraction* R (above) (reduce-fraction F (fraction-expt R (from c) e)))
                   (fraction-expt R norm e)))))
