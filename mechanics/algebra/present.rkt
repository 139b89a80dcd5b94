#lang racket/base
;; From the canonical value back to what a physicist would write.
;;
;; The value is a reduced fraction of polynomials in kernels.  Presentation
;; chooses among equal forms of it, and never changes the value:
;;
;; - sin² or cos², angles contracted or not, multiple or not: whichever is shorter;
;; - a fraction is split over the terms of its numerator, or kept whole; roots and
;;   sines in sums stand above, or below;
;; - squares of binomials are squares;
;; - a sum is written expanded; or with the terms that agree in all kernels but
;;   symbols collected; or grouped by common factors; or with its content in front.
;;
;; The first form named is kept unless another is smaller by a sixth.  The
;; choice depends on the value and the order of kernels alone.

(require "operation.rkt" "expression.rkt" "kernel.rkt" "field.rkt" "order.rkt" "term.rkt"
         "form.rkt" "exact.rkt" "exponentials.rkt" "spelling.rkt" "pieces.rkt"
         "rationalize.rkt" "squares-of-sums.rkt" "grouping.rkt"
         "polynomial/polynomial.rkt" "polynomial/fraction.rkt")

(provide present linear-terms)

(define (present F f)
  (define p (fraction-numerator f))
  (cond [(fraction-zero? f) 0]
        [(and (fraction-polynomial? f) (poly-constant? p))
         (present-number (poly-constant-value p) (field-inexact? F))]
        [else
         (define usual (fraction-form F f))
         (define other (rationalize-above F f))
         (form-expression
          (if (eq? other f)
              usual
              (smaller-form usual (fraction-form F other))))]))

(define (fraction-form F f)
  (define-values (whole by-roots by-factors) (fraction->piece-lists F f))
  (define usual (present-pieces F by-factors))
  (define by-roots-alone
    (if (eq? by-roots by-factors)
        usual
        (shorter-form usual (present-pieces F by-roots))))
  (if (or (eq? whole by-roots) (fraction-polynomial? f))
      by-roots-alone
      (smaller-form by-roots-alone (present-pieces F whole))))

