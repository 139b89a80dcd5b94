#lang racket/base
;; Roots by the factors of their radicands: (c^q w)^(1/q) = c w^(1/q).
;;
;; The radicand is factored into primes, square-free polynomials and, where it
;; holds roots or exponentials as factors, the radicands and exponents of these.  Each factor g^e
;; contributes a whole power of g and g^(a/d) in lowest terms; factors with one d are
;; one root, so (4x²y)^(1/4) = √(2x) y^(1/4).
;;
;; A factor taken out, or to a lower root, must not be negative, but for an even
;; power.  The opposite of a factor known to be negative is put in its place, and a
;; minus sign under the root.  Where nothing is known and nothing may be assumed, an
;; even number of factors under an even root is one of |g|.  A power that is not real does not
;; leave its root, nor go to a lower one: √(e^(2it)) is e^(it) or its opposite.

(require racket/list
         "nested-roots.rkt"
         "../assumption/ledger.rkt"
         "../expression/exact-numbers.rkt" "../expression/expression.rkt"
         "../expression/operation.rkt"
         "../field/field.rkt"
         "../kernel/kernel.rkt"
         "../polynomial/factor.rkt" "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt"
         "../presentation/present.rkt" "../presentation/sine-or-cosine.rkt")

(provide split-root fraction-factors fraction-factors/irreducible)

