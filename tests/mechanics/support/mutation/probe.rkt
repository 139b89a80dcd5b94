#lang racket/base
;; The part of the suite that a mutant is tried with: random expressions of every
;; class, nothing shrunk, until something fails; and a few sums by name.

(require (only-in mechanics/algebra/assumption/assumption-set no-assumptions with-domain)
         (only-in mechanics/algebra/simplify/declare-relations
                  declare-relations exn:algebra:contradiction?)
         mechanics/algebra/simplify/simplify-expression
         (only-in mechanics/algebra/ball/ball
                  ball/ ball-lower ball-upper ball-scale ball-positive? exact->ball make-ball)
         mechanics/algebra/zero/kink
         (only-in mechanics/algebra/zero/kept-meaning make-meaning meaningful?)
         mechanics/algebra/zero/real-proof
         mechanics/algebra/zero/zero-test
         mechanics/algebra/zero/fingerprint
         mechanics/algebra/expression/read
         (only-in mechanics/algebra/expression/expression expression->datum)
         "../property/property.rkt" "../property/run.rkt")

(provide probe)

;; Each has its status; what stands for 0 has that form, and that fingerprint.
(define known
  '((proved (- (expt (+ a b) 2) (+ (* a a) (* 2 a b) (* b b))))
    (proved (- (/ 1 (- x 1)) (/ 1 (+ x 1)) (/ 2 (- (expt x 2) 1))))
    (proved (- (cos (* 3 a)) (- (* 4 (expt (cos a) 3)) (* 3 (cos a)))))
    (proved (- (expt (cosh a) 2) (expt (sinh a) 2) 1))
    (proved (- (* (sqrt a) (sqrt b)) (sqrt (* a b))))
    (proved (- (log (* a b)) (log a) (log b)))
    (proved (- (* (exp a) (exp b)) (exp (+ a b))))
    (proved (- (expt (abs (- a b)) 2) (expt (- b a) 2)))
    (proved (- (/ (- (expt x 6) (expt b 6)) (- (expt x 2) (expt b 2)))
               (+ (expt x 4) (* (expt x 2) (expt b 2)) (expt b 4))))
    (refuted (- (sin (+ a b)) (+ (sin a) (sin b))))
    (refuted (- ((D q) t) (q t)))
    (refuted (- (V a b) (V b a)))
    (proved (- (sqrt 6) (* (sqrt 2) (sqrt 3))))
    (proved (+ b (- 0 b)))
    (proved (- (* 9.8 (+ a 1)) (* 9.8 a) 9.8))
    (proved (- (* 1/2 a) (* 0.5 a)))
    (proved (- (expt (expt a 2) 3) (expt a 6)))
    (proved (* (log (- 0 (* x y))) (+ (sqrt (expt (* x y) 2)) (* x y))))))

;; Equal, and printed so.
(define alike
  '(((/ (- a 1) (- (sqrt a) 1)) (+ 1 (sqrt a)))
    ((/ (expt (cos x) 2) (- 1 (sin x))) (+ 1 (sin x)))))

;; Simplified, these have the same values.
(define kept
  '((+ (* (cos x) (cos b) (V a b)) (* (sin x) (sin b) (V a b)) (expt c 5))
    (+ (sin a) (cos b) (sin (- (* 1/2 a) b)))
    (sqrt (expt (- a b) 2))
    (abs (* a b))
    (/ 1 (expt (+ 1 (sqrt a)) 2))
    (/ c (- (expt x 3) (+ a b 1)))))

;; Proved by reading decimals, and neither proved nor refuted.
(define read-for-proof '((- (* 0.3 x) (* 0.1 x) (* 0.2 x))))
(define open
  '((- (* 2.0000000000000004 x) (* 2.0 x))
    (- (cos (* 1.4142135623730958 x)) (cos (* (sqrt 2) x)))
    (- (* 0.7 x) (* 7 (* 0.1 x)))
    (- (expt (sqrt (- -1 (* x x))) 2) (- -1 (* x x)))))

