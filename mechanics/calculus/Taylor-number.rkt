#lang racket/base
;; Truncated Taylor numbers: x₀ + x₁ε + … + xₙεⁿ, with εⁿ⁺¹ = 0.
;;
;; f(x + ε) = Σ f⁽ᵏ⁾(x) εᵏ/k!, so one run of f on x + ε yields its derivatives up to
;; order n.  An operation costs n² multiplications, where n nested dual numbers
;; take 2ⁿ.  Each is done by the recurrence or the derivative rule in its record,
;; as for power series; here the coefficients are computed at once.
;;
;; A jet carries a tag as dual numbers do, and nests with them: its coefficients
;; are any values that contain lesser tags only.

(require (only-in "dual.rkt" constant?) "perturbed-value.rkt"
         "../algebra/expression/expression.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/kind.rkt"
         "../generic/operation-rule/recurrence.rkt" "../generic/sums-and-products.rkt"
         (only-in "../numeric/finite-number.rkt" lesser) "../numeric/vector-map.rkt"
         "../value/series/coefficients.rkt" "../value/series/series-operation.rkt"
         "../value/series/series.rkt")

(provide jet? jet-order displaced make-jet jet-coefficient jet-derivative jet-value jet-with-tag?)

(define kind:jet
  (make-kind #:rank rank:dual
             #:describe describe-perturbed
             #:datum (lambda (x) (value->datum (jet-coefficient x 0)))
             #:unary jet-unary
             #:binary jet-binary
             #:comparand (lambda (x) (jet-coefficient x 0))
             #:order jet-order
             #:same? (lambda (same? a b)
                       (and (eqv? (perturbed-tag a) (perturbed-tag b))
                            (for/and ([k (in-range (add1 (jet-order a)))])
                              (same? (jet-coefficient a k) (jet-coefficient b k)))))
             #:parts
             (parts (lambda (x) (jet-coefficient x 0))
                    (lambda (f x)
                      (make-jet (perturbed-tag x) (jet-order x) (vector-map f (jet-known x))))
                    (lambda (tag f x) (retag tag f x)))))

