#lang racket/base
;; Derivatives of programs against central differences in 200-bit arithmetic.
;;
;; The same program is run on the generic operations for its derivative, and on
;; bigfloats for the difference quotient, whose error h² f‴/6 is below 10⁻²⁵.

(require (prefix-in m: mechanics)
         "../support/checks.rkt" "../support/bigfloats.rkt" "../support/skip.rkt")

;; Programs over any arithmetic: (program + * / sin exp sqrt constant) -> function.
(define programs
  (list
   (cons "x sin x"
         (lambda (add times over sine expo root number)
           (lambda (x) (times x (sine x)))))
   (cons "a loop: x/1 + x²/2 + ... + x⁶/6"
         (lambda (add times over sine expo root number)
           (lambda (x)
             (for/fold ([sum (number 0)] [power x] #:result sum) ([k (in-range 1 7)])
               (values (add sum (over power (number k))) (times power x))))))
   (cons "a recursion: nested exponentials of sines"
         (lambda (add times over sine expo root number)
           (define (nest n x) (if (= n 0) x (expo (sine (nest (- n 1) x)))))
           (lambda (x) (nest 4 x))))
   (cons "a branch and a square root"
         (lambda (add times over sine expo root number)
           (lambda (x) (root (add (number 2) (sine (times x (times x x))))))))))

(define (derivative-by-differences program x)
  (define bf (big 'bf))
  (define precision (big 'bf-precision))
  (parameterize ([precision 200])
    (define f (program (big 'bf+) (big 'bf*) (big 'bf/) (big 'bfsin) (big 'bfexp) (big 'bfsqrt) bf))
    (define h (bf "1e-15"))
    (define at (bf x))
    ((big 'bigfloat->flonum)
     ((big 'bf/) ((big 'bf-) (f ((big 'bf+) at h)) (f ((big 'bf-) at h)))
                ((big 'bf*) (bf 2) h)))))

(define (derivative program x)
  ((m:D (program m:+ m:* m:/ m:sin m:exp m:sqrt values)) x))

(skip-unless bigfloats? no-bigfloats
  (for* ([entry (in-list programs)] [x (in-list '(0.3 1.25 2.0 -0.7))])
    (test-case (format "the derivative of ~a at ~a is right to the last places" (car entry) x)
      (define exact (derivative-by-differences (cdr entry) x))
      (check-within (derivative (cdr entry) x) exact (* 1e-14 (max 1.0 (abs exact)))))))
