#lang racket/base
;; Series: arithmetic, functions of them, application, laziness, printing.

(require mechanics/error/failure
         mechanics/generic/arithmetic
         mechanics/generic/compare
         mechanics/generic/elementary
         mechanics/generic/kind
         mechanics/value/compose
         mechanics/value/simplify
         mechanics/value/structure
         mechanics/value/series/series-access
         mechanics/value/series/calculus
         mechanics/value/series/known-series
         mechanics/calculus/derivative
         mechanics/verdict/prove-zero
         mechanics/verdict/verdict
         "../support/checks.rkt"
         "../support/messages.rkt" "../support/random.rkt" "../support/same.rkt"
         "../support/laws/law.rkt" "../support/laws/ring.rkt"
         "../support/random/element.rkt")

(define x (power-series 0 1))
(define (head s [n 6]) (series:head s n))
(define-syntax-rule (check-same a b) (check-true (same? a b)))

;; ---------------------------------------------------------------------------
;; Laws

(define commutative-laws (append ring-laws commutativity-laws power-laws))
(define field-laws (append commutative-laws division-laws))

(check-laws "power series of numbers" field-laws generic-ring random-series same? #:seed 601)
(check-laws "power series and numbers" field-laws generic-ring
            (lambda () ((random-choice random-series random-rational))) same? #:seed 602)
(check-laws "power series of expressions" field-laws generic-ring
            (lambda () (random-series (lambda () (random-choice 'a 'b 2 'c)))) same?
            #:seed 603 #:rounds 8)
(check-laws "power series of dual numbers" commutative-laws generic-ring
            (lambda () (random-series random-dual)) same? #:seed 604 #:rounds 8)
(check-laws "series of functions" commutative-laws generic-ring
            (lambda () (series (random-real-function) (random-real-function))) same?
            #:seed 605 #:rounds 4)
(check-laws "series of operators and matrices do not commute"
            (append ring-laws power-laws) generic-ring
            (lambda () (series (random-operator) (random-operator))) same? #:seed 606 #:rounds 2)
(check-laws "power series of matrices" (append ring-laws power-laws) generic-ring
            (lambda () (power-series (random-matrix) (random-matrix) (random-matrix)))
              same? #:seed 607)

(define (random-small-series)           ; beginning with 0
  (g:* x (random-series)))

(define-syntax-rule (for-random seed ([s draw] ...) body ...)
  (with-seed seed
    (for ([_ 12])
      (let ([s (draw)] ...)
        (with-check-info (['series (list s ...)]) body ...)))))

(test-case "exponentials multiply, logarithms undo them"
  (for-random 611 ([a random-small-series] [b random-small-series])
    (check-same (g:* (g:exp a) (g:exp b)) (g:exp (g:+ a b)))
    (check-same (g:log (g:exp a)) a)
    (check-same (g:exp (g:log (g:+ 1 a))) (g:+ 1 a))))

(test-case "roots, powers and their inverses"
  (for-random 612 ([a random-small-series])
    (define b (g:+ 1 a))
    (check-same (g:square (g:sqrt b)) b)
    (check-same (g:expt b 1/2) (g:sqrt b))
    (check-same (g:expt (g:expt b 1/3) 3) b)
    (check-same (g:expt b -2) (g:/ 1 (g:* b b)))
    (check-same (g:* (g:expt b 'n) (g:expt b (g:- 1 'n))) b)))

(test-case "circular and hyperbolic functions"
  (for-random 613 ([a random-small-series])
    (check-same (g:+ (g:square (g:sin a)) (g:square (g:cos a))) 1)
    (check-same (g:- (g:square (g:cosh a)) (g:square (g:sinh a))) 1)
    (check-same (g:tan a) (g:/ (g:sin a) (g:cos a)))
    (check-same (g:tanh a) (g:/ (g:sinh a) (g:cosh a)))
    (check-same (g:sin (g:asin a)) a)
    (check-same (g:tan (g:atan a)) a)
    (check-same (g:cos (g:* 2 a)) (g:- 1 (g:* 2 (g:square (g:sin a)))))))

(test-case "the derivative is a derivation, and undoes the integral"
  (for-random 614 ([a random-series] [b random-series])
    (define d series:derivative)
    (check-same (d (g:+ a b)) (g:+ (d a) (d b)))
    (check-same (d (g:* a b)) (g:+ (g:* (d a) b) (g:* a (d b))))
    (check-same (d (g:/ a b)) (g:/ (g:- (g:* (d a) b) (g:* a (d b))) (g:square b)))
    (check-same (d (series:integral a 'c)) a)
    (check-same (series:integral (d a) (series:ref a 0)) a)
    (check-same (D a) (d a))
    (check-same ((g:expt D 2) a) (d (d a)))))

(test-case "composition: associative, with the chain rule, undone by reversion"
  (for-random 615 ([a random-series] [b random-small-series] [c random-small-series])
    (check-same ((a b) c) (a (b c)))
    (check-same (series:derivative (a b)) (g:* ((series:derivative a) b) (series:derivative b)))
    (define t (series:reversion b))
    (check-same (b t) x)
    (check-same (t b) x)))

(test-case "every elementary function of a series is composed of its series and that"
  (for ([f (list g:exp g:sin g:cos g:tan g:asin g:atan g:sinh g:cosh g:tanh
                 (lambda (x) (g:log (g:+ 1 x))) (lambda (x) (g:sqrt (g:- 1 x))))])
    (define a (power-series 0 2 -1 1/3))
    (check-equal? (head (f a) 8) (head ((f x) a) 8))))

(test-case "elementary functions agree with their values at numbers"
  (define h 0.05)
  (for ([op (in-list elementary-operations)]
        #:when (= 1 (length (generic-op-partials op)))
        #:unless (memq (generic-op-name op) '(acosh)))
    (define f (generic-op-procedure op))
    (with-check-info (['operation (generic-op-name op)])
      (check-= (series:sum ((f (power-series 0.4 1 1/2)) h) 16)
               (f (+ 0.4 h (* 1/2 h h))) 1e-12))))

(test-case "powers of series whose exponent is a series"
  (define b (power-series 2.0 1))
  (define n (power-series 3.0 -1 1))
  (check-= (series:sum ((g:expt b n) 0.1) 20) (expt 2.1 (+ 3.0 -0.1 0.01)) 1e-9)
  (check-= (series:sum ((g:expt 2.0 n) 0.1) 20) (expt 2.0 (+ 3.0 -0.1 0.01)) 1e-9)
  (check-= (series:sum ((g:atan b n) 0.1) 20) (atan 2.1 2.91) 1e-9))

(test-case "of powers of 0 whose exponent varies nothing is said but that there is no derivative"
  (check-equal? (series:ref (g:expt 0 (series 'n 1)) 0) (g:expt 0 'n))
  (check-message "expt: has no derivative at (series 0), (series n 1)"
                 (series:ref (g:expt 0 (series 'n 1)) 1)
                 exn:fail:mechanics?))

;; ---------------------------------------------------------------------------
;; Known series

(test-case "series one knows"
  (check-equal? (head exp-series) '(1 1 1/2 1/6 1/24 1/120))
  (check-equal? (head sin-series) '(0 1 0 -1/6 0 1/120))
  (check-equal? (head cos-series) '(1 0 -1/2 0 1/24 0))
  (check-equal? (head sinh-series) '(0 1 0 1/6 0 1/120))
  (check-equal? (head cosh-series) '(1 0 1/2 0 1/24 0))
  (check-equal? (head atan-series) '(0 1 0 -1/3 0 1/5))
  (check-equal? (head (g:tan x) 10) '(0 1 0 1/3 0 2/15 0 17/315 0 62/2835))
  (check-equal? (head (g:/ 1 (g:- 1 x))) '(1 1 1 1 1 1))
  (check-equal? (head (g:/ x (g:- 1 x (g:square x))) 9) '(0 1 1 2 3 5 8 13 21))
  (check-equal? (head (series:reversion (g:- x (g:square x)))) '(0 1 1 2 5 14)))

(test-case "the binomial series, exercise 6.7"
  (check-equal? (head (binomial-series 5) 8) '(1 5 10 10 5 1 0 0))
  (check-equal? (head (binomial-series 1/2)) '(1 1/2 -1/8 1/16 -5/128 7/256))
  (check-equal? (simplify (series:ref (binomial-series 'n) 2))
                (simplify (g:/ (g:* 'n (g:- 'n 1)) 2)))
  (check-same (g:* (binomial-series 'n) (binomial-series 'm)) (binomial-series (g:+ 'n 'm))))

;; ---------------------------------------------------------------------------
;; Terms of any kind

(test-case "a scalar, a structure, a function, an operator is the term of order 0"
  (check-equal? (head (g:+ 'a (series 1 2)) 3) (list (g:+ 'a 1) 2 0))
  (check-equal? (head (g:* (up 1 'a) (series 2 3)) 2) (list (up 2 (g:* 2 'a)) (up 3 (g:* 3 'a))))
  (check-equal? (head (g:* (down 1 2) (series (up 3 4) (up 5 6))) 3) '(11 17 0))
  (check-equal? (head ((g:* g:sin (series 1 g:cos)) 'x) 2)
                (list (g:sin 'x) (g:* (g:sin 'x) (g:cos 'x))))
  (check-same ((g:* D (series 1 identity)) g:square)
              (series (g:* 2 identity) (g:* 3 (g:square identity))))
  (check-equal? (head (g:/ (series 2 4) 2) 3) '(1 2 0)))

(test-case "a series is applied term by term; scalars are constants"
  (check-equal? (head ((series g:square 3 g:cube) 2) 4) '(4 3 8 0))
  (check-equal? (head ((series g:+ g:*) 2 5) 2) '(7 10))
  (check-equal? (head ((series (up g:square 1) (up g:cube 'c)) 2) 2) (list (up 4 1) (up 8 'c))))

(test-case "a series whose terms are applied to give series counts their orders in"
  (define s ((series (lambda (t) (series t 1)) (lambda (t) (series (g:* 10 t) 100))) 2))
  (check-equal? (head s 4) '(2 21 100 0)))

(test-case "a power series is a function of its variable"
  (check-equal? (head (exp-series 'h) 3) (list 1 'h (g:* 1/2 (g:expt 'h 2))))
  (check-equal? (head ((power-series 1 2 3) 10) 4) '(1 20 300 0))
  (check-same (series:ref (exp-series D) 3) (g:/ (g:expt D 3) 6))
  (check-equal? (head ((power-series 0 (down 1 2) (down (down 3 4) (down 4 5))) (up 1 10)) 3)
                (list 0 21 (+ 3 40 40 500)))
  (check-equal? (head ((series:->function (series 1 2)) 'h) 2) (list 1 (g:* 2 'h))))

(test-case "ref reaches terms, and components of terms"
  (check-equal? (ref exp-series 3) 1/6)
  (check-equal? (ref (series 1 (up 2 3)) 1 1) 3))

(test-case "derivatives go through series"
  (check-equal? (head ((D (lambda (k) (exp-series k))) 'k) 4)
                (list 0 1 'k (g:* 1/6 3 (g:expt 'k 2))))
  (check-same (D (series g:sin g:cube)) (series g:cos (g:* 3 g:square)))
  (check-same ((D g:sin) (power-series 'a 1)) (g:cos (power-series 'a 1)))
  (check-same ((D (lambda (s) (g:* s s 'c))) exp-series) (g:* 2 'c exp-series))
  (check-same (((partial 0) (series g:* g:+)) 'x 'y) (series 'y 1)))

(test-case "a series is simplified, and substituted in, term by term"
  (define s
    (simplify (series (g:+ (g:square (g:sin 'x)) (g:square (g:cos 'x))) (g:- (g:* 2 'x) 'x))))
  (check-equal? (head s 2) '(1 x))
  (check-equal? (head (substitute (g:exp (power-series 0 'a)) 'a 2) 4) '(1 2 2 4/3)))

;; ---------------------------------------------------------------------------
;; Looking at terms

(test-case "sums and partial sums"
  (check-equal? (series:sum exp-series 3) 8/3)
  (check-equal? (series:sum (series 1 2) 10) 3)
  (check-equal? (series:sum (exp-series 'h) 2) (g:+ 1 'h (g:* 1/2 (g:expt 'h 2))))
  (check-equal? (head (partial-sums (series 1 2 3)) 5) '(1 3 6 6 6)))

(test-case "for-each visits as many terms as asked for, and all of a series that ends"
  (define (visited s . n)
    (define seen '())
    (apply series:for-each (lambda (t) (set! seen (cons t seen))) s n)
    (reverse seen))
  (check-equal? (visited exp-series 3) '(1 1 1/2))
  (check-equal? (visited (series 1 2)) '(1 2))
  (check-equal? (visited (series 1 2) 5) '(1 2))
  (check-exn
   #rx"^series:for-each: the series does not end; say of how many terms: .*series: .power-series 1 1 1/2 1/6 [.][.][.].$"
   (lambda () (visited exp-series))))

(test-case "which series end is known"
  (for ([s (list (series) (series 1 2) (power-series 1 2) (g:expt (power-series 1 2) 3)
                 (series:derivative (power-series 1 2 3))
                   (series:integral x) ((power-series 1 2) 'x)
                 ((power-series 1 2) (g:+ x (g:square x))) (g:/ x 2))])
    (check-true (series:finite? s)))
  (for ([s (list exp-series (g:/ 1 (g:+ 1 x)) (series:generate values) (exp-series 'x))])
    (check-false (series:finite? s))))

(test-case "series print their first terms, in all modes"
  (for ([mode '("~a" "~s" "~v")])
    (check-equal? (format mode (series 1 'a (g:sin 'x))) "(series 1 a (sin x))")
    (check-equal? (format mode (power-series 1 2)) "(power-series 1 2)")
    (check-equal? (format mode exp-series) "(power-series 1 1 1/2 1/6 ...)")
    (check-equal? (format mode (up 1 (exp-series 'h)))
                  "(up 1 (series 1 h (* 1/2 (expt h 2)) (* 1/6 (expt h 3)) ...))")))

(test-case "equality is of all terms; of series that do not end it is refuted or refused"
  (check-true (g:= (power-series 1 2 0) (power-series 1 2)))
  (check-true (equal? (power-series 1 'a) (power-series 1 'a)))
  (check-equal? (equal-hash-code (series 1 'a)) (equal-hash-code (series 1 'a)))
  (check-false (equal? (series 1 2) (power-series 1 2)))
  (check-false (g:= (series 1 2) (power-series 1 2)))
  (check-true (g:= exp-series exp-series))
  (check-false (g:= exp-series sin-series))
  (check-exn
   #rx"^=: two endless series agree in their first 8 terms, which does not decide whether they are equal"
   (lambda () (g:= exp-series (g:+ sinh-series cosh-series))))
  (check-true (g:zero? (g:- (series 1 2) (series 1 2))))
  (check-false (g:zero? (g:- exp-series exp-series))))

(test-case "a series that ends can be proved zero, one that does not can be refuted"
  (define one (g:+ (g:square (g:sin 'a)) (g:square (g:cos 'a))))
  (check-pred proved? (prove-zero (series 0 (g:- one 1))))
  (check-pred refuted? (prove-zero (series 0 (g:- one 2))))
  (check-pred refuted? (prove-zero (g:- exp-series cosh-series)))
  (define v (verify-equal exp-series (g:+ sinh-series cosh-series)))
  (check-pred undecided? v)
  (check-regexp-match #rx"examined: terms up to order 7 of a series that does not end"
                      (format "~a" v))
  (check-pred undecided? (prove-zero (up 0 (g:- (exp-series 'x) (exp-series 'x)))))
  (check-pred undecided? (prove-zero (lambda (t) (g:- (exp-series t) (exp-series t)))))
  (check-pred refuted? (prove-zero (lambda (t) (up 0 (exp-series t))))))

;; ---------------------------------------------------------------------------
;; Laziness

(test-case "a term is computed when it is asked for, and once"
  (define asked '())
  (define s (series:generate (lambda (k) (set! asked (cons k asked)) k)))
  (define t (g:+ s s))
  (check-equal? asked '(0))
  (check-equal? (series:ref t 3) 6)
  (check-equal? (series:ref t 3) 6)
  (check-equal? asked '(3 0)))

(test-case "a computation that was interrupted can be taken up again"
  (define ready (make-semaphore))
  (define open (make-semaphore))
  (define s (series:generate (lambda (k) (semaphore-post ready) (semaphore-wait open) (* 10 k))))
  (define t (thread (lambda () (with-handlers ([exn:break? void]) (series:ref s 2)))))
  (semaphore-wait ready)
  (break-thread t)
  (thread-wait t)
  (semaphore-post open)
  (check-equal? (series:ref s 2) 20))

(test-case "a term that raised an error raises it again"
  (define s (series:generate (lambda (k) (/ 1 (- k 2)))))
  (for ([_ 2]) (check-exn exn:fail:contract:divide-by-zero? (lambda () (series:ref s 2))))
  (check-equal? (series:ref s 3) 1))

(test-case "threads may force a series at once"
  (define s (g:exp (g:sin (power-series 0 1 1/2))))
  (define expected (head (g:exp (g:sin (power-series 0 1 1/2))) 60))
  (define results (make-vector 8 #f))
  (for-each thread-wait
            (for/list ([i 8])
              (thread (lambda () (vector-set! results i (head s 60))))))
  (for ([r (in-vector results)]) (check-equal? r expected)))

(test-case "a product of n terms takes of the order of n² multiplications"
  (define count 0)
  (struct counted ()
    #:property prop:kind
    (make-kind #:rank rank:dual #:describe (lambda (x) "counted") #:datum (lambda (x) 'counted)
               #:binary (lambda (op a b) (set! count (add1 count)) (if (counted? a) a b))
               #:unary (lambda (op a) a)))
  (define s (series:generate (lambda (k) (counted))))
  (for ([f (list (lambda (s) (g:* s s)) g:sin g:exp g:tan g:sqrt)])
    (set! count 0)
    (series:ref (f s) 40)
    (check-true (< count (* 8 40 40)) (format "~a: ~a" f count))))

;; ---------------------------------------------------------------------------
;; Misuse

(says
 [(g:+ exp-series (series 1 2))
  "+: one is a series, the other a power series; apply the power series to its variable first\n  argument 1: (power-series 1 1 1/2 1/6 ...), a power series\n  argument 2: (series 1 2), a series"]
 [((series 1 2) 'x)
  "application: a series applies those of its terms that are functions, but (series 1 2) has none\n  (power-series a ...) makes a function of coefficients"]
 [((power-series 1 2) 'x 'y)
  "(power-series 1 2): a power series takes one argument, its variable; given 2"]
 [(exp-series (power-series 1 2))
  "application: an endless power series can be applied to a series only if that begins with 0; given (power-series 1 2)"]
 [(series:ref (g:exp (series 0 D)) 2)
  "exp: the terms of the series must commute with each other; one is D, an operator"]
 [(series:ref 3 1) "series:ref: expected a series\n  given: the number 3"]
 [(series:sum (lambda (x) exp-series) 1)
  "series:sum: expected a series\n"
  "  given: a function without a name\n  a function whose values are series must be applied first"]
 [(series:derivative (series 1 2))
  "series:derivative: expected a power series\n"
  "  given: (series 1 2), a series\n  a series of terms has no variable; (series:->function s) takes its terms as coefficients"]
 [(series:head exp-series -1)
  "series:head: expected a number of terms\n  given: the number -1"]
 [(series:reversion exp-series)
  "series:reversion: the series must begin with 0\n  series: (power-series 1 1 1/2 1/6 ...)"]
 [(series:reversion (g:square x))
  "series:reversion: the coefficient of x must not be 0\n  series: (power-series 0 0 1)"])

(test-case "what begins with 0 has no inverse"
  (check-exn #rx"^/: division by zero$" (lambda () (g:/ 1 x)))
  (check-exn #rx"^log: the logarithm of 0 has no value$" (lambda () (g:log x))))
