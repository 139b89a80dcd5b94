#lang racket/base
;; What makes a residual vanish: factor × core, and equations for parameters.
;;
;; Every factor of the numerator is not zero at a generic point; the *core* is
;; the one that can vanish by a choice of parameters: a relation between
;; parameters alone, if there is one, else the largest factor.  Under assumptions,
;; what has a sign cannot vanish.
;;
;; A core that moves, with a time t say, vanishes at all times if its coefficients
;; along sin ωt, cos ωt, t ... do: each may give an equation.

(require racket/list
         "../expression/expression.rkt" "../expression/operation.rkt" "../expression/read.rkt"
         "../expression/size.rkt" "../expression/substitute.rkt" "../expression/symbols.rkt"
         "../field/field.rkt"
         "../kernel/kernel.rkt"
         "../polynomial/factor.rkt" "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt"
         "../presentation/present.rkt"
         "../simplify/simplify-expression.rkt")

(provide factor-and-core)

;; variables : symbols that are no parameters
;; may-vanish? : expression -> boolean
;; -> factor core conditions: the value is factor · core; conditions are equations
;; (= expression expression), as data, which together make the core 0; there may be
;; none.
(define (factor-and-core F f variables may-vanish?)
  (define (parameter? e) (constant-expression? e variables))
  (define candidates (vanishing-factors F (fraction-numerator f) may-vanish?))
  (define core (choose-core F candidates parameter?))
  (cond [core
         (define-values (factor p)
           (with-flonums-in-core
            F f (presentable-sign F (fraction-from-poly (field-ring F) core))))
         (values (present F factor)
                 (present F p)
                 (conditions F core parameter? may-vanish?))]
        [else (values (present F f) 1 '())]))

;; -> f/p and p, or multiples of them with the product f.  A flonum is a whole number
;; over a power of 2, which the parts of f do not show: where there are flonums, their
;; common content goes to the core, which gives its terms the numbers they have in f.
(define (with-flonums-in-core F f p)
  (define R (field-ring F))
  (define factor (fraction/ R f p))
  (define content (poly-content (fraction-numerator factor)))
  (if (field-inexact? F)
      (values (fraction-scale R (/ 1 content) factor) (fraction-scale R content p))
      (values factor p)))

;; Factors of p with several terms that may be zero: its parts as they are found at once, then
;; what these can be factored into; parts with too many terms are not.
(define (vanishing-factors F p may-vanish?)
  (define R (field-ring F))
  (define (may-be? g)
    (and (> (poly-term-count g) 1) (may-vanish? (present F (fraction-from-poly R g)))))
  (define parts (filter may-be? (map power-base (poly-parts R p))))
  (append parts
          (for*/list ([g (in-list parts)]
                      #:when (<= (poly-term-count g) most-terms)
                      [h (in-list (map power-base (poly-factor R g)))]
                      #:unless (equal? g h)
                      #:when (may-be? h))
            h)))

(define most-terms 60)

;; Is it made of symbols that are no variables?
(define (constant-expression? e variables)
  (node-fold e
             (lambda (leaf) (not (memq leaf variables)))
             (lambda (n constant?s) (and (operation? (node-head n)) (andmap values constant?s)))))

(define (kernel-at F i) (kernel-expression (vector-ref (field-kernels F) i)))

;; The polynomial or its negative, whichever has its first term positive.
(define (presentable-sign F p)
  (if (negative? (car (car (linear-terms F p))))
      (fraction-negate (field-ring F) p)
      p))

;; The first that is a relation between symbols, or between parameters, else the
;; one with most terms; #f of none.
(define (choose-core F candidates parameter?)
  (define (related? kind?) (lambda (p) (and (all-kernels? F p kind?) (relation-for F p) p)))
  (or (ormap (related? (lambda (e) (and (symbol? e) (parameter? e)))) candidates)
      (ormap (related? parameter?) candidates)
      (for/fold ([best #f]) ([p (in-list candidates)])
        (if (and best (>= (poly-term-count best) (poly-term-count p))) best p))))

(define (all-kernels? F p kind?)
  (for/and ([i (in-list (poly-variables (field-ring F) p))]) (kind? (kernel-at F i))))

;; ---------------------------------------------------------------------------
;; Conditions

;; More equations than these tell nobody anything.
(define equation-limit 3)

(define (conditions F p parameter? may-vanish?)
  (define coefficients (moving-coefficients F p parameter?))
  (define equations
    (for/list ([c (in-list coefficients)]) (condition F c parameter? may-vanish?)))
  (define found (remove-duplicates (filter values equations)))
  (define (open c) (present F (fraction-from-poly (field-ring F) c)))
  (if (and (<= (length found) equation-limit)
           (for/and ([c (in-list coefficients)] [e (in-list equations)])
             (or e (follows? (open c) found))))
      found
      '()))

;; Does an expression vanish where the equations that give symbols hold?
(define (follows? e equations)
  (define values-of-symbols
    (for/list ([q (in-list equations)] #:when (symbol? (cadr q)))
      (cons (cadr q) (datum->expression (caddr q)))))
  (and (pair? values-of-symbols)
       (eqv? 0 (simplify-expression (substitute-expression e values-of-symbols)))))

;; An equation that makes a polynomial in parameters vanish, or #f.
(define (condition F p parameter? may-vanish?)
  (define core (choose-core F (vanishing-factors F p may-vanish?) parameter?))
  (and core (relation-for F core)))

;; The coefficients of p, seen as a polynomial in the kernels that are no parameters,
;; short ones first.
(define (moving-coefficients F p parameter?)
  (define R (field-ring F))
  (define (moving? power) (not (parameter? (kernel-at F (power-base power)))))
  (define groups (make-hash))
  (define keys
    (for/fold ([keys '()] #:result (reverse keys)) ([t (in-list (poly-terms R p))])
      (define key (filter moving? (poly-term-powers t)))
      (define resting (filter-not moving? (poly-term-powers t)))
      (define known (hash-ref groups key '()))
      (hash-set! groups key (cons (term->poly R (poly-term-coefficient t) resting) known))
      (if (null? known) (cons key keys) keys)))
  (sort (for/list ([key (in-list keys)]) (poly-sum R (hash-ref groups key)))
        < #:key (lambda (c) (+ (* 100 (poly-term-count c)) (poly-total-degree R c)))))

(define (term->poly R c powers)
  (for/fold ([p (poly-constant R c)]) ([f (in-list powers)])
    (poly* R p (poly-expt R (poly-variable R (power-base f)) (power-exponent f)))))

;; ---------------------------------------------------------------------------
;; Equations

;; p = 0 as the equation that is read most easily, or #f.
(define (relation-for F p)
  (define open (open-symbols F p))
  (define (solve simple? powers) (for/or ([i (in-list open)]) (solve-for F p i simple? powers)))
  (define (first-power? n) (eqv? n 1))
  (define (higher-power? n) (> n 1))
  (or (solve poly-constant? first-power?)
      (and (pair? open)
           (all-kernels? F p symbol?)
           (or (two-sides F p)
               (solve monomial? first-power?)
               (and (mixed-signs? F p) (solve monomial? higher-power?))
               (solve short? first-power?)))))

(define (monomial? p) (eqv? (poly-term-count p) 1))
(define (short? p) (<= (poly-term-count p) 4))

(define (mixed-signs? F p)
  (define coefficients (map poly-term-coefficient (poly-terms (field-ring F) p)))
  (and (ormap positive? coefficients) (ormap negative? coefficients)))

;; Kernels of p that are symbols standing in no other kernel of it.
(define (open-symbols F p)
  (define is (poly-variables (field-ring F) p))
  (define (elsewhere? s)
    (for/or ([i (in-list is)])
      (define e (kernel-at F i))
      (and (node? e) (not (constant-expression? e (list s))))))
  (for/list ([i (in-list is)]
             #:when (and (free-symbol? (kernel-at F i)) (not (elsewhere? (kernel-at F i)))))
    i))

;; p solved for a power of variable i, if no other power of it occurs and its
;; coefficient is simple.
(define (solve-for F p i simple? power?)
  (define R (field-ring F))
  (define slices (poly-coefficients R p i))
  (define n (slice-degree (car slices)))
  (define c (slice-coefficient (car slices)))
  (define lower (cdr slices))
  (and (power? n)
       (simple? c)
       (or (null? lower) (eqv? (slice-degree (car lower)) 0))
       (let ([rest (if (null? lower) (poly-constant R 0) (slice-coefficient (car lower)))])
         (equation (e:expt (kernel-at F i) n)
                   (present F (fraction/ R
                                         (fraction-from-poly R (poly-negate R rest))
                                         (fraction-from-poly R c)))))))

;; A difference of two terms as an equation between them, the shorter one and what
;; is no number on the left.
(define (two-sides F p)
  (define R (field-ring F))
  (define terms (poly-terms R p))
  (and (mixed-signs? F p)
       (null? (cddr terms))
       (let ([sides (for/list ([t (in-list terms)])
                      (define size (abs (poly-term-coefficient t)))
                      (present F (fraction-from-poly R
                                   (term->poly R size (poly-term-powers t)))))])
         (if (left-before? (car sides) (cadr sides))
             (equation (car sides) (cadr sides))
             (equation (cadr sides) (car sides))))))

(define (left-before? a b)
  (and (not (number? a))
       (or (number? b) (<= (expression-size a) (expression-size b)))))

(define (equation left right) (list '= (expression->datum left) (expression->datum right)))
