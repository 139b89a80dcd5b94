#lang racket/base
;; Claims of `identities` and `integrals` in numbers, by Racket's own functions: nothing
;; of the library is asked.

(require racket/flonum
         racket/list
         racket/math
         (only-in math/special-functions erf))

(provide values-at points-of identity-holds? integral-holds?)

(define (square-root x) (if (< x 0.0) +nan.0 (flsqrt x)))
(define (logarithm x) (if (<= x 0.0) +nan.0 (fllog x)))
(define (within low high f) (lambda (x) (if (<= low x high) (f x) +nan.0)))
(define (asinh x) (* (sgn x) (logarithm (+ (abs x) (square-root (+ (* x x) 1.0))))))

(define operations
  (hasheq '+ + '- - '* * '/ / 'square sqr 'cube (lambda (x) (* x x x))
          'expt (lambda (b n) (if (and (< b 0.0) (not (integer? n))) +nan.0 (expt b n)))
          'sqrt square-root 'exp exp 'log logarithm 'sin sin 'cos cos 'tan tan
          'asin (within -1.0 1.0 asin) 'acos (within -1.0 1.0 acos) 'atan atan
          'sinh sinh 'cosh cosh 'tanh tanh 'asinh asinh
          'acosh (within 1.0 +inf.0 (lambda (x) (logarithm (+ x (square-root (- (* x x) 1.0))))))
          'atanh (within -1.0 1.0 (lambda (x) (* 0.5 (logarithm (/ (+ 1.0 x) (- 1.0 x))))))
          'abs abs 'sgn sgn 'erf erf
          '> > '< <))

;; The value of a datum where the letters are these numbers, or whether a condition holds
(define (values-at datum place)
  (let value ([d datum])
    (cond [(pair? d) (apply (hash-ref operations (car d)) (map value (cdr d)))]
          [(eq? d ':pi) pi]
          [(symbol? d) (hash-ref place d)]
          [else (real->double-flonum d)])))

(define (letters d)
  (cond [(pair? d) (remove-duplicates (append-map letters (cdr d)))]
        [(and (symbol? d) (not (eq? d ':pi))) (list d)]
        [else '()]))

;; Seeded places where the conditions hold
(define (points-of data conditions [count 40])
  (define names (remove-duplicates (append-map letters (append data conditions))))
  (parameterize ([current-pseudo-random-generator (make-pseudo-random-generator)])
    (random-seed 1987)
    (define (place)
      (for/hasheq ([n (in-list names)])
       (values n (* 4.0 (- (random) 0.5) (expt 2.0 (random 2))))))
    (define (good? place) (andmap (lambda (c) (values-at c place)) conditions))
    (for*/list ([_ (in-range (* 50 count))] [p (in-value (place))] #:when (good? p)) p)))

;; -> 'everywhere, 'somewhere-not, or 'never if no place was found where both sides have values
(define (identity-holds? a b conditions)
  (define pairs
    (for*/list ([p (in-list (points-of (list a b) conditions))]
                [x (in-value (values-at a p))] [y (in-value (values-at b p))]
                #:when (and (rational? x) (rational? y)))
      (cons x y)))
  (cond [(null? pairs) 'never]
        [(andmap (lambda (xy) (near? (car xy) (cdr xy) 1e-7)) pairs) 'everywhere]
        [else 'somewhere-not]))

(define (near? x y tolerance) (< (abs (- x y)) (* tolerance (+ 1.0 (abs x) (abs y)))))

;; The same of an integral over the letter x, by the rule of the midpoint
(define (integral-holds? integrand low high value conditions)
  (define (integral p)
    (define-values (a b) (values (values-at low p) (values-at high p)))
    (define h (/ (- b a) steps))
    (* h (for/fold ([s 0.0]) ([k (in-range steps)])
           (+ s (values-at integrand (hash-set p 'x (+ a (* h (+ k 0.5)))))))))
  (define pairs
    (for*/list
     ([p (in-list (take-at-most (points-of (list integrand low high value) conditions) 6))]
                [x (in-value (integral p))] [y (in-value (values-at value p))]
                #:when (and (rational? x) (rational? y)))
      (cons x y)))
  (cond [(null? pairs) 'never]
        [(andmap (lambda (xy) (near? (car xy) (cdr xy) 2e-3)) pairs) 'everywhere]
        [else 'somewhere-not]))

(define steps 2000)
(define (take-at-most xs n) (take xs (min n (length xs))))
