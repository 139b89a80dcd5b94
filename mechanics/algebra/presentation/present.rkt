#lang racket/base
;; From the canonical value back to a form that a physicist would write.
;;
;; The value is a reduced fraction of polynomials in kernels.  Presentation
;; chooses among equal forms of it, and never changes the value:
;;
;; - sin² or cos², angles contracted or not, multiple or not: whichever is shorter;
;; - a fraction is split over the terms of its numerator, or kept whole;
;; - a sum is grouped by factors that its terms share (condense.rkt).
;;
;; The first form named is kept unless another is smaller by a sixth.  The
;; choice depends on the value and the order of kernels alone.

(require racket/list
         "choice-of-angles.rkt" "condense.rkt" "form.rkt" "fraction-pieces.rkt" "term.rkt"
         "../expression/exact-numbers.rkt"
         "../field/field.rkt" "../field/rationalize.rkt"
         "../kernel/exponentials.rkt"
         "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt")

(provide present present-poly poly->terms linear-terms)

;; Much may be multiplied out that was not before.
(define (present F f) (with-room F f present-here))

(define (present-poly F p) (present F (fraction-from-poly (field-ring F) p)))

(define (present-here F f)
  (cond [(fraction-number f) => (lambda (c) (present-number c (field-inexact? F)))]
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
  (if (or (eq? whole by-roots)
          (fraction-polynomial? f)
          (> (term-count whole) (* 2 (term-count by-roots))))
      by-roots-alone
      (smaller-form by-roots-alone (present-pieces F whole))))

(define (term-count pieces)
  (for/sum ([p (in-list pieces)]) (poly-term-count (piece-numerator p))))

;; The value as a linear combination: ((number . expression) ...), in the order
;; of its terms.  These are products of kernels, whatever shorter forms their sum may
;; have: 2 cos²a - 1 and 2 cos²a have a term in common.
(define (linear-terms F f)
  (define p (fraction->piece F f))
  (define below (divisor-powers F p))
  (for/list ([t (in-list (term-sort (piece-terms F p summands)))])
    (cons (present-number (* (term-coefficient below) (term-coefficient t)) (field-inexact? F))
          (form-expression
           (term-form (term 1 (multiply-powers (term-powers t) (term-powers below))) #f)))))

;; ---------------------------------------------------------------------------
;; Pieces as terms

;; write : as spell does, or summands, which leave angles as they are
(define (poly->terms F p [write spell])
  (for/list ([t (in-list (write F p))]) (make-term (car t) (cdr t))))

(define (piece-terms F p [write spell])
  (define terms
    (multiply-terms (poly->terms F (piece-numerator p) write) (collect-powers (piece-powers p))))
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
          (append*
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
          (multiply-powers (term-powers product) (raise-powers (term-powers below) (- (cdr h)))))))

(define (mostly-negative? terms)
  (define (negative t) (negative? (term-coefficient t)))
  (define surplus (for/sum ([t (in-list terms)]) (if (negative t) 1 -1)))
  (or (positive? surplus)
      (and (eqv? surplus 0) (negative (car (term-sort terms))))))
