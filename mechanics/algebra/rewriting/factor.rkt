#lang racket/base
;; A value as a product of powers of irreducible factors.
;;
;; Numerator and divisors of the normal form are factored as polynomials in the
;; kernels.  A circle's (1 - cos θ)(1 + cos θ) is sin²θ again, and a hyperbola's
;; (cosh u - 1)(cosh u + 1) is sinh²u.  Factors have their first term positive;
;; a minus sign that is left goes into a difference if there is one.

(require racket/list
         "together.rkt"
         (only-in "../assumption/assumption-set.rkt" no-assumptions)
         "../expression/expression.rkt" "../expression/operation.rkt"
         "../field/field.rkt"
         "../kernel/kernel.rkt"
         "../polynomial/factor.rkt" "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt"
         "../presentation/form.rkt" "../presentation/fraction-pieces.rkt"
         "../presentation/present.rkt"
         "../presentation/sine-or-cosine.rkt" "../presentation/term.rkt"
         "../simplify/simplify-expression.rkt")

(provide factored-expression)

;; -> expression and assumptions
(define (factored-expression e [A no-assumptions])
  (define-values (F f assumptions) (normal-form e A))
  (values (if (fraction-number f)
              (quotient-expression F f)
              (flatten-products (form-expression (factored-form F f))))
          assumptions))

;; A product in the making: number · ∏ kernel^integer · ∏ polynomial^integer, the
;; polynomials of several terms.
(struct factors (number powers polynomials) #:authentic)

(define (factored-form F f)
  (define p (fraction->piece F f))
  (define start (factors 1 (collect-powers (piece-powers p)) '()))
  (define all
    (for/fold ([product (multiply F start (piece-numerator p) 1)])
              ([h (in-list (piece-factors p))])
      (multiply F product (power-base h) (- (power-exponent h)))))
  (written F (settle-signs F (restore-squares F all))))

;; The product times q^e, q factored.
(define (multiply F product q e)
  (define parts (poly-factor (field-ring F) q))
  (for/fold ([product (scaled product (expt (constant-factor q parts) e))])
            ([h (in-list parts)])
    (define p (power-base h))
    (define k (* e (power-exponent h)))
    (define finer (finer-parts F p))
    (if finer
        (multiply F product finer k)
        (multiply-factor F product p k))))

(define (constant-factor q parts)
  (/ (poly-leading-coefficient q) (product-leading-coefficient parts)))

;; An irreducible polynomial may have factors when cosines are eliminated instead
;; of sines, or here and there one and the other: then such a form of it, else #f.
(define (finer-parts F p)
  (define q (shortest-squares F p))
  (and (not (poly=? p q))
       (let ([parts (poly-factor (field-ring F) q)])
         (or (pair? (cdr parts)) (> (power-exponent (car parts)) 1)))
       q))

(define (scaled product c)
  (struct-copy factors product [number (* c (factors-number product))]))

(define (multiply-factor F product h e)
  (define term (and (eqv? 1 (poly-term-count h)) (car (poly->terms F h summands))))
  (if term
      (struct-copy factors product
        [powers (multiply-powers (factors-powers product) (raise-powers (term-powers term) e))])
      (struct-copy factors product
        [polynomials (append (factors-polynomials product) (list (cons h e)))])))

;; ---------------------------------------------------------------------------
;; Squares of sines

(define (restore-squares F product)
  (for/fold ([product product]) ([k (in-vector (field-kernels F))])
    (define o (kernel-relation k))
    (if (and (circle? o) (eq? k (circle-sine o)))
        (restore-square F product o)
        product)))

;; (c + 1) and (c - 1) to the powers m and n: as often as both occur they make
;; c² - 1, which is -sin² or sinh².
(define (restore-square F product o)
  (define R (field-ring F))
  (define c (poly-variable R (kernel-index (circle-cosine o))))
  (define one (poly-constant R 1))
  (define (find q)
    (findf (lambda (h) (poly=? (car h) q)) (factors-polynomials product)))
  (define above (find (poly+ R c one)))
  (define below (find (poly- R c one)))
  (define shared (if (and above below) (nearer-to-zero (cdr above) (cdr below)) 0))
  (define (lowered h) (if (memq h (list above below)) (cons (car h) (- (cdr h) shared)) h))
  (if (eqv? shared 0)
      product
      (factors (* (factors-number product) (expt (- (circle-sign o)) shared))
               (multiply-powers (factors-powers product) (list (cons (circle-sine o) (* 2 shared))))
               (for*/list ([h (in-list (factors-polynomials product))]
                           [low (in-value (lowered h))]
                           #:unless (eqv? 0 (cdr low)))
                 low))))

;; ---------------------------------------------------------------------------
;; Signs

(define (settle-signs F product)
  (define positive
    (for/fold ([product product]) ([h (in-list (factors-polynomials product))]
                                   #:when (negative? (first-coefficient F (car h))))
      (flip F product h)))
  (define difference
    (and (negative? (factors-number positive))
         (findf (lambda (h) (and (odd? (cdr h)) (mixed? F (car h))))
                (factors-polynomials positive))))
  (if difference (flip F positive difference) positive))

;; The factor replaced by its opposite.
(define (flip F product h)
  (factors (if (odd? (cdr h)) (- (factors-number product)) (factors-number product))
           (factors-powers product)
           (for/list ([g (in-list (factors-polynomials product))])
             (if (eq? g h) (cons (poly-negate (field-ring F) (car g)) (cdr g)) g))))

(define (first-coefficient F p) (caar (terms-as-presented F p)))

(define (mixed? F p) (ormap negative? (map car (terms-as-presented F p))))

;; ---------------------------------------------------------------------------
;; Writing

(define (written F product)
  (define (show p e)
    (define x (present-poly F p))
    (expression->form (if (eqv? 1 e) x (make-node op:expt (list x e)))))
  (define-values (above below)
    (partition (lambda (h) (positive? (cdr h))) (factors-polynomials product)))
  (product-form (factors-number product)
                (factors-powers product)
                (for/list ([h (in-list above)]) (show (car h) (cdr h)))
                (for/list ([h (in-list below)]) (cons (show (car h) 1) (- (cdr h))))
                (field-inexact? F)))
