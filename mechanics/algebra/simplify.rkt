#lang racket/base
;; Simplification: to a canonical value, and from it to a readable expression.
;;
;; The kernels of an expression are found (their arguments simplified first),
;; the expression is evaluated as a fraction of polynomials in them, reduced by
;; the relations among them, and presented.

(require "operation.rkt" "expression.rkt" "datum.rkt" "kernel.rkt" "services.rkt" "collect.rkt" "field.rkt" "walk.rkt"
         "present.rkt" "radicand.rkt" "condition.rkt"
         "polynomial/polynomial.rkt" "polynomial/fraction.rkt")

(provide simplify-expression simplify-expression/assumptions factor-expression
         normal-form)

(define (simplify-expression e)
  (if (node? e)
      ((services-simplify (make-services (make-ledger))) e)
      e))

;; -> the simplified expression and what it takes for granted, as datums such
;; as (>= R 0).
(define (simplify-expression/assumptions e)
  (define ledger (make-ledger))
  (values (if (node? e) ((services-simplify (make-services ledger)) e) e)
          (ledger-assumptions ledger)))

;; The same value as a product: numbers and kernels, common divisors, and last
;; the core, the factor that may vanish.
(define (factor-expression e)
  (define-values (F f assumptions) (normal-form e))
  (cond [(fraction-zero? f) 0]
        [else
         (define-values (factor core condition) (factor-and-core F f))
         (e:* factor core)]))

;; -> the field of the expression's kernels, its value there, the assumptions.
(define (normal-form e)
  (define ledger (make-ledger))
  (define node (if (node? e) e (make-node op:+ (list e))))
  (define-values (F f) (normalize node (make-services ledger)))
  (values F f (ledger-assumptions ledger)))

;; ---------------------------------------------------------------------------
;; The assumptions made so far, each once

(struct ledger (table [list #:mutable]) #:authentic)

(define (make-ledger) (ledger (make-hash) '()))

(define (assume! l expression)
  (unless (hash-ref (ledger-table l) expression #f)
    (hash-set! (ledger-table l) expression #t)
    (set-ledger-list! l (cons expression (ledger-list l)))))

(define (ledger-assumptions l)
  (for/list ([e (in-list (reverse (ledger-list l)))])
    (list '>= (expression->datum e) 0)))

;; ---------------------------------------------------------------------------
;; The services kernels are collected with: everything once a node

(define (make-services ledger)
  (define memo (make-memo))
  (define simple (make-memo))
  (define (normal e)
    (memo e (lambda () (call-with-values (lambda () (normalize e these)) cons))))
  (define (simplify e)
    (if (node? e)
        (simple e (lambda ()
                    (define n (normal e))
                    (present (car n) (cdr n))))
        e))
  (define (terms e)
    (define n (normal (if (node? e) e (make-node op:+ (list e)))))
    (linear-terms (car n) (cdr n)))
  (define (split e degree)
    (define n (normal (if (node? e) e (make-node op:+ (list e)))))
    (split-root (car n) (cdr n) degree (lambda (f) (assume! ledger f))))
  (define (factors e)
    (define n (normal (if (node? e) e (make-node op:+ (list e)))))
    (fraction-factors (car n) (cdr n)))
  (define these (services simplify terms factors split (lambda (f) (assume! ledger f))))
  these)

;; -> the field of the expression's kernels and its value there.  Sums at which
;; the walk gets stuck are left unexpanded; after too many of them, e is.
(define stuck-limit 8)

(define (normalize e services)
  (let retry ([blocked '()])
    (define result
      (with-handlers ([stuck? values])
        (normalize-around e services
                          (if (< (length blocked) stuck-limit) blocked (list e)))))
    (if (stuck? result)
        (retry (append (sums-to-block (stuck-node result) blocked) blocked))
        (values (car result) (cdr result)))))

;; The sums among the factors of the operands of n; n itself if there are none.
(define (sums-to-block n blocked)
  (define (sums e)
    (cond [(or (not (node? e)) (memq e blocked)) '()]
          [(memq (node-head e) (list op:+ op:-)) (list e)]
          [(memq (node-head e) (list op:* op:/ op:expt)) (operand-sums e)]
          [else '()]))
  (define (operand-sums e) (apply append (map sums (node-args e))))
  (define found (operand-sums n))
  (if (null? found) (list n) found))

(define (normalize-around e services blocked)
  (define atlas (collect-kernels e services blocked))
  (define kernels (place-kernels! (atlas-kernels atlas)))
  (let retry ([degree 7])
    (or (with-handlers ([exn:algebra:degree-overflow? (lambda (x) #f)])
          (define F (make-field atlas kernels degree))
          (define f (field-fraction F e))
          (tell-assumptions F services)
          (cons F f))
        (retry (+ 1 (* 2 degree))))))

(define (tell-assumptions F services)
  (for ([p (in-list (unbox (field-assumed F)))])
    ((services-assume! services) (present F (fraction-from-poly (field-ring F) p)))))
