#lang racket/base
;; Identities of real numbers: roots, absolute values, signs, logarithms, arcs and hyperbolic
;; functions, many of which hold in a region only.  Random arguments are put in, both sides are made
;; parts of something else, and about every other one is made false: by a sign, a factor, a whole
;; turn, a condition left away or changed.  The points begin with small numbers, at which much is
;; zero.

(require racket/list racket/match
         "../disguise.rkt" "../judge/evaluate.rkt" "../judge/flonum.rkt" "../judge/point.rkt"
         "../judge/relation.rkt"
         "../statement.rkt" "../template.rkt")

(provide real-identities)

(define (real-identities)
  (define-values (left right given) (random-identity))
  (define-values (other-right other-given)
    (if (chance 2) (made-false right given) (values right given)))
  (define context (random-context))
  (define sides (list (context (disguised left (random 2))) (context other-right)))
  (define points (points-where other-given sides))
  (if (null? points)
      (real-identities)
      (statement (car sides) (cadr sides) other-given points)))

;; ---------------------------------------------------------------------------
;; Identities: (left right condition ...), in u and v

(define identities
  '(;; roots, absolute values and signs
    ((sqrt (square u)) (abs u)) ((abs (* u v)) (* (abs u) (abs v))) ((* u (sgn u)) (abs u))
    ((* (sgn u) (sgn v)) (sgn (* u v))) ((abs (sgn u)) (sgn (abs u))) ((sgn (cube u)) (sgn u))
    ((square (sgn u)) 1 (> (abs u) 0)) ((sgn (square u)) 1 (> (abs u) 0))
    ((sgn (abs u)) 1 (> (abs u) 0)) ((+ u v (abs (- u v))) (* 2 u) (>= (- u v) 0))
    ((+ (abs (- u v)) (abs (- v u))) (* 2 (abs (- u v)))) ((abs (+ u (abs u))) (+ u (abs u)))
    ((+ (abs u) (abs v)) (abs (+ u v)) (>= (* u v) 0))
    ((abs (- (abs u) (abs v))) (abs (- u v)) (>= u 0) (>= v 0))
    ((+ (abs (- u 1)) (abs (+ u 1))) 2 (<= u 1) (>= u -1))
    ((sqrt (+ u (* 2 (sqrt (- u 1))))) (+ 1 (sqrt (- u 1))))
    ((sqrt (- u (* 2 (sqrt (- u 1))))) (abs (- (sqrt (- u 1)) 1)))
    ((sqrt (- u (* 2 (sqrt (- u 1))))) (- (sqrt (- u 1)) 1) (>= u 2))
    ((sqrt (+ u v (* 2 (sqrt (* u v))))) (+ (sqrt u) (sqrt v)))
    ((* (sqrt u) (sqrt v)) (sqrt (* u v))) ((sqrt (/ u v)) (/ (sqrt u) (sqrt v)))
    ((sqrt (* (square u) v)) (* (abs u) (sqrt v))) ((sqrt (* (square u) v)) (* u (sqrt v)) (>= u 0))
    ((/ 1 (+ (sqrt u) (sqrt v))) (/ (- (sqrt u) (sqrt v)) (- u v)))
    ((sqrt (+ (square u) (square v) (* 2 u v))) (abs (+ u v)))
    ((abs (- u (sqrt (+ 1 (square u))))) (- (sqrt (+ 1 (square u))) u))
    ((abs (- 2 (sqrt u))) (- 2 (sqrt u)) (<= u 4)) ((abs (- 1 (sqrt u))) (- (sqrt u) 1) (>= u 1))
    ((sqrt (square (- 3 (sqrt (+ 1 (square u)))))) (- 3 (sqrt (+ 1 (square u)))) (<= (abs u) 2))
    ((sqrt (+ 1 (* 2 (abs u)) (square u))) (+ 1 (abs u)))
    ((sqrt (- 1 (square (sin u)))) (abs (cos u)))
    ((sqrt (+ 2 (* 2 (cos u)))) (* 2 (abs (cos (/ u 2)))))
    ((* (sqrt (- 1 u)) (sqrt (+ 1 u))) (sqrt (- 1 (square u))))
    ((/ (sqrt (- 1 (square u))) (+ 1 u)) (sqrt (/ (- 1 u) (+ 1 u))))
    ;; logarithms, and inverse hyperbolic functions
    ((log (* u v)) (+ (log (abs u)) (log (abs v)))) ((log (square u)) (* 2 (log (abs u))))
    ((log (/ u v)) (- (log u) (log v))) ((log (abs (/ u v))) (- (log (abs u)) (log (abs v))))
    ((log (sqrt u)) (* 1/2 (log u))) ((exp (log (abs u))) (abs u))
    ((asinh u) (log (+ u (sqrt (+ 1 (square u)))))) ((acosh u) (log (+ u (sqrt (- (square u) 1)))))
    ((atanh u) (* 1/2 (log (/ (+ 1 u) (- 1 u))))) ((asinh (sinh u)) u) ((acosh (cosh u)) (abs u))
    ((acosh (cosh u)) u (>= u 0)) ((atanh (tanh u)) u) ((cosh (log u)) (/ (+ u (/ 1 u)) 2))
    ((* 2 (asinh u)) (asinh (* 2 u (sqrt (+ 1 (square u))))))
    ((* 2 (acosh u)) (acosh (- (* 2 (square u)) 1)))
    ((+ (atanh u) (atanh v)) (atanh (/ (+ u v) (+ 1 (* u v)))))
    ((+ (asinh u) (asinh v)) (asinh (+ (* u (sqrt (+ 1 (square v)))) (* v (sqrt (+ 1
     (square u)))))))
    ((log (+ u (sqrt (+ 1 (square u))))) (- (log (- (sqrt (+ 1 (square u))) u))))
    ((acosh u) (* 2 (asinh (sqrt (/ (- u 1) 2))))) ((cosh (asinh u)) (sqrt (+ 1 (square u))))
    ((sinh (acosh u)) (sqrt (- (square u) 1))) ((asinh (- u)) (- (asinh u)))
    ((asinh u) (* (sgn u) (acosh (sqrt (+ 1 (square u))))))
    ((atanh (/ 1 u)) (* 1/2 (log (/ (+ u 1) (- u 1)))))
    ;; arcs
    ((+ (asin u) (acos u)) (/ :pi 2)) ((+ (atan u) (atan (/ 1 u))) (/ :pi 2) (> u 0))
    ((+ (atan u) (atan (/ 1 u))) (/ :pi -2) (< u 0))
    ((+ (atan u) (atan (/ 1 u))) (* 1/2 :pi (sgn u)))
    ((atan u) (asin (/ u (sqrt (+ 1 (square u))))))
    ((* 2 (atan u)) (asin (/ (* 2 u) (+ 1 (square u)))) (<= (square u) 1))
    ((* 2 (atan u)) (asin (/ (* 2 u) (+ 1 (square u)))) (>= u -1) (<= u 1))
    ((* 2 (atan u)) (acos (/ (- 1 (square u)) (+ 1 (square u)))) (>= u 0))
    ((* 2 (atan (abs u))) (acos (/ (- 1 (square u)) (+ 1 (square u)))))
    ((+ (atan u) (atan v)) (atan (/ (+ u v) (- 1 (* u v)))) (< (* u v) 1))
    ((+ (atan u) (atan v)) (+ :pi (atan (/ (+ u v) (- 1 (* u v))))) (> (* u v) 1) (> u 0))
    ((- (atan u) (atan v)) (atan (/ (- u v) (+ 1 (* u v)))) (> u 0) (> v 0))
    ((acos (- u)) (- :pi (acos u))) ((asin (- u)) (- (asin u)))
    ((atan v u) (atan (/ v u)) (> u 0)) ((atan v u) (+ :pi (atan (/ v u))) (< u 0) (>= v 0))
    ((atan v u) (- (atan (/ v u)) :pi) (< u 0) (< v 0))
    ((atan v u) (- (/ :pi 2) (atan (/ u v))) (> v 0))
    ((atan v u) (* 2 (atan (/ v (+ u (sqrt (+ (square u) (square v))))))))
    ((atan (- v) u) (- (atan v u)) (> (abs v) 0)) ((atan (- v) u) (- (atan v u)) (> u 0))
    ((atan (* 2 v) (* 2 u)) (atan v u)) ((atan (abs v) u) (abs (atan v u)))
    ((atan (- (abs u)) -1) (- (atan (abs u)) :pi) (> (abs u) 0))
    ((acos u) (* 2 (asin (sqrt (/ (- 1 u) 2)))))
    ((asin u) (* 2 (atan (/ u (+ 1 (sqrt (- 1 (square u))))))))
    ((asin (sqrt (- 1 (square u)))) (acos (abs u))) ((acos u) (atan (sqrt (- 1 (square u))) u))
    ((acos u) (- (/ :pi 2) (* 2 (atan (/ u (+ 1 (sqrt (- 1 (square u)))))))))
    ((atan (sqrt u)) (acos (/ 1 (sqrt (+ 1 u))))) ((* 2 (asin (sqrt u))) (acos (- 1 (* 2 u))))
    ((+ (asin u) (asin v)) (asin (+ (* u (sqrt (- 1 (square v)))) (* v (sqrt (- 1 (square u))))))
     (<= (+ (square u) (square v)) 1))
    ((+ (atan u v) (atan v u)) (/ :pi 2) (> u 0) (> v 0))
    ((sin (* 2 (asin u))) (* 2 u (sqrt (- 1 (square u)))))
    ((cos (atan v u)) (/ u (sqrt (+ (square u) (square v)))))
    ((tan (* 1/2 (acos u))) (sqrt (/ (- 1 u) (+ 1 u))))
    ((asin (sin u)) u (<= (abs u) 3/2)) ((asin (sin u)) (- :pi u) (> u 2) (< u 4))
    ((acos (cos u)) (abs u) (<= (abs u) 3)) ((acos (cos u)) u (>= u 0) (<= u 3))
    ((atan (tan u)) u (< u 3/2) (> u -3/2)) ((atan (sinh u)) (* 2 (atan (tanh (/ u 2)))))
    ((asin (tanh u)) (atan (sinh u))) ((acos (/ 1 (cosh u))) (abs (atan (sinh u))))))

