#lang racket/base
;; Where operations have kinks, jumps and no value.

(require mechanics/algebra/assumption/assumption-set
         mechanics/algebra/expression/read
         mechanics/algebra/simplify/declare-relations
         mechanics/algebra/zero/kink
         "../../support/checks.rkt")

(define (expression d) (datum->expression d))
(define (plain x) (read (open-input-string (format "~s" x))))

;; (sort equation ...) of each kink of the operation, in the variables x and y.
(define (found operation #:values? [values? #f] #:given [relations '()] #:at [places '()]
               #:unknowns [unknowns '(x y)] #:in [functions '()])
  (define A (if (null? relations) no-assumptions (declare-relations no-assumptions relations)))
  (define-values (kinks grounds)
    (find-kinks (list (cons (car operation) (map expression (cdr operation))))
                '(x y)
                A
                #:places (for/list ([p (in-list places)]) (cons (car p) (expression (cdr p))))
                #:unknowns unknowns
                #:values? values?
                #:functions (map expression functions)))
  (for/list ([k (in-list kinks)]) (plain (cons (kink-sort k) (kink-equations k)))))

(define-syntax-rule (finds [operation kink ...] ...)
  (begin (check-equal? (found 'operation) '(kink ...) (format "~s" 'operation)) ...))
(define-syntax-rule (finds-in-path [operation kink ...] ...)
  (begin (check-equal? (found 'operation #:values? #t) '(kink ...) (format "~s" 'operation)) ...))

(test-case "|u| where u changes its sign"
  (finds [(abs x) (kink (= x 0))]
         [(abs (- x 2)) (kink (= x 2))]
         [(abs (* 3 a x)) (kink (= x 0))]
         [(abs (* (- x 1) (+ x 1))) (kink (= x 1) (= x -1))]
         [(abs (* (- x 1) (expt (+ x 1) 2))) (kink (= x 1))]
         [(abs (expt x 2))]
         [(abs (+ (expt x 2) 1))]
         [(abs (+ (expt x 2) x 1))]
         [(abs (exp x))]
         [(abs a)]
         [(abs (- x y)) (kink (= (- x y) 0))]
         [(abs (+ (expt x 5) x 1)) (kink (= (+ 1 (expt x 3) (* -1 (expt x 2))) 0))]))

(test-case "sgn where u vanishes at all"
  (finds [(sgn x) (jump (= x 0))]
         [(sgn (expt x 2)) (jump (= x 0))]
         [(sgn (cosh x))]))

(test-case "a step has a gap, whatever else the quantity depends on, and 1/|x| none"
  (define (gaps-in d . relations) (found '(= x 2) #:in (list d) #:given relations))
  (check-equal? (gaps-in '(* y (/ x (abs x)))) '((gap (= x 0))))
  (check-equal? (gaps-in '(* (sqrt y) (/ x (abs x))) '(> y 0)) '((gap (= x 0))))
  (check-equal? (gaps-in '(/ y (abs x))) '()))

(test-case "waves vanish once a half-turn"
  (finds [(abs (sin x)) (kink (= x (* :pi n)))]
         [(abs (cos (* 2 x))) (kink (= x (+ (* 1/2 :pi n) (* 1/4 :pi))))]
         [(abs (- (sin x) 1/2)) (kink (= (- (* 2 (sin x)) 1) 0))]
         [(abs (- (sin x) 2))]
         [(abs (sinh x)) (kink (= x 0))]))

(test-case "roots of squares, and of fourth powers"
  (finds [(sqrt (expt x 2)) (kink (= x 0))]
         [(sqrt (expt x 4))]
         [(sqrt (expt x 6))]            ; |x|³ has two derivatives
         [(sqrt x)]
         [(sqrt (* x (expt y 2))) (kink (= y 0))]
         [(expt (expt x 2) 1/2) (kink (= x 0))]
         [(expt (expt x 2) 3/2)]
         [(expt (expt x 4) 1/4) (kink (= x 0))]
         [(expt (expt x 2) 0.5) (kink (= x 0))]
         [(sqrt (- 1 (expt (sin x) 2))) (kink (= x (+ (* :pi n) (* 1/2 :pi))))]))

(test-case "distances are none"
  (finds [(sqrt (+ (expt x 2) (expt y 2)))]
         [(sqrt (+ (expt x 2) (expt y 2) (expt (V y) 2)))]
         [(sqrt (+ (expt (* x (cos y)) 2) (expt (* x (sin y)) 2)))]
         [(sqrt (* 2 m (+ (expt (* x (cos y)) 2) (expt (* x (sin y)) 2))))]
         [(sqrt (+ (* 1/2 x x) (* 1/3 (expt x 2)))) (kink (= x 0))]
         [(sqrt (+ (expt x 2) (* 2 x) 1)) (kink (= x -1))]))

(test-case "inverses of what is periodic, or even"
  (finds [(asin (sin x)) (kink (= x (+ (* :pi n) (* 1/2 :pi))))]
         [(acos (cos x)) (kink (= x (* :pi n)))]
         [(asin (/ (* 2 x) (+ 1 (expt x 2)))) (kink (= x 1) (= x -1))]
         [(acosh (cosh x)) (kink (= x 0))]
         [(atan (tan x)) (jump (= x (+ (* :pi n) (* 1/2 :pi))))]
         [(atan (/ 1 x)) (jump (= x 0))]
         [(atan (/ 1 (expt x 2)))]
         [(asin x)]
         [(atan x)]
         [(asinh x)]
         [(atan x y) (jump (= x 0) (< y 0))]
         [(atan x (exp y))]))

(test-case "where all is linear in an angle the angle alone jumps, by a turn"
  (define (in . functions) (car (car (found '(atan x y) #:in functions))))
  (check-equal? (in '(atan x y)) 'branch)
  (check-equal? (in '(+ (* 3 (atan x y)) (* x y)) '(- y (atan x y))) 'branch)
  (check-equal? (in '(expt (atan x y) 2)) 'jump)
  (check-equal? (in '(* x (atan x y))) 'jump)
  (check-equal? (in '(atan x y) '(sin (* 1/2 (atan x y)))) 'jump))

(test-case "ends and poles count where there must be a value"
  (finds [(/ 1 x)] [(log x)] [(tan x)] [(expt x -2)] [(atanh x)] [(expt x 1/3)] [(= x 2)])
  (finds-in-path [(/ 1 (- x 2)) (no-value (= x 2))]
                 [(log x) (no-value (= x 0))]
                 [(log (+ 1 (expt x 2)))]
                 [(tan x) (no-value (= x (+ (* :pi n) (* 1/2 :pi))))]
                 [(expt x -2) (no-value (= x 0))]
                 [(expt x 1/3) (no-value (= x 0))]
                 [(expt x a) (no-value (= x 0))]
                 [(expt 2 x)]
                 [(sqrt (- 1 (expt x 2))) (no-value (= x 1) (= x -1))]
                 [(acos x) (no-value (= x 1) (= x -1))]
                 [(atanh (tanh x))]
                 [(= x 2) (jump (= x 2))]
                 [(nowhere +nan.0) (no-value)]))

(test-case "signs that were declared"
  (check-equal? (found '(abs x) #:given '((>= x 0))) '())
  (check-equal? (found '(sgn x) #:given '((>= x 0))) '((jump (= x 0))))
  (check-equal? (found '(sgn x) #:given '((> x 0))) '())
  (check-equal? (found '(/ 1 x) #:values? #t #:given '((< x 0))) '())
  (check-equal? (found '(abs (* x (- y 2))) #:given '((> y 3))) '((kink (= x 0)))))

(test-case "found for any coordinates, told on the path"
  (define (on-path operation . places) (found operation #:at places #:unknowns '(t)))
  (check-equal? (on-path '(abs x) '(x . (- t 2))) '((kink (= t 2))))
  (check-equal? (on-path '(abs x) '(x . (+ 1 (expt t 2)))) '())
  (check-equal? (on-path '(abs x) '(x . (expt t 2))) '((kink (= t 0))))
  (check-equal? (on-path '(abs x) '(x . l)) '())
  (check-equal? (on-path '(abs x) '(x . 3)) '()))
