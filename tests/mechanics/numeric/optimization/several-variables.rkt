#lang racket/base
;; Minima of functions of several variables, with and without gradients.

(require racket/flonum
         (only-in racket/math cosh sinh)
         mechanics/error/failure
         mechanics/numeric/optimization/nelder-mead
         mechanics/numeric/optimization/quasi-newton
         "../../support/checks.rkt")

(define (x i v) (flvector-ref v i))

;; Rosenbrock's valley, its minimum at (1, 1).
(define (valley v)
  (+ (expt (- 1.0 (x 0 v)) 2) (* 100.0 (expt (- (x 1 v) (expt (x 0 v) 2)) 2))))
(define (valley+gradient v)
  (define d (- (x 1 v) (expt (x 0 v) 2)))
  (values (valley v)
          (flvector (+ (* -2.0 (- 1.0 (x 0 v))) (* -400.0 (x 0 v) d)) (* 200.0 d))))

(define (far v w) (for/fold ([m 0.0]) ([a (in-flvector v)] [b (in-list w)]) (max m (abs (- a b)))))

(test-case "Rosenbrock's valley"
  (define-values (with-gradient f slope steps) (quasi-newton valley+gradient (flvector -1.2 1.0)))
  (check-true (< (far with-gradient '(1.0 1.0)) 1e-7))
  (check-true (< steps 60))
  (define-values (without g count) (nelder-mead valley (flvector -1.2 1.0)))
  (check-true (< (far without '(1.0 1.0)) 1e-6)))

(test-case "a quadratic function of n variables takes about n steps"
  (define n 8)
  (define (f v)
    (values (for/sum ([u (in-flvector v)] [k (in-naturals 1)]) (* k (expt (- u k) 2)))
            (for/flvector #:length n ([u (in-flvector v)] [k (in-naturals 1)]) (* 2.0 k (- u k)))))
  (define-values (found least slope steps) (quasi-newton f (make-flvector n 0.0)))
  (check-true (< (far found '(1.0 2.0 3.0 4.0 5.0 6.0 7.0 8.0)) 1e-7))
  (check-true (< steps (* 3 n))))

;; A constant added leaves no digits of the last of the fall.
(test-case "where rounding hides the fall the gradient leads on"
  (define minimum '(0.3 -0.7 1.1))
  (define ((valley-on height) v)
    (define away (for/list ([u (in-flvector v)] [c (in-list minimum)]) (- u c)))
    (values (for/fold ([sum height]) ([d (in-list away)] [k (in-naturals 1)])
              (+ sum (cosh (* k d))))
            (for/flvector ([d (in-list away)] [k (in-naturals 1)]) (* k (sinh (* k d))))))
  (for ([height '(0.0 1e3 1e6 1e8)])
    (define-values (found least slope steps)
      (quasi-newton (valley-on height) (make-flvector 3 0.0)))
    (check-true (< (far found minimum) 1e-8) (format "~a" height))))

;; x² as (b + x)² − b² − 2bx, beside 3 (y − 1)² + y⁴, which is least where 2y³ + 3y = 3
(test-case "rounding of terms that cancel is that of the greatest value met"
  (define ((cancelling b) v)
    (define-values (u y) (values (x 0 v) (x 1 v)))
    (values (+ (- (* (+ b u) (+ b u)) (* b b) (* 2.0 b u)) (* 3.0 (- y 1.0) (- y 1.0)) (expt y 4))
            (flvector (* 2.0 u) (+ (* 6.0 (- y 1.0)) (* 4.0 y y y)))))
  (for ([b '(1e3 1e5 1e6)])
    (define-values (found least slope steps) (quasi-newton (cancelling b) (flvector 1e3 1e3)))
    (define y (x 1 found))
    (check-= (x 0 found) 0.0 1e-7)
    (check-= (+ (* 2.0 y y y) (* 3.0 y)) 3.0 1e-6)))

(test-case "evaluations are counted, all of them"
  (define calls 0)
  (define (counted f) (lambda (v) (set! calls (+ calls 1)) (f v)))
  (define (check-count f start . options)
    (set! calls 0)
    (define-values (found y count) (nelder-mead (counted f) start))
    (check-equal? count calls))
  (check-count valley (flvector -1.2 1.0))
  (check-count (lambda (v) (abs (- (x 0 v) 3.0))) (flvector 0.0))
  (check-count (lambda (v) (+ (abs (x 0 v)) (sqrt (abs (- (x 1 v) 1.0))) (abs (x 2 v))))
               (flvector 1.0 3.0 -2.0))                       ; shrinks, too
  (set! calls 0)
  (define failure
    (with-handlers ([exn:fail:mechanics:not-convergent? exn-message])
      (nelder-mead (counted valley) (flvector -1.2 1.0) #:limit 40)))
  (check-regexp-match (format "\n  evaluations: ~a\n" calls) failure))

(test-case "in one variable"
  (define-values (v f c) (nelder-mead (lambda (v) (expt (- (x 0 v) 3.0) 2)) (flvector 0.0)))
  (check-true (< (far v '(3.0)) 1e-6)))

(test-case "each point reached is observed, and the function falls"
  (define seen '())
  (quasi-newton valley+gradient
                (flvector -1.2 1.0)
                #:observe (lambda (v f) (set! seen (cons f seen))))
  (check-true (> (length seen) 5))
  (check-true (apply <= seen)))

(test-case "without a minimum there is a failure with the best point"
  (define (slope v) (values (- (x 0 v)) (flvector -1.0)))
  (define-syntax-rule (failure-of search)
    (with-handlers ([exn:fail:mechanics:not-convergent? values]) search))
  (check-regexp-match #rx"^minimize: no minimum found: too many steps\n"
                      (exn-message (failure-of (quasi-newton slope (flvector 0.0) #:limit 50))))
  (define failure (failure-of (nelder-mead (lambda (v) (- (x 0 v))) (flvector 0.0) #:limit 500)))
  (check-regexp-match #rx"^minimize: no minimum found: too many evaluations\n"
                      (exn-message failure))
  ;; a simplex that goes down grows, by half or more in two evaluations
  (check-true (> (car (exn:fail:mechanics:not-convergent-value failure)) 1e30)))