;; -> left, right, relations
(define (random-identity)
  (define argument (if (chance 3) (lambda () (pick '(x y))) random-argument))
  (define choices (list (cons 'u (argument)) (cons 'v (argument))))
  (match-define (list* left right given) (filled (pick identities) choices))
  (values left right (append given (random-relations))))

(define (random-argument)
  (define c (pick '(1 2 1/2 1/3 137/101)))
  (pick (list 'x 'y `(- x ,c) `(- ,c x) `(- x y) `(+ x y) `(* x y) `(square x) `(- (square x) ,c)
              `(+ (square x) y) `(/ x y) '(sin x) '(cos y) '(exp x) '(- (exp x) 1) `(* ,c x) '(- x)
              '(sqrt x) '(sqrt (+ 1 (square x))) '(abs x) '(tanh x) '(log x) `(- ,c (sqrt y))
              '(/ 1 x) '(* x (abs x)) '(/ x (sqrt (+ 1 (square y)))) '(sinh x) '(cube x)
              `(sqrt (* (square y) (- x ,c))))))

(define (random-relations)
  (define c (pick '(0 1 -1 1/2 2)))
  (if (chance 2)
      '()
      (pick (list `((> x ,c)) `((< x ,c)) `((>= y ,c)) `((<= y ,c)) `((> x 0) (> y 0))
                  `((>= x 0) (<= x 1)) `((> x :pi)) `((< y x)) `((> (* x y) ,c)) `((> (abs x) 0))
                  '((>= x 1) (<= x 1)) '((> (- 1 (square x)) 0))))))

;; ---------------------------------------------------------------------------
;; Falsehoods

;; -> right, relations
(define (made-false right given)
  (define (changed-somewhere) (rewritten-somewhere right changed))
  (match (random (if (null? given) 6 10))
    [0 (values `(- ,right) given)]
    [1 (values `(* ,(pick '(2 1/2 3)) ,right) given)]
    [2 (values `(+ ,right ,(pick '(:pi (- :pi) (* 2 :pi) (* -2 :pi) (/ :pi 2)))) given)]
    [3 (values `(+ ,right ,(pick '(1 1/1000 1/1000000000 (abs x) (* 1/1000 (sgn y))))) given)]
    [(or 4 5) (values (changed-somewhere) given)]
    [(or 6 7) (values right (remove (pick given) given))]
    [_ (let ([r (pick given)]) (values right (cons (turned r) (remove r given))))]))

(define (changed e)
  (match e
    [`(abs ,u) (pick (list u `(- ,u)))]
    [`(sgn ,u) (pick (list 1 `(abs ,u) `(square (sgn ,u))))]
    [`(sqrt ,u) `(- (sqrt ,u))]
    [`(- ,u ,v) (pick (list `(- ,v ,u) `(+ ,u ,v)))]
    [`(+ ,u ,v) `(- ,u ,v)]
    [`(/ ,u ,v) `(/ ,v ,u)]
    [`(,(and f (or 'asin 'acos 'atan 'asinh)) ,u)
     (pick (list `(,f (abs ,u)) `(abs (,f ,u)) `(- (,f ,u))))]
    [`(log ,u) `(log (abs ,u))]
    [_ #f]))

;; The relation the other way round, or with its brim
(define (turned relation)
  (match-define (list head u c) relation)
  (list (pick (case head [(>) '(< >=)] [(>=) '(<= <)] [(<) '(> <=)] [else '(>= >)])) u c))

;; ---------------------------------------------------------------------------
;; Contexts: both sides of an equation in the same larger expression

(define (random-context)
  (define w (pick '(x y (- x 1) (- x 137/101) (* x y))))
  (define factor
    (pick (list `(+ 1 (abs ,w)) `(sgn ,w) `(sqrt (+ 100 (sqrt ,w))) `(log (+ 9 (sqrt ,w)))
                `(+ 2 (sqrt (* (square x) (- y 1)))) `(atan ,w -1) `(sqrt ,w) w
                `(+ 1 (abs ,w) (sqrt (* (square ,w) (- ,w 1)))))))
  (pick (list values values values
              (lambda (e) `(* ,factor ,e))
              (lambda (e) `(+ ,factor ,e))
              (lambda (e) `(/ ,e ,factor))
              (lambda (e) `(abs ,e))
              (lambda (e) `(sqrt (+ 1 (square ,e)))))))

;; ---------------------------------------------------------------------------
;; Points

(define most-points 8)

;; Where the relations hold, and the sides have values if such points are found
(define (points-where given sides)
  (define symbols (apply symbols-of (append sides (relation-sides given))))
  (define all
    (for*/list ([_ (in-range 60)]
                [numbers
                 (in-value (if (chance 3) (random-numbers symbols (random 40)) (few symbols)))]
                #:when (all-hold? given (make-point numbers 0) flonum-intervals))
      numbers))
  (define good (filter (lambda (numbers) (andmap (lambda (e) (real-there? e numbers)) sides)) all))
  (take-at-most (remove-duplicates (append good all)) most-points))

(define (real-there? e numbers)
  (value? (value-at e (make-point numbers 0) flonum-intervals)))

(define (few symbols)
  (for/hasheq ([s (in-list symbols)])
    (values s (pick '(0 0 1 -1 2 1/2 -1/2 3 -2 137/101 1/3 3/2 4 7/2 -3 5)))))

(define (take-at-most xs n) (if (> (length xs) n) (take xs n) xs))
