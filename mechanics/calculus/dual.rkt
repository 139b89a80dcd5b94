#lang racket/base
;; Dual numbers: x + x' ε, with ε² = 0, one ε for each application of D.
;;
;; f(x + ε) = f(x) + f'(x) ε, so running f on a dual number yields its
;; derivative as the coefficient of ε.  When derivatives nest, the ε of the inner
;; one must not be taken for that of the outer (perturbation confusion, Siskind
;; and Pearlmutter 2005): every ε carries a tag of its own (perturbed.rkt).

(require "perturbed.rkt"
         "../generic/kind.rkt" "../generic/describe.rkt" "../generic/arithmetic.rkt")

(provide dual? dual-tag dual-tangent perturb
         make-dual primal-part tangent-part)

(define kind:dual
  (make-kind #:rank rank:dual
             #:describe (lambda (d) (string-append (describe (innermost d)) " being differentiated"))
             #:datum (lambda (d) (value->datum (dual-primal d)))
             #:unary (lambda (op d) (dual-unary op d))
             #:binary (lambda (op a b) (dual-binary op a b))
             #:comparand (lambda (d) (dual-primal d))))

(struct dual perturbed (primal tangent)
  #:authentic
  #:constructor-name construct-dual
  #:omit-define-syntaxes
  #:property prop:kind kind:dual
  #:property prop:parts
  (parts (lambda (d) (dual-primal d))
         (lambda (f d) (make-dual (dual-tag d) (f (dual-primal d)) (f (dual-tangent d))))
         (lambda (tag f d) (g:+ (f (dual-primal d)) (g:* (f (dual-tangent d)) (dual tag 0 1))))))

(define (dual tag primal tangent) (construct-dual kind:dual tag primal tangent))
(define (dual-tag d) (perturbed-tag d))

;; x + ε
(define (perturb tag x) (make-dual tag x 1))

(define (make-dual tag primal tangent)
  (if (eqv? tangent 0) primal (dual tag primal tangent)))

;; The parts of x with respect to a tag not less than any in x.
(define (primal-part x tag)
  (if (and (dual? x) (eqv? (dual-tag x) tag)) (dual-primal x) x))
(define (tangent-part x tag)
  (if (and (dual? x) (eqv? (dual-tag x) tag)) (dual-tangent x) 0))

;; ---------------------------------------------------------------------------
;; Arithmetic: the chain rule

(define (dual-unary op d)
  (define x (dual-primal d))
  (define value ((generic-op-procedure op) x))
  (define slope ((car (generic-op-partials op)) x value))
  (make-dual (dual-tag d) value (g:* slope (dual-tangent d))))

;; Where the outermost ε is not a dual number's, its own arithmetic decides.
(define (dual-binary op a b)
  (define owner (outermost a b))
  (if (dual? owner)
      (combine op a b (dual-tag owner))
      ((kind-binary (kind-of owner)) op a b)))

(define (combine op a b tag)
  (define x (primal-part a tag))
  (define y (primal-part b tag))
  (define dx (tangent-part a tag))
  (define dy (tangent-part b tag))
  (define value ((generic-op-procedure op) x y))
  (define-values (by-first by-second)
    (let ([partials (generic-op-partials op)])
      (values (car partials) (cadr partials))))
  (make-dual tag value
             (g:+ (if (eqv? dx 0) 0 (g:* (by-first x y value) dx))
                  (if (eqv? dy 0) 0 (g:* (by-second x y value) dy)))))
