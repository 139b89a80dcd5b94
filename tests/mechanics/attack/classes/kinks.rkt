#lang racket/base
;; Moduli and signs, greater and smaller of two, and inverse functions that undo theirs
;; on one branch only.

(require racket/match
         "../disguise.rkt" "../statement.rkt" "forms.rkt")

(provide kinks)

(define (kinks)
  (define e (random-kinked))
  (define r (for/fold ([e e]) ([_ (in-range (random-between 1 2))])
              (rewritten-somewhere e straightened 16)))
  (statement e (case (random 6) [(0) (spoiled r)] [(1) (disguise-once r)] [else r]) '() '()))

(define (greater u v) `(/ (+ ,u ,v (abs (- ,u ,v))) 2))
(define (smaller u v) `(/ (- (+ ,u ,v) (abs (- ,u ,v))) 2))

(define (random-kinked)
  (define-values (u v) (values (random-form) (random-form)))
  (define x (random-symbol))
  (pick (list `(abs ,u) `(abs (* ,u ,v)) `(abs (/ ,u ,v)) `(* ,u (sgn ,u)) `(sgn (* ,u ,v))
              `(square (abs ,u)) `(abs (expt ,u 3)) `(square (sgn ,u)) `(sgn (abs ,u))
              `(+ ,(greater u v) ,(smaller u v)) `(- ,(greater u v) ,(smaller u v))
              `(atan (tan ,u)) `(asin (sin ,x)) `(acos (cos ,x)) `(acosh (cosh ,u))
              `(asinh (sinh ,u)) `(atanh (tanh ,x)) `(sgn (- ,u ,v)) `(abs (- ,u ,v))
              `(sqrt (square (- ,u ,v))) `(/ (abs ,u) ,u) `(sgn (/ 1 ,u)) `(sgn (sin (* 3 ,x)))
              `(- (sqrt (square (- ,u 2))) (sqrt (square (- 1 ,u)))) `(cosh (acosh ,u))
              `(sgn (- (asinh ,x) (log (+ ,x (sqrt (+ 1 (square ,x)))))))
              `(abs (+ (abs ,u) ,v)) `(sgn (- (exp ,x) 1)) `(tan (atan ,u)) `(sin (asin ,u)))))

(define (straightened e)
  (match e
    [`(abs (* ,u ,v)) `(* (abs ,u) (abs ,v))]
    [`(abs (/ ,u ,v)) `(/ (abs ,u) (abs ,v))]
    [`(abs (- ,u ,v)) (pick (list `(abs (- ,v ,u)) `(- ,u ,v)))]
    [`(abs (expt ,u ,n)) `(expt (abs ,u) ,n)]
    [`(abs ,u) (pick (list `(sqrt (square ,u)) `(* ,u (sgn ,u)) u))]
    [`(* ,u (sgn ,u)) `(abs ,u)]
    [`(square (abs ,u)) `(square ,u)]
    [`(square (sgn ,u)) 1]
    [`(sgn (abs ,u)) 1]
    [`(sgn (* ,u ,v)) `(* (sgn ,u) (sgn ,v))]
    [`(sgn (- ,u ,v)) `(- (sgn (- ,v ,u)))]
    [`(sgn (/ 1 ,u)) `(sgn ,u)]
    [`(sgn (sin (* 3 ,x))) `(* (sgn (sin ,x)) (sgn (- 3 (* 4 (square (sin ,x))))))]
    [`(sgn (- (exp ,x) 1)) `(sgn ,x)]
    [`(sgn ,u) (pick (list `(/ ,u (abs ,u)) `(/ (abs ,u) ,u) 0))]
    [`(/ (abs ,u) ,u) `(sgn ,u)]
    [`(sqrt (square ,u)) (pick (list u `(abs ,u)))]
    [`(,(or 'atan 'asin 'acos 'asinh 'atanh) (,(or 'tan 'sin 'cos 'sinh 'tanh) ,u)) u]
    [`(,(or 'tan 'sin 'cosh) (,(or 'atan 'asin 'acosh) ,u)) u]
    [`(acosh (cosh ,u)) (pick (list u `(abs ,u)))]
    [`(- (/ (+ ,u ,v ,w) 2) ,_) w]
    [`(+ (/ (+ ,u ,v ,w) 2) ,_) `(+ ,u ,v)]
    [_ #f]))
