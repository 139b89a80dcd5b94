#lang racket/base
;; Elementary operations: values, exactness, and the derivative rule of every
;; entry, against central differences and against the symbolic derivative.

(require rackunit
         mechanics/generic/arithmetic mechanics/generic/elementary mechanics/generic/kind
         mechanics/value/structure
         mechanics/calculus/derivative
         "../laws/numeric-value.rkt" "../laws/random.rkt" "../laws/same.rkt")

(define operations (append arithmetic-operations elementary-operations))

;; Where the arguments of an operation may lie; (0.2, 0.9) suits all of one
;; argument, and these bear more.
(define (domain name)
  (case name
    [(sin cos sinh cosh tanh) '((-1.4 1.4))]
    [(tan) '((-1.0 1.0))]
    [(abs) '((-2.0 -0.1))]
    [(exp + - *) '((-2.0 2.0) (-2.0 2.0))]
    [(/) '((-2.0 2.0) (0.3 2.0))]
    [(expt) '((0.7 2.0) (-3.0 3.0))]
    [(sqrt log) '((0.2 5.0))]
    [else '((0.2 0.9) (0.2 0.9))]))

(define (random-between range)
  (+ (car range) (* (- (cadr range) (car range)) (random))))

(define (random-arguments op)
  (define ranges
    (let ([r (domain (generic-op-name op))])
      (if (two-arguments? op)
          (if (null? (cdr r)) (list (car r) (car r)) r)
          (list (car r)))))
  (map random-between ranges))

(define (two-arguments? op) (= 2 (length (generic-op-partials op))))
(define (name op) (format "~a of ~a" (generic-op-name op) (length (generic-op-partials op))))

;; Central differences of fourth order.
(define (difference f x)
  (define h 1e-3)
  (/ (- (* 8 (- (f (+ x h)) (f (- x h)))) (- (f (+ x h h)) (f (- x h h)))) (* 12 h)))

;; f as a function of its argument i alone.
(define (along f args i)
  (lambda (x)
    (apply f (for/list ([a (in-list args)] [k (in-naturals)]) (if (= k i) x a)))))

(define (rule-value op i args)
  (define value (apply (generic-op-procedure op) args))
  (apply (list-ref (generic-op-partials op) i) (append args (list value))))

(define-check (check-close actual expected tolerance)
  (with-check-info (['actual actual] ['expected expected])
    (unless (close? actual expected tolerance) (fail-check))))

;; ---------------------------------------------------------------------------
;; Every rule

(for ([op (in-list operations)])
  (test-case (format "the derivative rules of ~a agree with central differences" (name op))
    (with-seed 201
      (for* ([_ (in-range 20)]
             [args (in-value (random-arguments op))]
             [i (in-range (length args))])
        (with-check-info (['arguments args] ['by i])
          (check-close (rule-value op i args)
                       (difference (along (generic-op-procedure op) args i) (list-ref args i))
                       1e-9))))))

(for ([op (in-list operations)])
  (test-case (format "D and partial apply the rules of ~a" (name op))
    (with-seed 202
      (define f (generic-op-procedure op))
      (for ([_ (in-range 10)])
        (define args (random-arguments op))
        (define rules (for/list ([i (in-range (length args))]) (rule-value op i args)))
        (check-true (same? (apply (D f) args)
                           (if (two-arguments? op) (apply down rules) (car rules))))
        (when (two-arguments? op)
          (for ([i (in-range 2)])
            (check-true (same? (apply ((partial i) f) args) (list-ref rules i)))))))))

(for ([op (in-list operations)])
  (test-case (format "the symbolic derivatives of ~a have the right values" (name op))
    ;; symbol-value lies in (0.3, 1.3); asin and acos want less than 1
    (define (f . args) (apply (generic-op-procedure op) (map (lambda (a) (g:* a 2/3)) args)))
    (define symbols (if (two-arguments? op) '(x y) '(x)))
    (define derivatives
      (if (two-arguments? op)
          (list (((partial 0) f) 'x 'y) (((partial 1) f) 'x 'y))
          (list ((D f) 'x))))
    (for* ([point (in-range 1 6)] [i (in-range (length symbols))])
      (define numbers (for/list ([s (in-list symbols)]) (symbol-value s point)))
      (with-check-info (['point point] ['by i] ['derivative (list-ref derivatives i)])
        (check-close (numeric-value (list-ref derivatives i) point)
                     (difference (along f numbers i) (list-ref numbers i))
                     1e-8)))))

(for ([op (in-list elementary-operations)] #:unless (two-arguments? op))
  (test-case (format "the second derivative of ~a agrees with differences of the first" (name op))
    (with-seed 203
      (define f (generic-op-procedure op))
      (for ([_ (in-range 10)])
        (define x (car (random-arguments op)))
        (check-close ((D (D f)) x) (difference (D f) x) 1e-7)))))

;; The rules hold for complex arguments too, abs excepted.
(for ([op (in-list elementary-operations)]
      #:unless (or (two-arguments? op) (eq? (generic-op-name op) 'abs)))
  (test-case (format "the derivative rule of ~a holds off the real line" (name op))
    (with-seed 204
      (define f (generic-op-procedure op))
      (for ([_ (in-range 10)])
        (define z (make-rectangular (car (random-arguments op)) (+ 0.2 (random))))
        (check-close (rule-value op 0 (list z)) (difference f z) 1e-8)))))

(test-case "a wrong rule would be seen"
  (check-false (close? (* 1.0001 (cos 1.0)) (difference sin 1.0) 1e-9)))

(test-case "the list of elementary operations is complete"
  (check-equal? (for/list ([op (in-list elementary-operations)])
                  (list (generic-op-name op) (length (generic-op-partials op))))
                '((sqrt 1) (exp 1) (log 1) (sin 1) (cos 1) (tan 1)
                  (asin 1) (acos 1) (atan 1) (atan 2)
                  (sinh 1) (cosh 1) (tanh 1) (abs 1) (expt 2))))

;; ---------------------------------------------------------------------------
;; Values

(test-case "numbers are computed as Racket computes them"
  (check-equal? (g:sqrt 4) 2)
  (check-equal? (g:sqrt -4) +2i)
  (check-equal? (g:sqrt 2.0) (sqrt 2.0))
  (check-equal? (g:sin 1.0) (sin 1.0))
  (check-equal? (g:atan 1.0 2.0) (atan 1.0 2.0))
  (check-equal? (g:atan 1 -1) (atan 1 -1))
  (check-equal? (g:log 8 2) (/ (log 8) (log 2)))
  (check-equal? (g:expt 2 10) 1024)
  (check-equal? (g:expt 4 1/2) 2))

(test-case "exact arguments with exact values stay exact"
  (check-equal? (map (lambda (f) (f 0)) (list g:sin g:cos g:tan g:exp g:asin g:atan g:sinh g:cosh g:tanh))
                '(0 1 0 1 0 0 0 1 0))
  (check-equal? (g:log 1) 0)
  (check-equal? (g:acos 1) 0)
  (check-equal? (g:abs -1/2) 1/2)
  (check-equal? (g:expt 2/3 -2) 9/4))

(test-case "hyperbolic functions are accurate to a few units in the last place"
  ;; Taylor series summed exactly
  (define (series x first step)
    (define q (inexact->exact x))
    (let loop ([term (expt q first)] [k first] [sum 0])
      (if (> k 60)
          (exact->inexact sum)
          (loop (/ (* term q q) (* (+ k 1) (+ k 2))) (+ k 2) (+ sum term)))))
  (with-seed 205
    (for* ([scale '(1e-8 1e-4 5e-3 0.009999 0.010001 0.1 1.0 4.0)] [_ (in-range 5)])
      (define x (* scale (- (* 2 (random)) 1.0)))
      (check-close (/ (g:sinh x) (series x 1 2)) 1.0 3e-14)
      (check-close (/ (g:cosh x) (series x 0 2)) 1.0 1e-15)
      (check-close (/ (g:tanh x) (/ (series x 1 2) (series x 0 2))) 1.0 3e-14))))

(test-case "hyperbolic functions at the ends of the line"
  (check-equal? (g:tanh 1000.0) 1.0)
  (check-equal? (g:tanh -1000.0) -1.0)
  (check-equal? (g:sinh 1000.0) +inf.0)
  (check-equal? (g:cosh -1000.0) +inf.0)
  (check-eqv? (g:sinh +nan.0) +nan.0)
  (check-eqv? (g:tanh +nan.0) +nan.0))

(test-case "reciprocal functions are made of the others"
  (check-equal? (g:sec 'x) (g:/ 1 (g:cos 'x)))
  (check-equal? (g:csc 'x) (g:/ 1 (g:sin 'x)))
  (check-equal? (g:cot 'x) (g:/ (g:cos 'x) (g:sin 'x)))
  (check-close (g:cot 0.7) (/ (tan 0.7)) 1e-15))

;; ---------------------------------------------------------------------------
;; Points where there is no derivative to give

(test-case "the derivative of abs is the sign, symbolic or not"
  (check-equal? ((D g:abs) -3) -1)
  (check-equal? ((D g:abs) 3.5) 1.0)
  (check-equal? ((D g:abs) 'x) (g:/ 'x (g:abs 'x))))

(test-case "the square root is infinitely steep at 0"
  (check-equal? ((D g:sqrt) 0.0) +inf.0)
  (check-exn exn:fail:contract:divide-by-zero? (lambda () ((D g:sqrt) 0))))