;; Proved among real numbers, and not: these differ from 0 at one point, beyond 10¹⁸, by whole
;; turns, at one point, everywhere.
(define among-reals
  '((#t (- (sgn (* x (abs x))) (sgn x)))
    (#f (- (sgn (abs (- x 137/101))) 1))
    (#t (- (abs (- 2 (sqrt (+ 1 (expt (sin x) 2))))) (- 2 (sqrt (+ 1 (expt (sin x) 2))))))
    (#f (* (sqrt (+ 1000000000 (sqrt x)))
           (- (abs (- 1000000000 (sqrt x))) (- 1000000000 (sqrt x)))))
    (#t (- (+ (* 4 (atan (exp x))) (* 4 (atan (exp (* -1 x))))) (* 2 :pi)))
    (#f (+ (* 4 (atan (exp x))) (* 4 (atan (exp (* -1 x))))))
    (#t (- (atan (* -1 (exp x)) -1) (- (atan (exp x)) :pi)))
    (#f (- (atan (* -1 (abs x)) -1) (- (atan (abs x)) :pi)))
    (#t (- (sqrt (+ x (* 2 (sqrt (- x 1))))) (+ 1 (sqrt (- x 1)))))
    (#f (+ (sqrt (+ x (* 2 (sqrt (- x 1))))) 1 (sqrt (- x 1))))))

;; Names in their witnesses.
(define named
  '(((+ a (- (log b) (log b))) (a b))
    ((+ a (/ (- (* 2 x) x x) b)) (a b))))

;; Simplified, these are so.
(define shown
  '(((sqrt (* 0.2 (- 3 x))) (sqrt (- 0.6000000000000001 (* 0.2 x))))
    ((sgn (expt x 2)) (sgn (expt x 2)))
    ((abs (- (sin x) 3/4)) (* 1/4 (abs (- (* 4 (sin x)) 3))))))

;; The ways in which these vanish whatever x is.
(define ways
  '(((- (* Omega (expt x 2)) (* g x)) (((= Omega 0) (= g 0))))))

;; Operations with the kinks they have in x and y: sorts and places, and what is told of parameters;
;; the second and third list are a domain and functions.
(define kinked
  '(((sqrt (+ (expt x 2) (expt x 4))) () () ((kink (= x 0))) ())
    ((sqrt (+ (expt x 2) (expt y 2))) () () () ())
    ((sqrt (+ (expt x 2) (expt h 2))) () () () ((> (abs h) 0)))
    ((sqrt (- 1 (cos x))) () () ((kink (= x (* 2 :pi n)))) ())
    ((sqrt (+ 1 (cos x))) () () ((kink (= x (+ (* 2 :pi n) :pi)))) ())
    ((sqrt (+ (expt x 2) (expt (sin x) 2))) () ()
     ((kink (= (+ (expt x 2) (expt (sin x) 2)) 0))) ())
    ((abs x) () ((expt (abs x) 3)) () ())
    ((abs x) () ((* x (abs x))) ((kink (= x 0))) ())
    ((abs x) ((log (abs x))) () () ())
    ((abs x) ((/ 1 (- x 1))) () ((kink (= x 0))) ())))

(define (kinks-wrong? entry)
  (define-values (operation domain functions kinks conditions) (apply values entry))
  (define-values (found grounds)
    (find-kinks (list (cons (car operation) (map datum->expression (cdr operation))))
                '(x y)
                no-assumptions
                #:domain (map datum->expression domain)
                #:functions (map datum->expression functions)))
  (unlike operation (list kinks conditions)
          (read-back (list (for/list ([k (in-list found)]) (cons (kink-sort k) (kink-equations k)))
                           grounds))))

(define (read-back x) (read (open-input-string (format "~s" x))))

;; Where log(−1 − x²) has no value nothing is proved nor refuted; where log(x) has one, x is a
;; positive witness.
(define (domain-forgotten?)
  (define (judged e domain)
    (zero-test e (with-domain no-assumptions (list (datum->expression domain)))))
  (not (and (eq? 'undecided (zero-test-status (judged 0 '(log (- -1 (expt x 2))))))
            (eq? 'undecided (zero-test-status (judged 'x '(log (- -1 (expt x 2))))))
            (eq? 'proved (zero-test-status (judged 0 '(log (- x 5)))))
            (> (cdr (car (zero-test-witness (judged 'x '(log (- x 5)))))) 5))))

;; A third as the ball of a quotient, and balls that hold 0.
(define (balls-wrong?)
  (define third (ball/ (exact->ball 1 20) (exact->ball 3 20) 20))
  (define unit (expt 2 (ball-scale third)))
  (not (and (<= (* unit (ball-lower third)) 1/3 (* unit (ball-upper third)))
            (not (ball-positive? (make-ball 3 4 0 20)))
            (ball-positive? (make-ball 5 4 0 20)))))

(define (probe)
  (or (for/or ([entry (in-list known)])
        (with-handlers ([exn:fail? exn-message])
          (wrong entry)))
      (for/or ([pair (in-list alike)])
        (same-by-print (datum->expression (car pair)) (datum->expression (cadr pair))))
      (for/or ([d (in-list kept)]) (value-kept (datum->expression d)))
      (for/or ([d (in-list read-for-proof)]) (unlike d 'proved (status d)))
      (for/or ([d (in-list open)]) (unlike d 'undecided (status d)))
      (for/or ([entry (in-list among-reals)])
        (unlike (cadr entry) (car entry)
                (and (prove-among-reals (datum->expression (cadr entry)) no-assumptions) #t)))
      (for/or ([entry (in-list named)])
        (unlike (car entry) (cadr entry)
                (map car (zero-test-witness (zero-test (datum->expression (car entry)))))))
      (for/or ([entry (in-list shown)])
        (unlike (car entry) (cadr entry)
                (expression->datum (simplify-expression (datum->expression (car entry))))))
      (for/or ([entry (in-list ways)])
        (unlike (car entry) (cadr entry)
                (zero-test-ways (zero-test (datum->expression (car entry)) no-assumptions '(x)))))
      (for/or ([entry (in-list kinked)]) (kinks-wrong? entry))
      (and (domain-forgotten?) "a question without its domain")
      (and (balls-wrong?) "balls")
      (and (singular-allowed?) "a mass of 0")
      (and (refused? '((> x 0) (> (- (log x) x) 0))) "refused without a proof")
      (and (refused? one-point) "refused where there is a point")
      (for/or ([seed (in-range 1 201)])
        (with-handlers ([exn:fail? exn-message])
          (define failures (run-seed seed #:shrink? #f))
          (and (pair? failures) (failure->string (car failures)))))))

(define (status d) (zero-test-status (zero-test (datum->expression d))))

;; Holds at one point of many unknowns alone: more boxes than are looked at.
(define one-point
  '((>= (- 0 (expt (- a (sqrt 2)) 2) (expt (- b (sqrt 3)) 2) (expt (- c (sqrt 5)) 2)
           (expt (- d (sqrt 7)) 2) (expt (- e (sqrt 11)) 2) (expt (- f (sqrt 13)) 2)
           (expt (- g (sqrt 17)) 2) (expt (- h (sqrt 19)) 2))
        0)))

;; May m be 0 where it is one of two masses?
(define (singular-allowed?)
  (meaningful? (make-meaning '() '((m 0) (0 M)) '() '()) '((= m 0)) no-assumptions))

(define (refused? relations)
  (with-handlers ([exn:algebra:contradiction? (lambda (e) #t)])
    (declare-relations no-assumptions relations)
    #f))

(define (unlike d expected told)
  (and (not (equal? expected told)) (format "of ~a: ~a" d told)))

(define (wrong entry)
  (define e (datum->expression (cadr entry)))
  (define z (zero-test e))
  (define print (fingerprint e))
  (define told
    (list (zero-test-status z)
          (if (eqv? 0 (simplify-expression e)) 'zero 'not-zero)
          (if (memq print '(nonzero nonzero?)) 'not-zero print)))
  (define expected
    (cons (car entry)
          (if (eq? (car entry) 'refuted) '(not-zero not-zero) '(zero zero))))
  (define logarithms? (regexp-match? #rx"log" (format "~a" (cadr entry))))
  (and (not (equal? (if logarithms? (list (car told) (cadr told)) told)
                    (if logarithms? (list (car expected) (cadr expected)) expected)))
       (format "~a is ~a" (cadr entry) told)))
