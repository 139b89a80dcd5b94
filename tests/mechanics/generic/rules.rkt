#lang racket/base
;; Every derivative in every record of an operation, on the domain that stands
;; in the record: against central differences of flonums and of 200-bit numbers,
;; against the symbolic derivative, through D and partial, twice, and off the
;; real line.  A new entry in the table of operations is tested by being there.

(require mechanics/algebra/expression/operation
         mechanics/algebra/expression/expression
         mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/generic/kind
         mechanics/generic/rounding
         mechanics/value/structure
         mechanics/calculus/derivative
         "../support/checks.rkt"
         "../support/bigfloats.rkt" "../support/close.rkt" "../support/random.rkt"
         "../support/evaluate.rkt"
         "../support/same.rkt" "../support/skip.rkt")

(define records (append arithmetic-operations elementary-operations rounding-operations))
(define (arity r) (length (generic-op-partials r)))
(define (title r) (format "~a of ~a" (generic-op-name r) (arity r)))

;; ---------------------------------------------------------------------------
;; Points and rules

(define (random-between interval)
  (+ (car interval) (* (- (cadr interval) (car interval)) (random))))
(define (random-arguments r) (map random-between (generic-op-domain r)))

(define (rule-value r i args)
  (define value (apply (generic-op-procedure r) args))
  (apply (list-ref (generic-op-partials r) i) (append args (list value))))

;; f as a function of its argument i alone.
(define ((along f args i) x)
  (apply f (for/list ([a (in-list args)] [k (in-naturals)]) (if (= k i) x a))))

;; Central differences of fourth order.
(define (difference f x)
  (define h 1e-3)
  (/ (- (* 8 (- (f (+ x h)) (f (- x h)))) (- (f (+ x h h)) (f (- x h h)))) (* 12 h)))

(define-syntax-rule (for-each-rule seed times (r args i) body ...)
  (with-seed seed
    (for* ([_ (in-range times)]
           [args (in-value (random-arguments r))]
           [i (in-range (arity r))])
      (with-check-info (['arguments args] ['by i]) body ...))))

;; ---------------------------------------------------------------------------

(test-case "every operation of the algebra has a record, and every record a domain"
  (check-equal? (for/list ([op (in-list operations)]
                           #:unless (for/or ([r (in-list records)])
                                      (eq? op (generic-op-operation r))))
                  (operation-name op))
                '())
  (for ([r (in-list records)])
    (check-equal? (length (generic-op-domain r)) (arity r) (title r))))

(for ([r (in-list records)])
  (define f (generic-op-procedure r))

  (test-case (format "the derivatives of ~a agree with central differences" (title r))
    (for-each-rule 201 20 (r args i)
      (check-same (rule-value r i args) (difference (along f args i) (list-ref args i)) 1e-9)))

  (test-case (format "value and derivatives of ~a in one call are those of each" (title r))
    (for-each-rule 206 10 (r args i)
      (define at-flonums (generic-op-at-flonums r))
      (when at-flonums
        (define all (call-with-values (lambda () (apply at-flonums args)) list))
        (check-eqv? (car all) (apply f args))
        (check-eqv? (list-ref all (add1 i)) (rule-value r i args)))))

  (test-case (format "D and partial apply the rules of ~a" (title r))
    (for-each-rule 202 10 (r args i)
      (define rule (rule-value r i args))
      (define derivative (apply (D f) args))
      (check-true (same? (if (= (arity r) 1) derivative (s:ref derivative i)) rule))
      (unless (= (arity r) 1)
        (check-true (same? (apply ((partial i) f) args) rule)))))

  (test-case (format "the second derivatives of ~a agree with differences of the first" (title r))
    (for-each-rule 203 10 (r args i)
      (define (slope x) (rule-value r i (for/list ([a (in-list args)] [k (in-naturals)])
                                          (if (= k i) x a))))
      (check-same ((D slope) (list-ref args i)) (difference slope (list-ref args i)) 1e-7))))

;; ---------------------------------------------------------------------------
;; Symbolic derivatives, evaluated