;; order : n.  known : a vector of x₀ … xₘ, m ≤ n, of which the last is not 0.
(define (jet tag order known) (carrier kind:jet tag order known #f))
(define (jet? x) (and (carrier? x) (eq? (carrier-kind x) kind:jet)))
(define (jet-order x) (carrier-first x))
(define (jet-known x) (carrier-second x))

;; Exact zeros at the end are dropped; a value left without ε is no jet.
(define (make-jet tag order known)
  (define length (used-length known))
  (if (eqv? length 1) (vector-ref known 0) (jet tag order (vector-start known length))))

(define (used-length known)
  (let loop ([n (vector-length known)])
    (if (and (> n 1) (eqv? (vector-ref known (sub1 n)) 0)) (loop (sub1 n)) n)))

;; A number whose derivatives vanish though it varies, as x⁴ at 0, keeps its ε (dual.rkt says why).
(define (varying tag order known)
  (define length (used-length known))
  (cond [(> length 1) (jet tag order (vector-start known length))]
        [(symbolic? (vector-ref known 0)) (vector-ref known 0)]
        [else (jet tag order (vector (vector-ref known 0) 0))]))

;; x + ε
(define (displaced tag order x) (jet tag order (vector x 1)))

(define (jet-coefficient x k)
  (define known (jet-known x))
  (if (< k (vector-length known)) (vector-ref known k) 0))

(define (jet-with-tag? x tag) (and (jet? x) (eqv? (perturbed-tag x) tag)))

;; The value at ε = 0, for the ε of this tag, not less than any in x.
(define (jet-value x tag)
  (if (jet-with-tag? x tag) (jet-coefficient x 0) x))

;; k! xₖ
(define (jet-derivative x k)
  (g:* (factorial k) (jet-coefficient x k)))

;; Other parts may contain the new ε, so that it takes arithmetic to put together.
(define (retag tag f x)
  (g:for/sum ([part (in-vector (jet-known x))] [k (in-naturals)])
    (define changed (f part))
    (cond [(eqv? k 0) changed]
          [else (g:* changed (make-jet tag (jet-order x) (unit k)))])))

(define (unit k)
  (define v (make-vector (add1 k) 0))
  (vector-set! v k 1)
  v)

(define (vector-start v n)
  (cond [(eqv? n (vector-length v)) v]
        [else (define new (make-vector n))
              (vector-copy! new 0 v 0 n)
              new]))

;; ---------------------------------------------------------------------------
;; Arithmetic

(define (jet-unary op x)
  (define rules (recurrence-of op))
  (define a (jet-known x))
  (define n (jet-order x))
  (define solved (and rules ((recurrence-choose rules) (vector-ref a 0) (vector-length a))))
  (varying (perturbed-tag x) n (if solved (steps op solved a n) (unary-by-rule op a n))))

;; The first derivative is taken by its rule, which may say that there is none.
(define (steps op solved a n)
  (define r (make-vector (add1 n) 0))
  (define a0 (vector-ref a 0))
  (define r0 ((generic-op-procedure op) a0))
  (define step (solution-step solved))
  (define other (solution-partner solved))
  (define p (and other (make-vector (add1 n) 0)))
  (define la (vector-length a))
  (define all (rows (in a la) la #f 0 (in-all r) (and p (in-all p))))
  (vector-set! r 0 r0)
  (vector-set! r 1 (g:* ((car (generic-op-partials op)) a0 r0) (vector-ref a 1)))
  (when p (vector-set! p 0 ((partner-start other) a0 r0)))
  (for ([k (in-range 2 (add1 n))])
    (when p (vector-set! p (sub1 k) ((partner-step other) (sub1 k) all)))
    (vector-set! r k (step k all)))
  r)

;; Where the outermost ε is not a jet's, its own arithmetic decides.
(define (jet-binary op a b)
  (define owner (outermost a b))
  (if (jet? owner)
      (or (reduced op a b) (combine op a b (perturbed-tag owner) (jet-order owner)))
      ((kind-binary (kind-of owner)) op a b)))

(define (combine op x y tag n)
  (define rules (recurrence-of op))
  (define a (known-part x tag))
  (define b (known-part y tag))
  (define la (vector-length a))
  (define lb (vector-length b))
  (define solved
    (and rules ((recurrence-choose rules) (vector-ref a 0) la (vector-ref b 0) lb)))
  (define r
    (if solved
        (steps-2 op (solution-step solved) a la b lb
                 (lesser (add1 n) ((recurrence-length rules) la lb)))
        (binary-by-rule op a b n)))
  (if (and (eqv? (used-length r) 1)
           (independent? op (> la 1) (> lb 1) (vector-ref a 0) (vector-ref b 0) (vector-ref r 0)))
      (vector-ref r 0)
      (varying tag n r)))

;; Does the operation not depend on those of its arguments that vary?
(define (independent? op first-varies? second-varies? x y value)
  (define partials (generic-op-partials op))
  (and (not (and first-varies? second-varies?))
       (constant? (and first-varies? ((car partials) x y value))
                  (and second-varies? ((cadr partials) x y value))
                  x y)))

(define (steps-2 op step a la b lb length)
  (define r (make-vector length 0))
  (define all (rows (in a la) la (in b lb) lb (in-all r) #f))
  (vector-set! r 0 ((generic-op-procedure op) (vector-ref a 0) (vector-ref b 0)))
  (for ([k (in-range 1 length)]) (vector-set! r k (step k all)))
  r)

;; The coefficients of x by the ε of this tag.
(define (known-part x tag)
  (if (jet-with-tag? x tag) (jet-known x) (vector x)))

(define (in v length)
  (lambda (k) (if (< k length) (vector-ref v k) 0)))
(define ((in-all v) k) (vector-ref v k))

;; ---------------------------------------------------------------------------
;; Operations without a recurrence, by their derivative rules as on power series

(define (unary-by-rule op a n)
  (check-slope op car (list (vector-ref a 0)))
  (by-rule (operate-1 op (sequence a) power-series-of coefficients-of) n))

(define (binary-by-rule op a b n)
  (define point (list (vector-ref a 0) (vector-ref b 0)))
  (when (> (vector-length a) 1) (check-slope op car point))
  (when (> (vector-length b) 1) (check-slope op cadr point))
  (by-rule (operate-2 op (sequence a) (sequence b) power-series-of coefficients-of) n))

;; A rule tells that there is no derivative at a point, not of a series.
(define (check-slope op argument point)
  (define value (apply (generic-op-procedure op) point))
  (apply (argument (generic-op-partials op)) (append point (list value))))

(define (sequence v) (coefficients-from (vector->list v)))

(define (by-rule c n)
  (for/vector #:length (add1 n) ([k (in-range (add1 n))]) (coefficient c k)))