;; all-real? : is all that f holds plainly real?
;; -> outer and ((inner . exponent) ...), expressions and rationals, with
;; f^(1/q) = outer ∏ inner^exponent.
(define (split-root F f q all-real?)
  (define (real? p) (or all-real? (known-real? (field-simplifier F) (present-poly F p))))
  (cond
    [(fraction-zero? f) (values 0 '())]
    [else
     (define R (field-ring F))
     (define-values (given all) (value-parts F f))
     (define-values (number nested factors)
       (if (eqv? q 2) (denest F given all) (values given 1 all)))
     (define-values (roots others) (roots-that-leave F number factors q real?))
     (define-values (joint together apart) (by-joint-sign F others q))
     (define-values (sign signed unknown) (by-signs F apart q real?))
     (define parts (append (number-parts (* sign number) q (field-inexact? F))
                           (raise-powers (append together signed) (/ 1 q))))
     (define-values (outer lower kept) (careful-roots F unknown q real?))
     (define rest (append (filter pair? (map fractional-part parts)) kept))
     (values (e:* joint
                  (e:* nested
                       (e:* (present F (fraction-product R (map whole-part parts))) outer)))
             (append (for/list ([r (in-list roots)]) (lower-root (car r) (/ (cdr r) q)))
                     (if (and (pair? kept)
                              (or (odd? q) (not (andmap real? (map car unknown)))))
                         (list (one-root F rest q))
                         (grouped-roots F rest))
                     lower))]))

;; -> factors that are roots or exponentials, as ((root . integer) ...), and the others.  Beside
;; a negative one √u stays where it is: √(-√u) has a value where u is 0, √-1 u^(1/4) nowhere.
(define (roots-that-leave F number factors q real?)
  (define-values (roots others) (partition-roots F factors real?))
  (if (and (pair? roots) (even? q) (negative-product? F number others))
      (values '() factors)
      (values roots others)))

(define (negative-product? F number factors)
  (define product (fraction-product (field-ring F) (cons (cons number 1) factors)))
  (eqv? -1 (decided-sign (field-simplifier F) (present F product))))

;; Factors that leave the root as a product whose sign is known, as that of x y may be where
;; nothing is known of x and y: -> its sign, these factors, and the others.
(define (by-joint-sign F factors q)
  (define s (field-simplifier F))
  (define (open? g)
    (define e (/ (cdr g) q))
    (and (integer? e) (odd? e) (not (decided-sign s (present-poly F (car g))))))
  (define-values (group others) (partition open? factors))
  (define sign
    (and (> (length group) 1)
         (decided-sign s (present F (fraction-product (field-ring F)
                                                      (for/list ([g (in-list group)])
                                                        (cons (car g) 1)))))))
  (if sign (values sign group others) (values 1 '() factors)))

;; -> the number, the factor taken out of a square root, and the factors that are left
(define (denest F number factors)
  (for/fold ([number number] [outer 1] [left '()] #:result (values number outer (reverse left)))
            ([g (in-list factors)])
    (define d (as-square F (car g)))
    (if d
        (values (* number (expt (square-sign d) (cdr g)))
                (e:* outer (e:expt (square-root d) (cdr g)))
                left)
        (values number outer (cons g left)))))

;; Factors ((polynomial . integer) ...) by their signs, if these matter: -> 1 or -1 and
;; factors that together are those of known signs, and those of unknown sign.
(define (by-signs F factors q real?)
  (for/fold ([sign 1] [known '()] [unknown '()]
             #:result (values sign (reverse known) (reverse unknown)))
            ([g (in-list factors)])
    (define s
      (cond [(sign-matters? (cdr g) q)
             (sign-or-assumed (field-simplifier F) (present-poly F (car g)))]
            [(not (or (memv (cdr g) '(1 -1)) (real? (car g)))) #f]
            [(negative? (cdr g)) (sign-below F (car g))]
            [else 1]))
    (cond [(eqv? s 1) (values sign (cons g known) unknown)]
          [s (values (* sign (expt -1 (cdr g)))
                     (cons (cons (poly-negate (field-ring F) (car g)) (cdr g)) known)
                     unknown)]
          [else (values sign known (cons g unknown))])))

;; Does some of the factor g^n leave the root, wholly or for a lower one?
(define (sign-matters? n q)
  (define e (/ n q))
  (not (or (and (integer? e) (even? e))
           (and (odd? n) (even? (truncate e)) (eqv? q (denominator e))))))

;; 1/√x is √(1/x) unless x is negative.
(define (sign-below F p) (or (decided-sign (field-simplifier F) (present-poly F p)) 1))

;; Factors of unknown sign: -> an expression outside, roots ((inner . exponent) ...),
;; and parts ((polynomial . exponent) ...) to be left under the root with others.
(define (careful-roots F factors q real?)
  (for/fold ([outer 1] [roots '()] [kept '()]) ([g (in-list factors)])
    (define x (present-poly F (car g)))
    (define size (make-node op:abs (list x)))
    (define e (/ (cdr g) q))
    (define k (truncate e))
    (define rest (- e k))
    (cond [(not (real? (car g))) (values outer roots (cons (cons (car g) e) kept))]
          [(even? (/ q (denominator e)))
           (values (e:* outer (e:expt size k))
                   (if (eqv? rest 0) roots (cons (cons size rest) roots))
                   kept)]
          [(even? q) (values (e:* outer (e:expt size k)) roots (cons (cons (car g) rest) kept))]
          [else
           (define even (- k (remainder k 2)))
           (values (e:* outer (e:expt x even)) roots (cons (cons (car g) (- e even)) kept))])))

;; All parts under one root of degree q.
(define (one-root F parts q)
  (cons (present F (fraction-product (field-ring F) (raise-powers parts q))) (/ 1 q)))

;; -> the factors that are roots or exponentials, as ((root . integer) ...), and the others
(define (partition-roots F factors real?)
  (define (root-of g) (and (real? (car g)) (lone-root F (car g))))
  (define-values (roots others) (partition root-of factors))
  (values (for/list ([g (in-list roots)]) (cons (root-of g) (cdr g))) others))

;; (radicand . exponent) for the root raised to the exponent e.
(define (lower-root r e)
  (if (root? r)
      (cons (root-radicand r) (/ e (root-degree r)))
      (cons (make-node op:exp (list (e:* e (exponential-exponent r)))) 1)))

;; The root or exponential that the polynomial is, or #f.
(define (lone-root F p)
  (define variables (poly-variables (field-ring F) p))
  (define r
    (and (null? (cdr p)) (= 1 (length variables))
         (kernel-relation (field-kernel F (car variables)))))
  (and (or (exponential? r)
           (and (root? r) (not (eqv? (root-radicand r) -1))))
       r))

;; ((base . exponent) ...), bases being numbers and polynomials.  A number that
;; came from a flonum is split only if nothing is left, and if it is no mere scale: without
;; its 2⁻⁵⁴, 0.6 - 0.2 y would have integers of 16 digits, exact in looks and rounded in truth.
(define (number-parts x q inexact?)
  (define factors (raise-powers (number-factors (abs x)) (/ 1 q)))
  (define sign (if (negative? x) (list (cons -1 (/ 1 q))) '()))
  (cond [(eqv? x 1) '()]
        [(and inexact? (or (> (denominator x) most-scale)
                           (not (andmap integer? (map cdr factors)))))
         (list (cons x (/ 1 q)))]
        [else (append factors sign)]))

(define most-scale (expt 2 20))

;; Numbers keep a positive exponent below the root, polynomials their sign.
(define (whole-part part)
  (define e (cdr part))
  (cons (car part) (if (number? (car part)) (floor e) (truncate e))))
(define (fractional-part part)
  (define e (- (cdr part) (cdr (whole-part part))))
  (if (eqv? e 0) '() (cons (car part) e)))

;; Parts with fractions for exponents, those of one denominator in one root: its
;; radicand is no power itself, unless it is negative.
(define (grouped-roots F parts)
  (define degrees (remove-duplicates (map denominator (map cdr parts)) eqv?))
  (for/list ([d (in-list degrees)])
    (define group (filter (lambda (p) (eqv? d (denominator (cdr p)))) parts))
    (define signed? (assv -1 group))
    (define common (apply gcd (map numerator (map cdr group))))
    (define sign (if (andmap negative? (map cdr group)) -1 1))
    (define power (if signed? 1 (* sign common)))
    (define inner (raise-powers group (/ d power)))
    (cons (present F (fraction-product (field-ring F) inner)) (/ power d))))

;; -> number and ((polynomial . integer) ...), whose product f is: the parts of
;; numerator and denominator.  In the form with fewest terms 1 - cos² is a square.
(define (value-parts F f)
  (define R (field-ring F))
  (define p (shortest-squares F (fraction-numerator f)))
  (define above (poly-parts R p))
  (define below (fraction-denominator-parts R f))
  (define given (fraction-denominator-factors f))
  (values (/ (* (poly-leading-coefficient p) (product-leading-coefficient below))
             (* (product-leading-coefficient above) (product-leading-coefficient given)))
          (append above (raise-powers below -1))))

;; The fraction as a number and ((expression . integer) ...), factors with a
;; positive leading coefficient.
(define (fraction-factors F f) (show-factors F f (lambda (p) (list (cons p 1)))))

;; The same, factored as far as possible.
(define (fraction-factors/irreducible F f)
  (show-factors F f (lambda (p) (poly-factor (field-ring F) p))))

(define (show-factors F f factor)
  (cond [(fraction-zero? f) (values 0 '())]
        [else
         (define-values (number parts) (value-parts F f))
         (values number
                 (for*/list ([g (in-list parts)] [h (in-list (factor (car g)))])
                   (cons (present-poly F (car h)) (* (cdr g) (cdr h)))))]))
