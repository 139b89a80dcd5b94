#lang racket/base
;; A fraction whose denominator holds roots, as a sum of parts each in its own
;; lowest terms.
;;
;; In one quotient, m a + μ x / r³ is (m a r (x² + y²) + μ x) / r³, with r² = x² + y²:
;; nothing cancels.  Sorted by powers of r, the coefficient of r is m a (x² + y²),
;; where the radicand divides; it cancels against r², and m a is back.

(require "kernel.rkt" "field.rkt"
         "polynomial/polynomial.rkt" "polynomial/fraction.rkt")

(provide radical-parts)

;; A polynomial times powers of kernels, ((kernel . exponent) ...).
(struct part (poly powers) #:authentic)

;; p times the powers `below`, whose exponents are negative; -> a list of pairs
;; (polynomial . powers) of that sum.
(define (radical-parts F p below)
  (define roots
    (for/list ([r (in-list (field-relations F))]
               #:when (assq (root-kernel-of F r) below))
      r))
  (for/list ([q (in-list (for/fold ([parts (list (part p below))]) ([r (in-list roots)])
                           (apply append (for/list ([q (in-list parts)]) (split-part F r q)))))])
    (cons (part-poly q) (part-powers q))))

(define (root-kernel-of F r) (vector-ref (field-kernels F) (relation-index r)))

;; One part for each power of the root in the polynomial.
(define (split-part F r q)
  (define R (field-ring F))
  (define k (root-kernel-of F r))
  (define below (cdr (assq k (part-powers q))))
  (define others (filter (lambda (power) (not (eq? (car power) k))) (part-powers q)))
  (for/list ([entry (in-list (poly-coefficients R (part-poly q) (relation-index r)))])
    (define-values (coefficient exponent) (cancel R r (cdr entry) (+ below (car entry))))
    (part coefficient
          (if (eqv? exponent 0) others (insert-power (cons k exponent) others)))))

;; Divides the coefficient by the radicand while it can and the exponent has room.
(define (cancel R r coefficient exponent)
  (define radicand (relation-radicand r))
  (let loop ([c coefficient] [e exponent])
    (define quotient
      (and (<= e (- (relation-degree r)))
           (null? (fraction-denominator-factors radicand))
           (poly-divide R c (fraction-numerator radicand))))
    (if quotient
        (loop quotient (+ e (relation-degree r)))
        (values c e))))

(define (insert-power power powers)
  (cond [(null? powers) (list power)]
        [(< (kernel-place (car power)) (kernel-place (caar powers))) (cons power powers)]
        [else (cons (car powers) (insert-power power (cdr powers)))]))
