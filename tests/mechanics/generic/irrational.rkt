#lang racket/base
;; Numbers made of roots: their exact arithmetic, and what they are to everything that takes
;; numbers.  Each pair has two oracles: the exact forms of both sides, and their values in 300
;; bits.

(require racket/flonum racket/list
         mechanics
         "../support/bigfloats.rkt" "../support/checks.rkt" "../support/messages.rkt"
         "../support/root-pairs.rkt"
         "../support/skip.rkt")

(define operations
  (hasheq '+ + '- - '* * '/ / 'sqrt sqrt 'expt expt))

;; number : rational -> number
(define (value-of datum number)
  (let value ([d datum])
    (if (pair? d)
        (apply (hash-ref operations (car d))
               (value (cadr d))
               (if (eq? (car d) 'expt) (cddr d) (map value (cddr d))))
        (number d))))

(define (exactly datum) (value-of datum values))
(define (in-bits datum) (value-of datum (lambda (x) (bigfloat x 300))))
(define (in-decimals datum) (value-of datum exact->inexact))

(test-case "equal numbers are equal, and those beside them are not"
  (for ([pair (in-list equal-pairs)])
    (define-values (left right) (values (exactly (car pair)) (exactly (cadr pair))))
    (check-true (and (exact? left) (exact? right) (= left right) (equal? left right))
                (format "~s" pair)))
  (for ([pair (in-list false-neighbours)])
    (check-false (= (exactly (car pair)) (exactly (cadr pair))) (format "~s" pair))))

(test-case "their decimals are those of flonum arithmetic, but for rounding"
  (for* ([pair (in-list equal-pairs)] [side (in-list pair)])
    (define x (in-decimals side))
    (unless (memv 13860 (flatten side))         ; where flonums have no digits left
      (check-within (exact->inexact (exactly side)) x 1e-11 (format "~s" side)))))

(skip-unless bigfloats? no-bigfloats
  (test-case "their values in 300 bits agree"
    (define (close? x y) (< (abs (bigfloat->exact (- x y))) (expt 2 -200)))
    (for ([pair (in-list equal-pairs)])
      (define one (in-bits (car pair)))
      (check-true (close? one (in-bits (cadr pair))) (format "~s" pair))
      (check-true (close? one (bigfloat (exactly (car pair)) 300)) (format "~s" pair))
      (check-true (close? one (+ (bigfloat 0 300) (exactly (car pair)))) (format "~s" pair)))
    (for ([pair (in-list false-neighbours)])
      (check-false (close? (in-bits (car pair)) (in-bits (cadr pair))) (format "~s" pair)))))

(define root (sqrt 2))

(test-case "they are exact real numbers to all tests of numbers"
  (check-equal? (map (lambda (test) (test root))
                     (list number? real? exact? inexact? rational? integer?))
                '(#t #t #t #f #f #f)))

(test-case "comparison is exact, beside a decimal that of decimals"
  (define near 2140758220993/1513744654945)
  (check-true (< near root))
  (check-false (= near root))
  (check-true (> root (- near (expt 10 -30))))
  (check-true (= root 1.4142135623730951))
  (check-true (< 1 root 1.5))
  (check-equal? (max 1 root (sqrt 3)) (sqrt 3))
  (check-equal? (min root 3/2) root)
  (check-equal? (abs (- 1 root)) (- root 1))
  (check-true (positive? root)))

(test-case "roundings are exact"
  (check-equal? (map floor (list root (- root) (expt (+ 1 root) 41)))
                '(1 -2 4940866263896162))
  (check-equal? (list (round root) (ceiling root) (truncate (* -3 root))) '(1 2 -4)))

(test-case "a decimal makes a decimal, and so does what is neither arithmetic nor a root"
  (for ([x (list (+ 1.0 root) (* root 0.5) (/ 1.0 root) (expt root 0.5) (sin root) (exp root)
                 (atan root 1) (expt root root) (exact->inexact root) (sqrt (+ 2 root)))])
    (check-pred flonum? x))
  (check-equal? (* 0 root) 0)
  (check-equal? (inexact->exact root) root)
  (check-equal? (number->string root) "1.4142135623730951"))

(test-case "what grows long goes on as a decimal"
  (check-pred flonum? (for/sum ([n (in-range 1 1000)]) (sqrt n)))
  (check-pred flonum? (for/fold ([x root]) ([_ 40]) (/ (+ x (/ 3 x) root) 2)))
  (define-values (a b)
    (for/fold ([a 1] [b root]) ([_ 8]) (values (/ (+ a b) 2) (sqrt (* a b)))))
  (check-= a 1.19814023473559 1e-14))

(test-case "beside symbols they are the expressions that they print as"
  (check-equal? (format "~a ~s ~v" root (up root 1) (- (* 2 root) 1/2))
                "(sqrt 2) (up (sqrt 2) 1) (+ -1/2 (* 2 (sqrt 2)))")
  (check-equal? (expression (* 'x root)) '(* x (sqrt 2)))
  (check-equal? (expression ((literal-function 'f) root)) '(f (sqrt 2)))
  (check-equal? (substitute (* 'x root) 'x root) 2)
  (check-equal? (substitute (* 'x root) 'x 0.5) (sqrt 0.5))
  (check-equal? (->TeX (* root 'x)) (->TeX (* 'x (read-expression '(sqrt 2))))))

(test-case "they are differentiated, and divided by 0, as other numbers are"
  (check-equal? ((D (lambda (x) (* root (square x)))) root) 4)
  (check-equal? ((D sqrt) 2) (/ root 4))
  (check-message "/: division by zero\n  in: (/ (sqrt 2) 0)" (/ root 0)))

(test-case "what takes numbers takes them"
  (define (L s) (- (* 1/2 (square (velocity s))) (* 1/2 root (square (coordinate s)))))
  (define x (evolve-trajectory (Lagrangian->state-derivative L) (up 0 root 0) (sqrt 3)))
  (check-= (ref (x root) 1) (* (sqrt 2.0) (cos (* (expt 2.0 0.25) (sqrt 2.0)))) 1e-9)
  (check-= (definite-integral (lambda (x) (* root x)) 0 root) (sqrt 2.0) 1e-12)
  (check-equal? ((compile-function (lambda (x) (up (* root x) root)) 1.0) (flvector 2.0))
                (flvector (* 2.0 (sqrt 2.0)) (sqrt 2.0)))
  (check-equal? (determinant (matrix-by-rows (list root 2) (list 1 root))) 0)
  (check-equal? (solve-linear-left (matrix-by-rows (list root 1) (list 1 root)) (up 1 0))
                (up root -1))
  (check-pred flonum? (determinant (matrix-by-rows (list root 2.5) (list 1 root)))))
