#lang racket/base
;; Quaternions as values: the laws of a ring with division, what they print as, mixtures with
;; other kinds, and derivatives.

(require mechanics
         (only-in mechanics/value/quaternion [quaternion make])
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/random.rkt"
         "../support/same.rkt" "../support/session.rkt"
         "../support/laws/law.rkt" "../support/laws/ring.rkt"
         "../support/random/element.rkt")

(define q (quaternion 'a 'b 'c 'd))
(define p (quaternion 'r 'x 'y 'z))

;; ---------------------------------------------------------------------------
;; Laws

(define (random-quaternion [part random-rational]) (make (part) (part) (part) (part)))
(define laws (append ring-laws power-laws division-laws))

(define (exactly? a b) (zero? (- a b)))
(define (nearly? a b)
  (define (parts x) (if (quaternion? x) (structure->list (quaternion->vector x)) (list x 0 0 0)))
  (for/and ([x (parts a)] [y (parts b)]) (same? x y)))

(check-laws "quaternions of rationals" laws generic-ring random-quaternion exactly? #:seed 311)
(check-laws "quaternions of dual numbers" (append ring-laws power-laws) generic-ring
            (lambda () (random-quaternion random-dual)) nearly? #:seed 312)
(check-laws "quaternions and numbers" laws generic-ring
            (lambda () ((random-choice random-quaternion random-rational)))
            nearly? #:seed 313)
(check-broken "multiplication commutes" commutativity-laws generic-ring random-quaternion equal?
              #:seed 314)

;; ---------------------------------------------------------------------------

(test-case "it prints as what makes it"
  (for ([show (list print write display)])
    (define out (open-output-string))
    (show (quaternion 1 'x (* 2 'y) 1/2) out)
    (check-equal? (get-output-string out) "(quaternion 1 x (* 2 y) 1/2)"))
  (check-equal? (expression q) '(quaternion a b c d)))

(test-case "its parts"
  (check-equal? (quaternion->vector q) (up 'a 'b 'c 'd))
  (check-equal? (quaternion->3vector q) (up 'b 'c 'd))
  (check-equal? (quaternion->real-part q) 'a)
  (check-equal? (for/list ([i 4]) (quaternion-ref q i)) '(a b c d))
  (check-equal? (ref q 2) 'c)
  (check-equal? (make-quaternion (up 'a 'b 'c 'd)) q)
  (check-equal? (make-quaternion (vector 'a 'b 'c 'd)) q)
  (check-equal? (make-quaternion '(a b c d)) q)
  (check-equal? (real&3vector->quaternion 'a (up 'b 'c 'd)) q)
  (check-true (quaternion? q))
  (check-false (quaternion? (up 1 2 3 4))))

(test-case "Hamilton's equations of 1843"
  (define-values (i j k) (values (make 0 1 0 0) (make 0 0 1 0) (make 0 0 0 1)))
  (for ([square (list (* i i) (* j j) (* k k) (* i j k))])
    (check-equal? square (make -1 0 0 0)))
  (check-equal? (* i j) k)
  (check-equal? (* j i) (- k)))

(test-case "conjugate, magnitude and inverse"
  (check-equal? (simplify (q:conjugate q)) (simplify (quaternion 'a (- 'b) (- 'c) (- 'd))))
  (check-equal? (conjugate q) (q:conjugate q))
  (check-equal? (conjugate (up q 'x)) (up (q:conjugate q) 'x))
  (check-equal? (real-part q) 'a)
  (check-equal? (exact->inexact (make 1 2 3 1/2)) (make 1. 2. 3. 0.5))
  (check-prints (* q (q:conjugate q))
                '(quaternion (+ (expt a 2) (expt b 2) (expt c 2) (expt d 2)) 0 0 0))
  (check-prints (magnitude q) '(sqrt (+ (expt a 2) (expt b 2) (expt c 2) (expt d 2))))
  (check-identity (q:magnitude (* p q)) (* (q:magnitude p) (q:magnitude q)))
  (check-identity (q:conjugate (* p q)) (* (q:conjugate q) (q:conjugate p)))
  (check-identity (* q (invert q)) (make 1 0 0 0))
  (check-identity (* (/ p q) q) p)
  (check-identity (q:magnitude (q:make-unit q)) 1)
  (check-equal? (q:magnitude (make 1 2 2 4)) 5))

(test-case "a number is the quaternion without a vector part"
  (check-equal? (+ 1 (make 1 2 3 4)) (make 2 2 3 4))
  (check-equal? (- (make 1 2 3 4) 1) (make 0 2 3 4))
  (check-equal? (* 2 (make 1 2 3 4)) (make 2 4 6 8))
  (check-equal? (/ (make 2 4 6 8) 2) (make 1 2 3 4))
  (check-identity (* q (/ 1 q)) 1))

(test-case "the exponential of a vector is a rotation by twice its length"
  (check-equal? (exp (make 0 0 0 0)) (make 1 0 0 0))
  (check-identity (exp (quaternion 'a 0 0 0)) (quaternion (exp 'a) 0 0 0))
  (check-close (quaternion->vector (exp (make 0 0 0 (/ pi 6))))
               (list->up (list (cos (/ pi 6)) 0 0 1/2)) 1e-15))

(test-case "they are differentiated, simplified and judged part by part"
  (define (f x) (* (quaternion (sin x) x 0 1) q))
  (check-identity ((D f) 't) (* (quaternion (cos 't) 1 0 0) q))
  (check-prints (simplify (quaternion (+ 'x 'x) 0 0 0)) '(quaternion (* 2 x) 0 0 0))
  (check-equal? (substitute q 'a 3) (quaternion 3 'b 'c 'd))
  (check-pred refuted? (verify-equal (* p q) (* q p)))
  (check-identity (* q (* p q)) (* (* q p) q))
  (check-equal? ((* q sin) 0) (* q 0)))

(test-case "equal ones are equal to ="
  (check-true (= q (quaternion 'a 'b 'c 'd)))
  (check-false (= q p))
  (check-true (zero? (- q q))))

(says
 [(quaternion 1 2 3 (up 4))
  "quaternion: its four parts are numbers; given (up 4), an up tuple of 1\n"
  "  of a tuple of four, (make-quaternion (up r x y z))"]
 [(make-quaternion (up 1 2 3))
  "make-quaternion: expected a tuple of 4 numbers, the real part first\n"
  "  given: (up 1 2 3), an up tuple of 3"]
 [(make-quaternion 3)
  "make-quaternion: expected a tuple of 4 numbers, the real part first\n  given: the number 3"]
 [(quaternion-ref q 4)
  "quaternion-ref: the parts of a quaternion are numbered 0 to 3; given the number 4"]
 [(quaternion->vector 'a) "quaternion->vector: expected a quaternion\n  given: the symbol a"]
 [(real&3vector->quaternion 1 '(1 2 3))
  "real&3vector->quaternion: expected a tuple of 3 components\n  given: (1 2 3), a list\n"
  "  a list is not a tuple; use (up x y ...)"]
 [(q:make-unit (quaternion 0 0 0 0)) "q:make-unit: the quaternion 0 has no direction"]
 [(* q (up 1 2 3))
  "*: cannot multiply a quaternion by an up tuple of 3\n"
  "  argument 1: (quaternion a b c d), a quaternion\n"
  "  argument 2: (up 1 2 3), an up tuple of 3"]
 [(* q:i q)
  "*: cannot multiply a 4 by 4 matrix by a quaternion\n"
  "  argument 1: (matrix-by-rows (list 0 1 0 0) (list -1 0 0 0) (list 0 0 0 -1) (list 0 0 1 0)), "
  "a 4 by 4 matrix\n"
  "  argument 2: (quaternion a b c d), a quaternion"]
 [(sin q) "sin: cannot be taken of a quaternion\n  argument 1: (quaternion a b c d), a quaternion"]
 [(expt q 'n)
  "expt: cannot raise a quaternion to the power of a number-like expression\n"
  "  argument 1: (quaternion a b c d), a quaternion\n  argument 2: the symbol n"])

(test-case "exp of a quaternion with a real part"
  (define size (sqrt 29))
  (check-close (quaternion->vector (exp (quaternion 1 2 3 4)))
               (for/list ([part '(1 2 3 4)] [k 4])
                 (* (exp 1.0) (if (zero? k) (cos size) (* (/ (sin size) size) part))))
               1e-14))
