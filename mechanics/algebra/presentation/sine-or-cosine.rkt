#lang racket/base
;; Choosing between sin² and cos².
;;
;; A reduced polynomial holds no sin².  For each basic angle the same value is
;; also written without cos², and in either form pairs of terms are merged,
;;
;;     X - X cos²θ = X sin²θ,      X - X sin²θ = X cos²θ
;;
;; (hyperbolic: X cosh²u - X = X sinh²u, X + X sinh²u = X cosh²u).  The form
;; with fewer terms is kept, the one without sin² if they tie.

(require "../field/field.rkt"
         "../kernel/kernel.rkt"
         "../polynomial/fraction.rkt" "../polynomial/monomial.rkt" "../polynomial/polynomial.rkt"
         "../polynomial/ring.rkt" "../polynomial/term-list.rkt")

(provide shortest-squares)

;; A polynomial equal to p modulo the relations, in which sines may be squared.
(define (shortest-squares F p)
  (for/fold ([p p]) ([r (in-list (field-relations F))])
    (define o (kernel-relation (field-kernel F (relation-index r))))
    (if (and (circle? o) (>= (poly-degree (field-ring F) p (kernel-index (circle-cosine o))) 2))
        (choose F p o)
        p)))

(define (choose F p o)
  (define R (field-ring F))
  (define sign (circle-sign o))
  (define sine (kernel-index (circle-sine o)))
  (define cosine (kernel-index (circle-cosine o)))
  (define without-sines (merge R p cosine sine -1 sign))
  (define without-cosines (merge R (eliminate R p cosine sine sign) sine cosine (- sign) 1))
  (if (< (poly-term-count without-cosines) (poly-term-count without-sines))
      without-cosines
      without-sines))

;; p with cos² = 1 - sign sin².
(define (eliminate R p cosine sine sign)
  (define cosine²
    (poly- R (poly-constant R 1) (poly-scale R sign (poly-variable R sine 2))))
  (fraction-numerator
   (lower R (relation cosine 2 (fraction-from-poly R cosine²)) p)))

;; Pairs X m + (ratio X) m xᵢ² become (factor X) m xⱼ².
(define (merge R p i j ratio factor)
  (define xi² (variable-power R i 2))
  (define xj² (variable-power R j 2))
  (define table (make-monomial-hash R))
  (for ([t (in-list p)]) (hash-set! table (term-monomial t) (term-coefficient t)))
  (define merged
    (for*/list ([t (in-list p)]
                [m (in-value (term-monomial t))]
                #:when (>= (monomial-exponent R m i) 2)
                [low (in-value (monomial- m xi²))]
                [x (in-value (hash-ref table low #f))]
                #:when (and x (hash-has-key? table m) (= (term-coefficient t) (* ratio x))))
      (hash-remove! table m)
      (hash-remove! table low)
      (list (make-term (monomial+ low xj²) (* factor x)))))
  (if (null? merged)
      p
      (poly+ R
             (filter (lambda (t) (hash-has-key? table (term-monomial t))) p)
             (poly-sum R merged))))
