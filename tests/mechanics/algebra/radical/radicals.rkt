#lang racket/base
;; Sums of roots in normal form: their laws, quotients and roots, and decimals where terms cancel.

(require mechanics/algebra/expression/read
         mechanics/algebra/radical/radical-expression mechanics/algebra/radical/radical-power
         mechanics/algebra/radical/radical-sum
         (only-in mechanics/algebra/expression/expression expression->datum)
         "../../support/checks.rkt" "../../support/random.rkt")

(define (radicals datum) (expression->radicals (datum->expression datum)))
(define (written s) (and s (expression->datum (radicals->expression s))))
(define one (rational->radicals 1))

;; Three terms with square roots of small numbers, or cube roots.
(define (random-sum [degree 2])
  (for/fold ([sum (hash)]) ([_ (in-range 3)])
    (define root (root-of-term (random-integer 1 12) '() (/ (random-integer 0 degree) degree)))
    (radicals-add sum (radicals-scale (random-rational) root))))

(test-case "sums and products obey the laws of a commutative ring"
  (with-seeds 100
    (define-values (a b c) (values (random-sum) (random-sum 3) (random-sum)))
    (check-equal? (radicals-multiply a b) (radicals-multiply b a))
    (check-equal? (radicals-multiply a (radicals-multiply b c))
                  (radicals-multiply (radicals-multiply a b) c))
    (check-equal? (radicals-multiply a (radicals-add b c))
                  (radicals-add (radicals-multiply a b) (radicals-multiply a c)))
    (check-equal? (radicals-subtract a a) (hash))))

(test-case "a sum times its inverse is 1; square roots always have one, if it is short"
  (with-seeds 60
    (define s (random-sum))
    (define inverse (and (> (hash-count s) 0) (radicals-invert s)))
    (when inverse (check-equal? (radicals-multiply s inverse) one)))
  (for ([d '((+ 1 (sqrt 2) (sqrt 3) (sqrt 5)) (+ 1 (expt 2 1/3)) (- (expt 3 1/4) (sqrt 2)))])
    (check-equal? (radicals-multiply (radicals d) (radicals-invert (radicals d))) one))
  (check-false (radicals-invert (radicals '(+ 1 (expt 2 1/3) (expt 4 1/3))))))

(test-case "the root of a power is the number itself, where it is found"
  (with-seeds 60
    (define s (radicals-add (rational->radicals (random-rational))
                            (radicals-scale (random-rational) (root-of-term 7 '() 1/2))))
    (define positive (if (positive? (radicals->flonum s)) s (radicals-scale -1 s)))
    (for ([k '(2 3 4 5)])
      (define power (radicals-expt positive k))
      (when power (check-equal? (radicals-expt power (/ 1 k)) positive))))
  ;; By one prime alone: under fourth roots stands another.
  (for ([d '((+ (expt 2 1/4) (sqrt 3)) (+ (expt 3 1/4) (sqrt 2) (sqrt 5))
             (+ 1 (sqrt 2) (sqrt 3)) (+ (sqrt 2) (sqrt 3) (sqrt 5)))])
    (define s (radicals d))
    (check-equal? (radicals-expt (radicals-multiply s s) 1/2) s (format "~s" d))))

(test-case "what is no sum of roots, or not known to be one, is left to decimals"
  (check-false (radicals '(sqrt (+ 2 (sqrt 2)))))
  (check-false (radicals '(expt (- (expt 2 1/3) 1) 1/3)))
  (check-false (radicals '(expt (+ 5 (* 2 (sqrt 6))) 1/3)))  ; (3 + √5)/2 is as near as can be
  (check-false (radicals '(sqrt -2)))
  (check-false (radicals '(sqrt 1000000016000000063)))      ; of two large primes
  (check-false (radicals '(sqrt 0.5)))
  (check-false (radicals '(* x (sqrt 2)))))

(test-case "expressions of them have one form"
  (check-equal? (written (radicals '(/ 6 (sqrt 12)))) '(sqrt 3))
  (check-equal? (written (radicals '(sqrt 20/9))) '(* 2/3 (sqrt 5)))
  (check-equal? (written (radicals '(expt (+ 2 (sqrt 5)) -1/3))) '(+ -1/2 (* 1/2 (sqrt 5))))
  (check-equal? (written (radicals '(expt 72 1/3))) '(* 2 (expt 3 2/3))))

(test-case "decimals are right where terms cancel, and of any size"
  (define (decimal d) (radicals->flonum (radicals d)))
  (check-= (decimal '(expt (- (sqrt 2) 1) 20)) 2.2104784903422216e-8 1e-23)
  (check-= (/ (decimal '(- 3880899/2744210 (sqrt 2))) 4.694834867513278e-14) 1.0 1e-14)
  (check-within (decimal '(* (expt 10 -170) (sqrt 3))) 1.7320508075688772e-170 1e-185)
  (check-equal? (decimal '(sqrt 12)) (sqrt 12.0))
  (check-equal? (decimal '(/ 1 (sqrt 2))) (sqrt 0.5)))

(test-case "long sums are told from short ones"
  (check-true (radicals-small? (radicals '(+ 1 (sqrt 2) (sqrt 3)))))
  (check-false (radicals-small? (for/fold ([sum (hash)]) ([n (in-range 2 40)])
                                  (radicals-add sum (root-of-term n '() 1/2))))))
