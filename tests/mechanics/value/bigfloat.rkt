#lang racket/base
;; Numbers of higher precision in the generic arithmetic.

(require (only-in racket/format ~a)
         mechanics
         (only-in mechanics/numeric/bigfloat/bigfloat-arithmetic check-bigfloats)
         "../support/checks.rkt" "../support/bigfloats.rkt" "../support/skip.rkt")

(define (shown x) (~a x))

;; Is x as close to zero as rounding in so many bits makes it?
(define (rounding? x bits) (< (abs (bigfloat->exact (+ x (bigfloat 0 bits)))) (expt 2 (- 8 bits))))

(test-case "where the library is missing, one message names the package"
  (check-exn
   (lambda (e)
     (and (exn:fail:unsupported? e)
          (regexp-match?
           #rx"^bigfloat: numbers of higher precision need the library MPFR, which is not installed"
                         (exn-message e))
          (regexp-match? #rx"apt install libmpfr6" (exn-message e))))
   (lambda () (check-bigfloats 'bigfloat (lambda (a b) (error "mpfr_add: not available")))))
  (check-exn #rx"^add: contract violation"
             (lambda ()
               (check-bigfloats 'bigfloat (lambda (a b) (raise-argument-error 'add "number?" a))))))

(skip-unless bigfloats? no-bigfloats
  (define two (bigfloat 2 200))

  (test-case "they print with all their digits, in all modes"
    (define root "1.4142135623730950488016887242096980785696718753769480731766796")
    (check-equal? (shown (sqrt two)) root)
    (check-equal? (format "~s" (sqrt two)) root)
    (check-equal? (format "~v" (up (sqrt two) 1)) (string-append "(up " root " 1)"))
    (check-equal? (shown two) "2.0")
    (check-equal? (shown (/ two 0.0)) "+inf.0")
    (check-equal? (shown (sqrt (- two))) "+nan.0")
    (check-equal? (format "~s" (simplify (up (* 2 two) (* 'a 'a)))) "(up 4.0 (expt a 2))"))

  (test-case "a result has the bits of the more precise argument; flonums enter as they are"
    (check-equal? (bigfloat-precision (* two (bigfloat 3 100))) 200)
    (check-equal? (bigfloat-precision (+ 0.1 two)) 200)
    (check-equal? (bigfloat->exact (* 1 (+ two 0.1))) (+ 2 (inexact->exact 0.1)))
    (check-true (rounding? (- (* 3 (/ two 3)) two) 200))
    (check-equal? (bigfloat-precision (bigfloat two 80)) 80)
    (check-equal? (bigfloat->exact (bigfloat "0.5")) 1/2)
    (check-equal? (bigfloat->exact (bigfloat ((big 'bf) 3))) 3))

  (test-case "exact 0 and 1 do what they do with Racket's numbers"
    (check-equal? (* 0 two) 0)
    (check-eq? (+ 0 two) two)
    (check-eq? (* two 1) two)
    (check-equal? (expt two 0) 1)
    (check-exn #rx"division by zero" (lambda () (/ two 0))))

  (test-case "they compare with all real numbers"
    (check-true (< 1 two 2.5))
    (check-true (= two 2))
    (check-true (= (bigfloat 1/2) 0.5 1/2))
    (check-false (= (bigfloat "0.1" 200) 0.1))
    (check-true (zero? (- two 2)))
    (check-equal? (max two 2) two)
    (check-equal? (min 3 two) two)
    (check-equal? (floor (sqrt two)) 1)
    (check-equal? (exact->inexact (sqrt two)) (sqrt 2.0))
    (check-true (number? two))
    (check-true (inexact? two))
    (check-true (integer? two))
    (check-equal? (bigfloat 1/3 100) (bigfloat 1/3 100)))

  (test-case "beside symbols they stand for their exact values"
    (check-equal? (expression (* 'a (/ two 4))) '(* 1/2 a))
    (check-equal? (expression ((literal-function 'f) two)) '(f 2))
    (check-equal? (expression ((D (literal-function 'f)) two)) '((D f) 2))
    (check-equal? (expression ((literal-function 'g (-> (UP Real Real) Real)) (up two 'a)))
                  '(g (up 2 a))))

  (test-case "what computes in flonums takes them"
    (check-= (definite-integral sin 0 two) (- 1 (cos 2)) 1e-10)
    (check-= (car (minimize (lambda (x) (square (- x 1))) 0 two)) 1 1e-7)
    (define k (/ two 4))
    (check-equal? (first-elliptic-integral k) (first-elliptic-integral 0.5))
    (check-equal? (elliptic-integral-F two k) (elliptic-integral-F 2.0 0.5))
    (check-equal? (Jacobi-elliptic-functions two k list) (Jacobi-elliptic-functions 2.0 0.5 list))
    (check-equal? ((D first-elliptic-integral) k) ((D first-elliptic-integral) 0.5)))

  (test-case "derivatives of every kind pass through"
    (define (f x) (/ (sin x) (exp (* x x))))
    (define (slope x) (/ (- (cos x) (* 2 x (sin x))) (exp (* x x))))
    (define x (bigfloat "0.3" 200))
    (check-true (rounding? (- ((D f) x) (slope x)) 200))
    (check-true (rounding? (- (((expt D 2) f) x) ((D slope) x)) 200))
    (check-true (rounding? (- (((expt D 5) sin) x) (cos x)) 200))
    (define (g s) (* (ref s 0) (sin (ref s 1))))
    (check-true (rounding? (- (ref ((gradient g) (up two x)) 1) (* two (cos x))) 200))
    (check-true (rounding? (- (ref ((D g) (up two x)) 0) (sin x)) 200))
    (check-true (rounding? (- (((partial 1) atan) x two) (* -1 (/ x (+ (square x) (square two)))))
                           200))
    (check-equal? ((D (lambda (t) two)) x) 0)
    (check-equal? ((D (lambda (t) (up two t))) x) (up 0 1)))

  (test-case "elementary functions undo each other"
    (define x (/ two 7))
    (for ([f (list sin cos tan sinh tanh exp sqrt)]
          [inverse (list asin acos atan asinh atanh log square)])
      (check-true (rounding? (- (inverse (f x)) x) 200)))
    (check-true (rounding? (- (expt two 1/2) (sqrt two)) 200))
    (check-true (rounding? (- (log (/ two 16) 2) -3) 200))
    (check-true (rounding? (- (atan 1 (bigfloat 1 200)) (atan (bigfloat 1 200))) 200)))

  (test-case "linear systems are solved with all digits, and singular ones found"
    (define n 6)
    (define (Hilbert i j) (/ 1 (+ i j 1)))
    (define A
      (m:generate n n (lambda (i j) (bigfloat (Hilbert i j) 200))))
    (define b (apply up (for/list ([i n]) (bigfloat (Hilbert i 2) 200))))
    (define x (solve-linear-left A b))
    (for ([e x] [i n])
      (check-true (rounding? (- e (if (= i 2) 1 0)) 170) (format "~a" x)))
    ;; elimination loses the twelve digits of the condition, formulas with determinants twice those
    (define H (m:generate 9 9 Hilbert))
    (define ones (make-vector 9 1))
    (for ([e (solve-linear-left (* (bigfloat 1 200) H) ones)] [exact (solve-linear-left H ones)])
      (check-true (rounding? (/ (- e exact) exact) 150)))
    (define row (up two (sqrt two)))
    (check-exn exn:fail:mechanics:singular:matrix?
               (lambda () (solve-linear-left (down row (* (exp two) row)) (up 1 1)))))

  (test-case "mistakes"
    (check-exn #rx"the numeral of one" (lambda () (bigfloat "two")))
    (check-exn #rx"number of bits" (lambda () (bigfloat 2 1)))
    (check-exn #rx"bigfloat-precision: expected a number of higher precision, such as"
               (lambda () (bigfloat-precision 2.0)))
    (check-exn #rx"cannot multiply a number of 200 bits by a number"
               (lambda () (* two (sqrt -1))))))
