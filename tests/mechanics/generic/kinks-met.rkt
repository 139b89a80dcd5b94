#lang racket/base
;; Notes of derivatives: operations that have kinks, jumps or poles somewhere, where they are
;; differentiated, and before anything is simplified.

(require (except-in mechanics expression format)
         mechanics/generic/operation-rule/kinks-met
         "../support/checks.rkt")

;; Operations that the derivative of f at a symbol meets, as data.
(define (noted f [x 't])
  (define-values (value found) (call-noting-kinks (lambda () ((D f) x))))
  (for/list ([m (in-list found)])
    (read (open-input-string (format "~s" (cons (met-name m) (met-arguments m)))))))

(define-syntax-rule (notes [f operation ...] ...)
  (begin (check-equal? (noted f) '(operation ...) (format "~s" 'f)) ...))

(test-case "each operation that is not smooth everywhere is noted with its arguments"
  (notes [abs (abs t)]
         [sgn (sgn t)]
         [sqrt (sqrt t)]
         [log (log t)]
         [tan (tan t)]
         [asin (asin t)]
         [acos (acos t)]
         [atan (atan t)]
         [acosh (acosh t)]
         [atanh (atanh t)]
         [(lambda (t) (/ 'a t)) (/ a t)]
         [(lambda (t) (expt t 1/3)) (expt t 1/3)]
         [(lambda (t) (expt t -2)) (expt t -2)]
         [(lambda (t) (atan t 'x)) (atan t x)]
         [(lambda (t) (atan 'y t)) (atan y t)]))

(test-case "what is smooth is not"
  (notes [sin] [cos] [exp] [sinh] [cosh] [tanh] [square] [cube]
         [(lambda (t) (expt t 5))] [(lambda (t) (/ t 'a))] [(lambda (t) (- t (* 2 t)))]))

(test-case "what simplification would lose is there"
  (notes [(lambda (t) (/ t t)) (/ t t)]
         [(lambda (t) (sqrt (square t))) (sqrt (* t t))]
         [(lambda (t) (* 0 (sgn t))) (sgn t)]
         [(lambda (t) (atan (tan t))) (tan t) (atan (tan t))]))

(test-case "what does not vary is not noted, nor what numbers can tell"
  (notes [(lambda (t) (* t (abs 'a)))]
         [(lambda (t) (* (sqrt 'm) t))])
  (check-equal? (noted abs 2) '())
  (check-equal? (noted abs 2.0) '()))

(test-case "each once, in all nested derivatives"
  (notes [(D abs) (abs t)]
         [(lambda (t) (+ (abs t) (abs t))) (abs t)])
  (check-equal? (length (noted (lambda (t) (up (abs t) (abs (- t 1)))))) 2))

(test-case "comparison of what varies is noted"
  (notes [(lambda (t) (if (= t 2) 1 0)) (= t 2)]
         [(lambda (t) (if (zero? t) 1 0)) (= t 0)]
         [(lambda (t) (if (one? t) 1 0)) (= t 1)]
         [(lambda (t) (if (= 'a 2) 1 0))]))

(test-case "without anybody who asks nothing is kept"
  (define-values (value found) (call-noting-kinks (lambda () 1)))
  ((D abs) 't)
  (check-equal? found '()))
