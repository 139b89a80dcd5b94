#lang racket/base
;; Taking a fraction apart so that each part keeps only the denominator it needs.
;;
;; Over a common denominator m ẍ + μ x/r³ is (m ẍ r³ + μ x)/r³, and with r² = u
;; worked out the numerator is long.  The terms of the numerator are grouped by
;; the kernels that the denominator's factor h has nothing to do with; a group
;; divisible by h gives it back, and groups left over the same denominator
;; belong together.
;;
;; For a root r = u^(1/q) the factor is u, counting as r^q: so powers of r,
;; which a reduced numerator cannot hold, come back.

(require racket/list
         "sine-or-cosine.rkt" (only-in "term.rkt" group-in-order)
         "../field/field.rkt"
         "../kernel/kernel.rkt"
         "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt" "../polynomial/ring.rkt"
         "../polynomial/term-list.rkt")

(provide fraction->piece fraction->piece-lists (struct-out piece))

;; numerator · ∏ kernel^exponent / ∏ factor^exponent.  powers : ((kernel .
;; integer) ...), the integers of either sign; factors : ((polynomial .
;; positive) ...), of several terms each.
(struct piece (numerator powers factors) #:authentic)

;; All of the fraction as one piece.
(define (fraction->piece F f)
  (absorb-radicands F (occurring-roots F f) (split-denominator F f)))

;; -> the fraction as one piece, taken apart by its roots alone, and by the factors
;; of its denominator as well; the same list where that makes no difference.
(define (fraction->piece-lists F f)
  (define roots (occurring-roots F f))
  (define whole (list (absorb-radicands F roots (split-denominator F f))))
  (define by-roots
    (for/fold ([pieces whole]) ([r (in-list roots)])
      (split-all F (lambda (p) (split-by-root F r p)) pieces)))
  (define by-factors
    (for/fold ([pieces by-roots]) ([h (in-list (distinct-factors by-roots))])
      (split-all F (lambda (p) (split-by-factor F h p)) pieces)))
  (values whole by-roots by-factors))

(define (split-all F split pieces)
  (define parts (map split pieces))
  (if (andmap whole? pieces parts) pieces (join F (append* parts))))

;; Did splitting leave the piece p as it was?
(define (whole? p parts)
  (and (null? (cdr parts))
       (poly=? (piece-numerator p) (piece-numerator (car parts)))
       (equal? (piece-powers p) (piece-powers (car parts)))))

;; ---------------------------------------------------------------------------
;; The denominator

;; Finding the parts of longer factors would cost more than it is worth.
(define parts-limit 100)

;; -> number and powers of polynomials, their product being the denominator of f: the parts that
;; depend on the value alone, unless the factors it came with have fewer terms; x² - 1, but the
;; distances from two centres apart
(define (denominator-factors F f)
  (define R (field-ring F))
  (define given (fraction-denominator-factors f))
  (define parts
    (if (<= (additions given) parts-limit) (fraction-denominator-parts R f) given))
  (define factors (if (< (additions given) (additions parts)) given parts))
  (values (/ (product-leading-coefficient given) (product-leading-coefficient factors))
          factors))

(define (additions factors)
  (for/sum ([h (in-list factors)]) (- (poly-term-count (power-base h)) 1)))

;; Factors of a single term, sin²θ for 1 - cos²θ among them, become powers.
(define (split-denominator F f)
  (define-values (content factors) (denominator-factors F f))
  (for/fold ([p (piece (poly-scale (field-ring F) (/ 1 content) (fraction-numerator f)) '() '())])
            ([h (in-list factors)])
    (define short (shortest-squares F (power-base h)))
    (if (single-term? short)
        (divide-by-term F p (car short) (power-exponent h))
        (piece (piece-numerator p) (piece-powers p) (cons h (piece-factors p))))))

(define (divide-by-term F p t e)
  (define R (field-ring F))
  (piece (poly-scale R (expt (term-coefficient t) (- e)) (piece-numerator p))
         (for/fold ([powers (piece-powers p)])
                   ([v (in-list (monomial-factors R (term-monomial t)))])
           (add-power powers
                      (field-kernel F (power-base v))
                      (- (* (power-exponent v) e))))
         (piece-factors p)))

;; A root r that occurs, of degree q: r^q = content · radicand / below, with a
;; primitive polynomial of several terms and factors, powers of polynomials.
(struct base (kernel degree content radicand below) #:authentic)

(define (occurring-roots F f)
  (define R (field-ring F))
  (define (occurs? i)
    (or (positive? (poly-degree R (fraction-numerator f) i))
        (for/or ([h (in-list (fraction-denominator-factors f))])
          (positive? (poly-degree R (power-base h) i)))))
  (for*/list ([r (in-list (field-relations F))]
              [k (in-value (field-kernel F (relation-index r)))]
              #:when (and (root? (kernel-relation k)) (occurs? (relation-index r)))
              [p (in-value (fraction-numerator (relation-radicand r)))]
              #:unless (or (poly-zero? p) (single-term? p)))
    (define-values (content primitive) (poly-primitive R p))
    (base k (relation-degree r) content primitive
          (fraction-denominator-factors (relation-radicand r)))))

;; Factors of the denominator that are radicands become powers of their roots.
(define (absorb-radicands F roots p)
  (for/fold ([p p]) ([b (in-list roots)])
    (define h (find-factor p (base-radicand b)))
    (if h
        (multiply-by-base F b (- (power-exponent h))
                          (piece (piece-numerator p) (piece-powers p) (remq h (piece-factors p))))
        p)))

;; The piece times radicand^k, that is (r^q below / content)^k.
(define (multiply-by-base F b k p)
  (define scaled
    (piece (poly-scale (field-ring F) (expt (base-content b) (- k)) (piece-numerator p))
           (add-power (piece-powers p) (base-kernel b) (* k (base-degree b)))
           (piece-factors p)))
  (for/fold ([p scaled]) ([h (in-list (base-below b))])
    (multiply-by-factor F p (power-base h) (* k (power-exponent h)))))

;; The power of h among the factors of a piece, or #f.
(define (find-factor p h)
  (findf (lambda (g) (poly=? (power-base g) h)) (piece-factors p)))

;; The piece times h^k.
(define (multiply-by-factor F p h k)
  (define R (field-ring F))
  (define old (find-factor p h))
  (define left (- (if old (power-exponent old) 0) k))
  (define others (if old (remq old (piece-factors p)) (piece-factors p)))
  (cond [(single-term? h)
         (divide-by-term F p (car h) (- k))]
        [(positive? left)
         (piece (piece-numerator p) (piece-powers p) (cons (make-power h left) others))]
        [else
         (piece (poly* R (piece-numerator p) (poly-expt R h (- left))) (piece-powers p) others)]))

(define (add-power powers k n)
  (define old (assq k powers))
  (define sum (+ n (if old (power-exponent old) 0)))
  (define others (if old (remq old powers) powers))
  (if (eqv? sum 0) others (cons (make-power k sum) others)))

;; ---------------------------------------------------------------------------
;; Splitting

(define (split-by-root F b p)
  (define R (field-ring F))

  (for*/list ([group (in-list (groups F (piece-numerator p) (base-radicand b)))]
              [s (in-list (poly-coefficients R group (kernel-index (base-kernel b))))])
    (define-values (quotient times) (divide-out R (slice-coefficient s) (base-radicand b) #f))
    (multiply-by-base F b times
                      (piece quotient
                             (add-power (piece-powers p) (base-kernel b) (slice-degree s))
                             (piece-factors p)))))

(define (split-by-factor F h p)
  (define R (field-ring F))
  (define factor (find-factor p h))
  (if factor
      (for/list ([group (in-list (groups F (piece-numerator p) h))])
        (define-values (quotient times) (divide-out R group h (power-exponent factor)))
        (define left (- (power-exponent factor) times))
        (define others (remq factor (piece-factors p)))
        (piece quotient
               (piece-powers p)
               (if (eqv? left 0) others (cons (make-power h left) others))))
      (list p)))

;; -> p / h^times and times, the greatest possible, up to limit unless that is #f.
(define (divide-out R p h limit)
  (let loop ([p p] [times 0])
    (define q (and (not (eqv? times limit)) (poly-divide R p h)))
    (if q
        (loop q (+ times 1))
        (values p times))))

;; The terms of p grouped by the part of their monomials that holds none of the
;; variables of h.
(define (groups F p h)
  (define R (field-ring F))
  (define own (poly-variables R h))
  (define outside (monomial-part R (remv* own (range (ring-size R)))))
  (group-in-order (lambda (t) (outside (term-monomial t))) p))

;; ---------------------------------------------------------------------------
;; Joining

;; Pieces over one denominator added.
(define (join F pieces)
  (define R (field-ring F))
  (for/fold ([joined '()] #:result (reverse joined)) ([p (in-list pieces)])
    (define same (findf (lambda (q) (same-denominator? p q)) joined))
    (cond [same
           (for/list ([q (in-list joined)])
             (if (eq? q same)
                 (piece (poly+ R (piece-numerator p) (piece-numerator q))
                        (piece-powers q) (piece-factors q))
                 q))]
          [else (cons p joined)])))

(define (same-denominator? p q)
  (define ((same-power? same-base?) a b)
    (and (eqv? (power-exponent a) (power-exponent b))
         (same-base? (power-base a) (power-base b))))
  (and (same-set? (piece-powers p) (piece-powers q) (same-power? eq?))
       (same-set? (piece-factors p) (piece-factors q) (same-power? poly=?))))

(define (same-set? as bs same?)
  (and (= (length as) (length bs))
       (for/and ([a (in-list as)]) (for/or ([b (in-list bs)]) (same? a b)))))

(define (distinct-factors pieces)
  (remove-duplicates (map power-base (append-map piece-factors pieces)) poly=?))
