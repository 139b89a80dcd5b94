#lang racket/base
;; Dual numbers: x + x' ε, with ε² = 0, one ε for each application of D.
;;
;; f(x + ε) = f(x) + f'(x) ε, so running f on a dual number yields its
;; derivative as the coefficient of ε.  When derivatives nest, the ε of the inner
;; one must not be taken for that of the outer (perturbation confusion, Siskind
;; and Pearlmutter 2005): every ε carries a tag of its own.
;;
;; The value of f may be a function, run only later, when its argument may carry
;; the very ε that is to be extracted from its value: the derivative of
;; x ↦ (y ↦ ...) applied to itself, say (Manzyuk et al., arXiv:1211.4892).
;; Extraction therefore renames that ε in the arguments for as long as the
;; function runs.  To rename within a function is to rename in its values, after
;; shielding its arguments in the same way.
;;
;; The tag of greatest number is outermost; the parts of a dual number contain
;; only lesser tags.

(require "../generic/kind.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/arithmetic.rkt" "../value/operator.rkt"
         "../algebra/expression.rkt")

(provide dual? dual-tag fresh-tag perturb
         make-dual primal-part tangent-part greatest-tag
         extract-tangent)

(define kind:dual
  (make-kind #:rank rank:dual
             #:describe (lambda (d) (string-append (describe (innermost d)) " being differentiated"))
             #:datum (lambda (d) (value->datum (dual-primal d)))
             #:unary (lambda (op d) (dual-unary op d))
             #:binary (lambda (op a b) (dual-binary op a b))
             #:comparand (lambda (d) (dual-primal d))))

(struct dual (tag primal tangent)
  #:authentic
  #:property prop:kind kind:dual
  #:property prop:custom-print-quotable 'never
  #:property prop:custom-write (lambda (d port mode) (write-value d port)))

(define counter (box 0))

(define (fresh-tag)
  (define n (unbox counter))
  (if (box-cas! counter n (add1 n)) n (fresh-tag)))

;; What stands in the place of x + x' ε when no derivative is taken.
(define (innermost x) (if (dual? x) (innermost (dual-primal x)) x))

;; x + ε
(define (perturb tag x) (make-dual tag x 1))

(define (make-dual tag primal tangent)
  (if (eqv? tangent 0) primal (dual tag primal tangent)))

;; The parts of x with respect to a tag not less than any in x.
(define (primal-part x tag)
  (if (and (dual? x) (eqv? (dual-tag x) tag)) (dual-primal x) x))
(define (tangent-part x tag)
  (if (and (dual? x) (eqv? (dual-tag x) tag)) (dual-tangent x) 0))

(define (greatest-tag a b)
  (cond [(not (dual? a)) (dual-tag b)]
        [(not (dual? b)) (dual-tag a)]
        [else (max (dual-tag a) (dual-tag b))]))

;; ---------------------------------------------------------------------------
;; Arithmetic: the chain rule

(define (dual-unary op d)
  (define x (dual-primal d))
  (define value ((generic-op-procedure op) x))
  (define slope ((car (generic-op-partials op)) x value))
  (make-dual (dual-tag d) value (g:* slope (dual-tangent d))))

(define (dual-binary op a b)
  (define tag (greatest-tag a b))
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

;; ---------------------------------------------------------------------------
;; Extraction

;; The coefficient of ε in a value of any shape.
(define (extract-tangent tag x)
  (cond [(dual? x) (extract-from-dual tag x)]
        [(expression? x) 0]
        [else (map-leaves (lambda (leaf) (extract-from-leaf tag leaf)) x)]))

(define (extract-from-leaf tag x)
  (cond [(dual? x) (extract-from-dual tag x)]
        [(expression? x) 0]
        [(procedure? x) (extract-from-function tag x)]
        [else (raise-no-derivative x)]))

(define (extract-from-dual tag d)
  (define t (dual-tag d))
  (cond [(eqv? t tag) (dual-tangent d)]
        [(< t tag) 0]
        [else (make-dual t (extract-tangent tag (dual-primal d))
                         (extract-tangent tag (dual-tangent d)))]))

(define (extract-from-function tag f)
  (shielding tag f
             (lambda (value) (extract-tangent tag value))
             (lambda () (list 'D (value->datum f)))))

(define (raise-no-derivative x)
  (raise
   (exn:fail:contract
    (format "D: the function returned a value that has no derivative: ~a~a"
            (describe-with-value x)
            (if (pair? x) "\n  a list is not a tuple; use (up x y ...)" ""))
    (current-continuation-marks))))

;; ---------------------------------------------------------------------------
;; Renaming

;; x with one ε replaced by another.
(define (rename-tag old new x)
  (cond [(dual? x) (rename-in-dual old new x)]
        [(expression? x) x]
        [(pair? x) (cons (rename-tag old new (car x)) (rename-tag old new (cdr x)))]
        [else (map-leaves (lambda (leaf) (rename-in-leaf old new leaf)) x)]))

(define (rename-in-leaf old new x)
  (cond [(dual? x) (rename-in-dual old new x)]
        [(and (procedure? x) (not (closed? x)))
         (shielding old x
                    (lambda (value) (rename-tag old new value))
                    (lambda () (value->datum x)))]
        [else x]))

(define (rename-in-dual old new d)
  (define t (dual-tag d))
  (define primal (rename-tag old new (dual-primal d)))
  (define tangent (rename-tag old new (dual-tangent d)))
  (g:+ primal (g:* tangent (dual (if (eqv? t old) new t) 0 1))))

(define (closed? f) (and (has-kind? f) (kind-closed? (kind-of f))))

;; `change` after f, on arguments in which another ε stands for this one
;; meanwhile; an operator if f is one.
(define (shielding tag f change make-datum)
  (define (procedure . args)
    (define shield (fresh-tag))
    (define shielded (for/list ([a (in-list args)]) (rename-tag tag shield a)))
    (rename-tag shield tag (change (apply f shielded))))
  (if (operator? f)
      (make-primitive-operator procedure make-datum)
      (make-function procedure (arity-mask f) make-datum)))