(define symbols '(x y))

(for ([r (in-list records)] #:when (generic-op-operation r))
  (define f (generic-op-procedure r))
  (define unknowns (for/list ([s (in-list symbols)] [_ (in-range (arity r))]) s))
  (test-case (format "the symbolic derivatives of ~a have the values of its rules" (title r))
    (for-each-rule 204 10 (r args i)
      (define derivative
        (if (= (arity r) 1) ((D f) 'x) (apply ((partial i) f) unknowns)))
      (check-pred expression? derivative)
      (check-same (evaluate-expression derivative (point-lookup (map cons unknowns args)))
                  (rule-value r i args)
                  1e-12))))

;; ---------------------------------------------------------------------------
;; Off the real line, where all but the two that depend on it have the same
;; derivatives

(test-case "where an operation leaves the flonums, so do its derivatives in one call"
  (for ([name (in-list '(sqrt log))])
    (define r (findf (lambda (r) (eq? (generic-op-name r) name)) elementary-operations))
    (define f (generic-op-procedure r))
    (define (in-one-call x) (call-with-values (lambda () ((generic-op-at-flonums r) x)) list))
    (check-equal? (in-one-call -2.0) (list (f -2.0) (rule-value r 0 '(-2.0))))
    (check-exn #rx"has no derivative at 0.0" (lambda () (in-one-call 0.0)))))

(for ([r (in-list elementary-operations)]
      #:unless (or (= (arity r) 2) (memq (generic-op-name r) '(abs sgn))))
  (test-case (format "the derivative of ~a holds off the real line" (title r))
    (for-each-rule 205 10 (r args i)
      (define z (make-rectangular (car args) (+ 0.2 (random))))
      (check-same (rule-value r 0 (list z)) (difference (generic-op-procedure r) z) 1e-8))))

;; ---------------------------------------------------------------------------
;; High precision

(define same-in-bigfloats
  '([+ bf+] [- bf-] [* bf*] [/ bf/] [expt bfexpt] [sqrt bfsqrt] [exp bfexp] [log bflog]
    [sin bfsin] [cos bfcos] [tan bftan] [asin bfasin] [acos bfacos] [atan bfatan]
    [sinh bfsinh] [cosh bfcosh] [tanh bftanh] [asinh bfasinh] [acosh bfacosh] [atanh bfatanh]
    [erf bferf] [abs bfabs] [sgn bfsgn] [square bfsqr] [floor bffloor] [ceiling bfceiling]
    [truncate bftruncate] [round bfround]))

(define (in-bigfloats r)
  (case (generic-op-name r)
    [(cube) (lambda (x) ((big 'bf*) x ((big 'bfsqr) x)))]
    [(exact->inexact inexact->exact) values]
    [(atan) (if (= (arity r) 2) (big 'bfatan2) (big 'bfatan))]
    [else (big (cadr (assq (generic-op-name r) same-in-bigfloats)))]))

;; h² f‴/6 and the rounding error divided by h are both below 10⁻³⁵.
(define (big-difference f args i)
  (parameterize ([(big 'bf-precision) 260])
    (define h ((big 'bf) "1e-18"))
    (define big-args (map (big 'bf) args))
    (define (shifted step)
      ((along f big-args i) (step (list-ref big-args i) h)))
    ((big 'bigfloat->flonum)
     ((big 'bf/) ((big 'bf-) (shifted (big 'bf+)) (shifted (big 'bf-)))
                 ((big 'bf*) ((big 'bf) 2) h)))))

(skip-unless bigfloats? no-bigfloats
  (for ([r (in-list records)])
    (test-case (format "the derivatives of ~a are right to the last places" (title r))
      (define f (in-bigfloats r))
      (for-each-rule 206 20 (r args i)
        (check-same (rule-value r i args) (big-difference f args i) 2e-14)))))

;; ---------------------------------------------------------------------------

(test-case "a wrong rule would be seen"
  (check-false (close? (* 1.0001 (cos 1.0)) (difference sin 1.0) 1e-9))
  (skip-unless bigfloats? no-bigfloats
    (check-false (close? (* (+ 1 1e-12) (cos 1.0)) (big-difference (big 'bfsin) '(1.0) 0) 2e-14))))
