#lang racket/base
;; No branch is dropped: whatever a function decides, and by whatever means, the
;; compiled one has its values.  Tests from a file that is not written in mechanics
;; take a placeholder for what it is, so both kinds are tried.

(require racket/flonum racket/list racket/math
         (prefix-in m: mechanics)
         (only-in mechanics match up down ref compile-function compiled-function-reason)
         "../support/checks.rkt")

(define points '(-7.0 -2.5 -1.0 -0.0 0.0 0.5 1.0 2.0 3.0 4.5 10.0))

;; Compiled at each of these examples, it has the values of the function everywhere.
(define-syntax-rule (same-values [x body] ...)
  (begin
    (test-case (format "~s" 'body)
      (define (f x) body)
      (for ([example (in-list '(2.0 -3.0 0.0 0.5))])
        (define c (compile-function f example))
        (for ([at (in-list points)])
          (check-within (flvector-ref (c (flvector at)) 0) (real->double-flonum (f at)) 1e-12
                        (format "compiled at ~a, value at ~a" example at)))))
    ...))

;; Tests of the generic language
(same-values
 [x (if (m:< x 0) (m:- x) (m:square x))]
 [x (cond [(m:negative? x) -1] [(m:= x 2) 7] [(m:> x 3) x] [else (m:sin x)])]
 [x (m:case x [(0.0 -0.0) 1] [(2.0 3.0) 5] [else x])]
 [x (m:max (m:min x 2) -1 (m:* 0.5 x))]
 [x (m:* (m:abs x) (m:square x))]
 [x (m:+ x (m:floor x))]
 [x (m:- (m:round x) (m:* 2 (m:truncate x)))]
 [x (if (m:integer? x) 0 x)]
 [x (m:vector-ref (vector 1 2 3 4) (m:modulo (m:inexact->exact (m:floor x)) 4))]
 [x (for/fold ([y x]) ([_ (in-range 100)] #:break (m:> y 5)) (m:+ y 1))]
 [x (match x [(? m:negative?) 1] [_ (m:* 3 x)])])

;; Racket's own
(same-values
 [x (if (< x 0) (m:- x) (m:square x))]
 [x (cond [(negative? x) -1] [(= x 2) 7] [(> x 3) x] [else (m:sin x)])]
 [x (max (min x 2) -1 (* 0.5 x))]
 [x (* (abs x) (m:square x))]
 [x (m:+ x (floor x))]
 [x (m:* x (sgn x))]
 [x (if (number? x) (m:* 2 x) 0)]
 [x (if (flonum? x) (m:* 2 x) 0)]
 [x (if (real? x) (m:* 2 x) 0)]
 [x (if (and (real? x) (< x 0)) (m:- x) (m:square x))]
 [x (if (and (flonum? x) (fl> x 0.0)) (m:- x) (m:square x))]
 [x (vector-ref (vector 1 2 3 4) (modulo (inexact->exact (floor x)) 4))]
 [x (list-ref '(1 2 3) (modulo (exact-floor x) 3))]
 [x (let ([k (index-where '(1 2 3) (lambda (y) (< x y)))]) (or k 5))]
 [x (string-length (format "~a" x))]
 [x (string->number (number->string x))]
 [x (if (regexp-match? #rx"^-" (format "~a" x)) -1 1)]
 [x (with-handlers ([exn:fail? (lambda (e) 0)]) (m:+ x (floor x)))]
 [x (if (symbol? x) 0 x)])

(test-case "a table looked up by the number that is there"
  (define table (hash 2.0 5 3.0 7))
  (define (f x) (hash-ref table x 0))
  (define c (compile-function f 2.0))
  (for ([x '(1.0 2.0 3.0)])
    (check-equal? (flvector-ref (c (flvector x)) 0) (real->double-flonum (f x))))
  (check-regexp-match #rx"differs" (compiled-function-reason c)))

;; Racket's own tests for one number are found out where the example passes them.
(test-case "match and case by numbers, compiled where they choose"
  (define (f x) (match x [2.0 5] [_ (m:* 3 x)]))
  (define (g x) (case x [(2.0 3.0) 5] [else x]))
  (define (h x) (if (integer? x) 0 x))
  (for ([f (list f g h)])
    (define c (compile-function f 2.0))
    (check-regexp-match #rx"differs" (compiled-function-reason c))
    (for ([x points])
      (check-equal? (flvector-ref (c (flvector x)) 0) (real->double-flonum (f x))))))

(test-case "a function that counts its calls, and whose value depends on them"
  (define calls 0)
  (define (f x)
    (set! calls (+ calls 1))
    (m:* calls x))
  (define c (compile-function f 2.0))
  (check-regexp-match #rx"differs" (compiled-function-reason c))
  (define before calls)
  (check-equal? (c (flvector 3.0)) (flvector (* 3.0 (+ before 1))))
  (check-equal? (c (flvector 3.0)) (flvector (* 3.0 (+ before 2)))))

(test-case "one that only counts them is compiled, and counts no more"
  (define calls 0)
  (define (f x)
    (set! calls (+ calls 1))
    (m:square x))
  (define c (compile-function f 2.0))
  (define before calls)
  (check-false (compiled-function-reason c))
  (check-equal? (c (flvector 3.0)) (flvector 9.0))
  (check-equal? calls before))

(test-case "a decision by one component of a structure"
  (define (f s)
    (define-values (x y) (values (ref s 0) (ref s 1 0)))
    (up (if (and (real? y) (< y 1)) (m:* x y) x) (down y 1)))
  (define c (compile-function f (up 1.0 (down 2.0))))
  (for* ([x '(-1.0 2.0)] [y '(-1.0 0.0 2.0)])
    (check-equal? (c (flvector x y)) (flvector (if (< y 1) (* x y) x) y 1.0))))

(test-case "errors at the point beside the example say nothing against the trace"
  (define (f x) (m:+ (m:sqrt (m:- x 1)) (m:log x)))
  (define c (compile-function f 1.5))
  (check-false (compiled-function-reason c))
  (check-= (flvector-ref (c (flvector 5.0)) 0) (+ 2 (log 5)) 1e-12)
  (define (g x) (if (and (real? x) (< x 0)) (raise-argument-error 'g "x" x) (m:* 2 x)))
  (check-equal? ((compile-function g 1.5) (flvector 3.0)) (flvector 6.0)))
