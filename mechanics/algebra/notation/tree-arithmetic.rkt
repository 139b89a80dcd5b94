#lang racket/base
;; Sums, products, quotients and powers of trees, as a physicist writes them: minus signs are
;; drawn to the front, factors stand in the order numbers, constants, variables, sums,
;; functions, negative exponents become denominators, and parentheses are where they must be.

(require racket/list
         "name.rkt" "numeral.rkt" "tree.rkt"
         "../expression/pi.rkt")

(provide sum-of difference-of product-of quotient-of power-of as-function as-operand)

;; ---------------------------------------------------------------------------
;; Sums

(define (sum-of trees)
  (define terms (append-map terms-of trees))
  (cond [(null? terms) (digits "0")]
        [(and (null? (cdr terms)) (not (term-negative? (car terms)))) (term-body (car terms))]
        [else (sum terms)]))

(define (terms-of t)
  (cond [(sum? t) (sum-terms t)]
        [else (list (term #f (if (relation? t) (parenthesized t) t)))]))

(define (difference-of first rest)
  (sum-of (cons first (map negated rest))))

;; ---------------------------------------------------------------------------
;; Products

;; commuting? : may factors change places?
(define (product-of trees commuting?)
  (define-values (negative? factors) (signs-apart trees))
  (define flat (append-map factors-of factors))
  (define t (if commuting?
                (over-denominators (ordered flat))
                (plain-product flat)))
  (if negative? (negated t) t))

;; An odd number of minus signs, and the factors without.
(define (signs-apart trees)
  (for/fold ([negative? #f] [factors '()] #:result (values negative? (reverse factors)))
            ([t (in-list trees)])
    (define body (negative-body t))
    (values (if body (not negative?) negative?) (cons (or body t) factors))))

(define (factors-of t) (if (product? t) (product-factors t) (list t)))

;; Reciprocals among the factors make a quotient of the product.
(define (over-denominators factors)
  (define-values (below above) (partition reciprocal? factors))
  (if (null? below)
      (plain-product above)
      (quotient-of (plain-product above)
                   (product-of (map fraction-denominator below) #t))))

(define (ordered factors) (sort factors < #:key place #:cache-keys? #t))

(define (reciprocal? t)
  (and (fraction? t) (one? (fraction-numerator t)) (not (digits? (fraction-denominator t)))))

(define (one? t) (equal? t (digits "1")))

(define (plain-product factors)
  (define needed (filter-not one? factors))
  (cond [(null? needed) (digits "1")]
        [(null? (cdr needed)) (car needed)]
        [else (product (closed (cons (as-factor (car needed))
                                     (for/list ([f (in-list (cdr needed))])
                                       (if (begins-with-digit? f)
                                           (parenthesized f)
                                           (as-factor f))))))]))

;; Before a factor that it would seem to hold, too, a function has parentheses: sin(x) f(x),
;; but sin x cos y.
(define (closed factors)
  (for/list ([f (in-list factors)] [next (in-list (append (cdr factors) '(#f)))])
    (if (and next (bare? f) (not (known-power? next)))
        (struct-copy application f [bare? #f])
        f)))

(define (as-factor t)
  (if (or (sum? t) (relation? t)) (parenthesized t) t))

;; Beside another factor, 2 3 would read as 23.
(define (begins-with-digit? t)
  (or (digits? t) (scientific? t) (imaginary? t) (numeric-fraction? t)
      (and (power? t) (begins-with-digit? (power-base t)))))

(define (numeric-fraction? t)
  (and (fraction? t) (digits? (fraction-numerator t)) (digits? (fraction-denominator t))))

;; The rank of a factor among others.
(define (place t)
  (cond [(power? t) (max 1 (place (power-base t)))]
        [(radical? t) (max 1 (place (radical-body t)))]
        [(parenthesized? t) (place (parenthesized-body t))]
        [(dotted? t) 5]
        [(or (begins-with-digit? t) (word? t)) 0]
        [(name? t) (if (pi-symbol? (name-symbol t)) 1 2)]
        [(product? t) (apply max (map place (product-factors t)))]
        [(or (sum? t) (fraction? t) (bars? t)) 4]
        [(bare? t) 6]
        [(or (application? t) (derivative? t) (exponential? t)) 5]
        [else 7]))

(define (bare? t) (and (application? t) (application-bare? t)))

;; ---------------------------------------------------------------------------
;; Quotients

(define (quotient-of above below)
  (define-values (negative? parts) (signs-apart (list above below)))
  (define t (quotient-of-positives (without-parentheses (car parts))
                                   (without-parentheses (cadr parts))))
  (if negative? (negated t) t))

;; Above and below a bar none are needed.
(define (without-parentheses t) (if (parenthesized? t) (parenthesized-body t) t))

;; A rational coefficient above is parted: (1/2 a)/b is a/(2 b).
(define (quotient-of-positives above below)
  (if (and (whole? above) (whole? below) (not (equal? below (digits "0"))))
      (number->tree (/ (whole above) (whole below)))
      (proper-quotient above below)))

(define (proper-quotient above below)
  (define factors (factors-of above))
  (define coefficient (car factors))
  (if (and (numeric-fraction? coefficient) (not (digits? below)))
      (fraction (plain-product (cons (fraction-numerator coefficient) (cdr factors)))
                (plain-product (cons (fraction-denominator coefficient) (factors-of below))))
      (fraction above below)))

;; ---------------------------------------------------------------------------
;; Powers

(define (power-of base exponent)
  (define body (negative-body exponent))
  (cond [body (quotient-of (digits "1") (if (one? body) base (power-of base body)))]
        [(numeric-fraction? exponent) (power-of base (slashed exponent))]
        [(and (known-function? base) (whole? exponent))
         (application (power (application-function base) exponent)
                      (application-arguments base) (application-bare? base))]
        [else (power (as-base base) exponent)]))

;; sin x, whose square is sin² x
(define (known-function? t) (and (application? t) (word? (application-function t))))
(define (known-power? t)
  (or (known-function? t)
      (and (application? t) (power? (application-function t))
           (word? (power-base (application-function t))))))

;; A fraction on one line, for exponents.
(define (slashed t)
  (digits (string-append (digits-text (fraction-numerator t)) "/"
                         (digits-text (fraction-denominator t)))))

(define (whole? t) (and (digits? t) (regexp-match? #rx"^[0-9]+$" (digits-text t))))
(define (whole t) (string->number (digits-text t)))

(define (as-base t)
  (if (or (sum? t) (product? t) (fraction? t) (power? t) (radical? t) (exponential? t)
          (scientific? t) (imaginary? t) (relation? t) (derivative? t)
          (bare? t)
          (and (application? t) (or (power? (application-function t))
                                    (derivative? (application-function t))))
          (and (name? t) (raised? t))
          (and (dotted? t) (raised? (dotted-base t))))
      (parenthesized t)
      t))

;; Has the name a superscript?
(define (raised? t)
  (pair? (superscripts (name-parts (name-symbol t)))))

;; ---------------------------------------------------------------------------

;; t as the function of an application, in parentheses if it needs them.
(define (as-function t)
  (if (or (name? t) (word? t) (derivative? t) (dotted? t) (parenthesized? t) (plain? t)
          (and (application? t) (not (application-bare? t))))
      t
      (parenthesized t)))

;; t as the operand of a derivative: Df(a) is the derivative of f, at a.
(define (as-operand t) (if (application? t) (parenthesized t) (as-function t)))