;; The value as a linear combination: ((number . expression) ...), in the order
;; of its terms.
(define (linear-terms F f)
  (define p (fraction->piece F f))
  (define below (divisor-powers F p))
  (for/list ([t (in-list (term-sort (piece-terms F p)))])
    (cons (present-number (* (term-coefficient below) (term-coefficient t)) (field-inexact? F))
          (form-expression
           (term-form (term 1 (multiply-powers (term-powers t) (term-powers below))) #f)))))

;; ---------------------------------------------------------------------------
;; Pieces as terms

(define (poly->terms F p)
  (for/list ([t (in-list (spell F p))]) (make-term (car t) (cdr t))))

(define (piece-terms F p)
  (define powers (term-powers (make-term 1 (piece-powers p))))
  (define terms (multiply-terms (poly->terms F (piece-numerator p)) powers))
  (if (ormap has-exponential? terms)
      (map (lambda (t) (merged-exponentials F t)) terms)
      terms))

;; Which exponentials are basic depends on those that occurred; their product does not.
(define (merged-exponentials F t)
  (make-term (term-coefficient t)
             (merge-exponentials (term-powers t)
                                 (lambda (e relation) (field-whole-kernel F e relation)))))

;; A piece without divisors is the terms of its numerator, any other one term.
(define (present-pieces F pieces)
  (sum-of F
          (apply append
                 (for/list ([p (in-list pieces)])
                   (if (null? (piece-factors p))
                       (piece-terms F p)
                       (list (quotient-term F p)))))))

(define (quotient-term F p)
  (define-values (c powers core) (extract-content (piece-terms F p)))
  (define above (sum->term F core))
  (define below (divisor-powers F p))
  (make-term (* c (term-coefficient above) (term-coefficient below))
             (append powers (term-powers above) (term-powers below))))

;; The divisors as negative powers of kernels, and 1 or -1: divisors that would
;; be mostly negative change their sign.
(define (divisor-powers F p)
  (for/fold ([product (term 1 '())]) ([h (in-list (piece-factors p))])
    (define terms (poly->terms F (car h)))
    (define flip? (mostly-negative? terms))
    (define below (sum->term F (if flip? (scale-terms -1 terms) terms)))
    (term (* (term-coefficient product)
             (expt (* (if flip? -1 1) (term-coefficient below)) (- (cdr h))))
          (multiply-powers (term-powers product)
                           (for/list ([q (in-list (term-powers below))])
                             (cons (car q) (* (- (cdr h)) (cdr q))))))))

(define (mostly-negative? terms)
  (define (negative t) (negative? (term-coefficient t)))
  (define surplus (for/sum ([t (in-list terms)]) (if (negative t) 1 -1)))
  (or (positive? surplus)
      (and (eqv? surplus 0) (negative (car (term-sort terms))))))

;; ---------------------------------------------------------------------------
;; Sums of terms

(define (sum-of F terms) (terms-form F (condense F terms)))

(define (sum->term F terms) (one-term F (condense F terms)))

;; One term equal to the sum.
(define (one-term F terms)
  (if (null? (cdr terms))
      (car terms)
      (term 1 (list (cons (sum-kernel F terms) 1)))))

(define (sum-kernel F terms)
  (field-whole-kernel F ((form-build (terms-form F terms)) 1)))

;; The terms in the form they are shown in: as they are, or fewer.
(define (condense F terms)
  (define squares (with-squares F terms))
  (define grouped (if (null? (cdr squares)) squares (prefer-grouped F squares)))
  (if (null? (cdr grouped)) grouped (prefer-factored F grouped)))

(define (with-squares F terms)
  (merge-squares (if (null? (cdr terms)) terms (term-sort terms))
                 (lambda (terms) (unsigned-kernel F terms))))

;; The kernel of a sum or of its opposite, whichever begins with a plus.
(define (unsigned-kernel F terms)
  (define sorted (term-sort terms))
  (define negative? (< (term-coefficient (car sorted)) 0))
  (sum-kernel F (if negative? (scale-terms -1 sorted) sorted)))

;; The first of the lists unless a later one is enough smaller.
(define (prefer F usual . others)
  (for/fold ([best usual]) ([other (in-list others)])
    (if (or (eq? best other)
            (not (smaller-form? (terms-form F best) (terms-form F other))))
        best
        other)))

(define (prefer-grouped F terms)
  (define (->term terms) (one-term F (with-squares F terms)))
  (define (collected terms)
    (group-by-kernels terms ->term (lambda (usual product core) (smaller? F usual product))))
  (define (->term/collected terms) (one-term F (collected terms)))
  (define (welcome? usual product core)
    (if (symbols-times-sum? product)
        (< (terms-size F (list product)) (terms-size F usual))
        (smaller? F usual product)))
  (define (welcome-in-residual? usual product core)
    (and (smaller? F usual product)
         (or (ormap divided? usual)
             (ormap derivative-power? (term-powers product))
             (andmap without-circles? core))))
  (if (residual? terms)
      (group-by-factors (collected terms) residual-weight ->term/collected welcome-in-residual?)
      (group-by-factors (collected terms) heavy-size ->term/collected welcome?)))

(define (terms-size F terms) (form-size (terms-form F terms)))

(define (smaller? F usual product)
  (smaller-form? (terms-form F usual) (terms-form F (list product))))

;; ½ m (ẋ² + ẏ²) is how it is known, however little shorter.
(define (symbols-times-sum? t)
  (define others
    (filter (lambda (p) (not (symbol? (kernel-expression (car p))))) (term-powers t)))
  (and (not (divided? t))
       (pair? others) (null? (cdr others)) (sum-kernel? (caar others))))

(define (divided? t)
  (for/or ([p (in-list (term-powers t))]) (negative? (cdr p))))

;; Fractions within a fraction are no improvement, except over sums and roots.
(define (heavy-size k e) (if (heavy-power? k e) (power-size k e) 0))
(define (heavy-power? k e) (or (positive? e) (not (symbol? (kernel-expression k)))))

;; Equations of motion stay sums over the highest derivatives, their coefficients
;; collected.  What they may share besides are divisors, or sines times a sum
;; without any: m l (g + ÿ) sin θ.
(define (residual? terms)
  (for*/or ([t (in-list terms)] [p (in-list (term-powers t))])
    (>= (derivative-order (kernel-expression (car p))) 2)))

(define (residual-weight k e)
  (if (or (circular-kernel? k) (negative? e)) (heavy-size k e) 0))

(define (derivative-power? p) (>= (derivative-order (kernel-expression (car p))) 1))

(define (without-circles? t)
  (not (for/or ([p (in-list (term-powers t))]) (circular-kernel? (car p)))))

;; With what the terms share in front, or all over one denominator, if that is
;; enough smaller; exponentials that they share always.
(define (prefer-factored F terms)
  (define-values (c shared core) (extract-content terms #t))
  (define sign (if (negative? c) -1 1))
  (define exponentials (filter exponential-power? shared))
  (define powers
    (if (ormap divided? core) (filter (lambda (p) (heavy-power? (car p) (cdr p))) shared) shared))
  (prefer F
          (if (null? exponentials) terms (with-factor F terms sign exponentials))
          (with-factor F terms c powers)
          (if (ormap divided? terms) (in-one-fraction F terms) terms)))

(define (with-factor F terms c powers)
  (list (times-sum F c powers
                   (multiply-terms (scale-terms (/ 1 c) terms) (invert-powers powers)))))

(define (in-one-fraction F terms)
  (define-values (c powers core) (extract-content terms))
  (list (times-sum F c powers core)))

(define (times-sum F c powers terms)
  (make-term c (cons (cons (sum-kernel F terms) 1) powers)))

;; ---------------------------------------------------------------------------
;; Forms

(define (terms-form F terms)
  (sum-form (for/list ([t (in-list (in-order terms))])
              (term-form t (field-inexact? F)))))

;; A positive constant comes first, what is divided by sums last.
(define (in-order terms)
  (define sorted (term-sort terms))
  (define (constant? t) (and (null? (term-powers t)) (positive? (term-coefficient t))))
  (define (divided-by-sum? t)
    (for/or ([p (in-list (term-powers t))]) (and (negative? (cdr p)) (sum-kernel? (car p)))))
  (append (filter constant? sorted)
          (filter (lambda (t) (not (or (constant? t) (divided-by-sum? t)))) sorted)
          (filter divided-by-sum? sorted)))
