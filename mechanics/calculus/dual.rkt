#lang racket/base
;; Dual numbers: x + x' ε, with ε² = 0, one ε for each application of D.
;;
;; f(x + ε) = f(x) + f'(x) ε, so running f on a dual number yields its
;; derivative as the coefficient of ε.  When derivatives nest, the ε of the inner
;; one must not be taken for that of the outer (perturbation confusion, Siskind
;; and Pearlmutter 2005): every ε carries a tag of its own (perturbed-value.rkt).

(require "perturbed-value.rkt" "partial-derivatives.rkt"
         "../algebra/expression/expression.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/kind.rkt")

(provide dual? dual-tag dual-tangent perturb
         make-dual primal-part tangent-part constant?)

(define kind:dual
  (make-kind #:rank rank:dual
             #:describe describe-perturbed
             #:datum (lambda (d) (value->datum (dual-primal d)))
             #:unary dual-unary
             #:binary dual-binary
             #:comparand dual-primal
             #:same? (lambda (same? a b)
                       (and (eqv? (dual-tag a) (dual-tag b))
                            (same? (dual-primal a) (dual-primal b))
                            (same? (dual-tangent a) (dual-tangent b))))
             #:parts
             (parts (lambda (d) (dual-primal d))
                    (lambda (f d) (make-dual (dual-tag d) (f (dual-primal d)) (f (dual-tangent d))))
                    (lambda (tag f d)
                      (g:+ (f (dual-primal d)) (g:* (f (dual-tangent d)) (dual tag 0 1)))))))

(define (dual tag primal tangent) (carrier kind:dual tag primal tangent #f))
(define (dual? x) (and (carrier? x) (eq? (carrier-kind x) kind:dual)))
(define (dual-tag d) (carrier-tag d))
(define (dual-primal d) (carrier-first d))
(define (dual-tangent d) (carrier-second d))

;; x + ε
(define (perturb tag x) (make-dual tag x 1))

(define (make-dual tag primal tangent)
  (if (eqv? tangent 0) primal (dual tag primal tangent)))

;; The parts of x with respect to a tag not less than any in x.
(define (primal-part x tag)
  (if (carries? x tag) (dual-primal x) x))
(define (tangent-part x tag)
  (if (carries? x tag) (dual-tangent x) 0))

(define (carries? x tag) (and (dual? x) (eqv? (dual-tag x) tag)))

;; ---------------------------------------------------------------------------
;; Arithmetic: the chain rule

(define (dual-unary op d)
  (define-values (value slope) (value-and-slope op (dual-primal d)))
  (varying (dual-tag d) value (times slope (dual-tangent d))))

;; Where the outermost ε is not a dual number's, its own arithmetic decides.
(define (dual-binary op a b)
  (define owner (outermost a b))
  (if (dual? owner)
      (combine op a b (dual-tag owner))
      ((kind-binary (kind-of owner)) op a b)))

(define (combine op a b tag)
  (define x (primal-part a tag))
  (define y (primal-part b tag))
  (define value ((generic-op-procedure op) x y))
  (define partials (generic-op-partials op))
  (define by-first (and (carries? a tag) ((car partials) x y value)))
  (define by-second (and (carries? b tag) ((cadr partials) x y value)))
  (cond [(and by-first by-second)
         (varying tag value (g:+ (g:* by-first (dual-tangent a)) (g:* by-second (dual-tangent b))))]
        [(constant? by-first by-second x y) value]
        [by-first (varying tag value (g:* by-first (dual-tangent a)))]
        [else (varying tag value (g:* by-second (dual-tangent b)))]))

;; A quantity that varies though its first derivative vanishes, as x² at 0, keeps its ε: its
;; square root has no derivative, while the square root of a constant 0 has the derivative 0.
;; Expressions are taken at a generic point, where only a constant has a vanishing derivative.
(define (varying tag value tangent)
  (if (and (eqv? tangent 0) (symbolic? value)) value (dual tag value tangent)))

;; Where one argument only varies and the slope by it is 0, the operation does
;; not depend on it, as 0 x, 1ˣ or x⁰ do not; except that a power xⁿ does at 0.
(define (constant? by-first by-second x y)
  (if by-first
      (and (eqv? by-first 0) (not (and (eqv? x 0) (not (eqv? y 0)))))
      (eqv? by-second 0)))
