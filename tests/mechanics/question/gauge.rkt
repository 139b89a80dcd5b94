#lang racket/base
;; Total time derivatives: recognised, and integrated.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt" "../support/random.rkt")

(define line (up 't 'x 'v))
(define plane (up 't (up 'x 'y) (up 'vx 'vy)))

(define (gauge-at F local) (expression (simplify ((gauge-function F local) local))))

(test-case "D_t of a function of time and coordinates"
  (define (F (up t (up x y) (up vx vy))) (+ (* y vx) (* x vy)))
  (check-pred proved? (verify-total-time-derivative F plane))
  (check-equal? (gauge-at F plane) '(* x y)))

(test-case "a curl, and a function quadratic in velocities, are none"
  (define (curl (up t (up x y) (up vx vy))) (- (* x vy) (* y vx)))
  (define v (verify-total-time-derivative curl plane))
  (check-pred refuted? v)
  (check-equal? (expression (verdict-residual v)) '(down (* -2 vy) (* 2 vx)))
  (check-pred refuted? (verify-total-time-derivative (compose square velocity) line)))

(test-case "one for a value of a parameter"
  (define ((F k) (up t x v))
    (- (* 2 x v (cos (* 'omega t))) (* k (square x) (sin (* 'omega t)))))
  (define v (verify-total-time-derivative (F 'k) line))
  (check-equal? (map expression (verdict-conditions v)) '((= k omega)))
  (check-equal? (gauge-at (F 'omega) line) '(* (expt x 2) (cos (* omega t)))))

(test-case "roots, literal functions, accelerations"
  (check-equal? (gauge-at (Dt (compose sqrt square coordinate)) plane)
                '(sqrt (+ (expt x 2) (expt y 2))))
  (define f (literal-function 'f (-> (UP Real Real) Real)))
  (check-equal? (gauge-at (Dt f) line) '(f (up t x)))
  (check-equal? (gauge-at (Dt (* (square velocity) (compose sin coordinate))) (up 't 'x 'v 'a))
                '(* (expt v 2) (sin x)))
  (check-equal? (gauge-at (Dt (* time coordinate velocity acceleration)) (up 't 'x 'v 'a 'j))
                '(* a t v x)))

(test-case "what was added to a Lagrangian: the free particle in a moving frame (exercise 1.29)"
  (define (L (up t q v)) (* 1/2 'm (square v)))
  (define (moving (up t x v)) (+ x (* 'V t)))
  (define added (- (compose L (F->C moving)) L))
  (check-equal? (gauge-at added line) '(+ (* 1/2 (expt V 2) m t) (* V m x))))

;; A polynomial in coordinates times waves of time and of a coordinate.
(define (random-function coordinates)
  (define (term)
    (define powers (for/list ([_ coordinates]) (random 3)))
    (define wave (random-choice sin cos))
    (define slot (random-choice 'time 'coordinate 'none))
    (define c (random-choice 'a 'b (random-rational)))
    (lambda (t qs)
      (* c
         (for/fold ([p 1]) ([q qs] [n powers]) (* p (expt q n)))
         (case slot [(time) (wave (* 'omega t))] [(coordinate) (wave (car qs))] [else 1]))))
  (define terms (list (term) (term) (term)))
  (lambda (local)
    (define q (coordinate local))
    (define qs (if (structure? q) (structure->list q) (list q)))
    (for/fold ([sum 0]) ([f terms]) (+ sum (f (time local) qs)))))

(test-case "total derivatives of random functions are recognised, and the functions found"
  (with-seed 1628
    (for ([k (in-range 30)])
      (define local (if (even? k) line plane))
      (define f (random-function (if (even? k) '(x) '(x y))))
      (define found (gauge-function (Dt f) local))
      (with-check-info (['function (expression (simplify (f local)))])
        (check-pred proved? (verify-total-time-derivative (Dt f) local))
        (check-pred proved? (prove-zero ((Dt (- found f)) local)))))))

(test-case "those with the square of a velocity added are refuted"
  (with-seed 1629
    (for ([_ (in-range 10)])
      (define f (random-function '(x y)))
      (define c (random-rational))
      (define (F local) (+ ((Dt f) local) (* c (square (ref (velocity local) 0)))))
      (define v (verify-total-time-derivative F plane))
      (check-pred refuted? v)
      (check-true (pair? (verdict-witness v))))))

(test-case "without a formula, numbers"
  (define (F (up t x v)) (* (exp (square x)) v))
  (define f (gauge-function F line))
  (check-= (f (up 0 1)) 1.46265174590718161 1e-13)
  (check-= (f (up 5 1 7)) 1.46265174590718161 1e-13)
  (check-= ((D (lambda (x) (f (up 0 x)))) 1.0) (exp 1) 1e-12)
  (check-= ((gauge-function F line #:zero-at (up 0 1)) (up 0 2))
           (- 16.45262776550723 1.46265174590718161)
           1e-11)
  (check-equal? (format "~a" f) "(gauge-function F)")
  (check-exn
   #rx"^gauge-function: F is a total time derivative, but no formula for its integral was found\n"
   (lambda () (f line))))

(test-case "a gauge function prints as the program that computes it, or by its name"
  (define (shown F) (expression (gauge-function F (up 't 'x 'v))))
  (check-equal? (shown (lambda (local) (* (coordinate local) (velocity local))))
                '(lambda ((up t x)) (* 1/2 (expt x 2))))
  (check-equal? (car (shown (lambda (local) (* (exp (square (coordinate local)))
                                               (velocity local)))))
                'gauge-function))

(test-case "what is no total derivative has no gauge function"
  (define (F (up t x v)) (square v))
  (check-exn (lambda (e)
               (and (exn:fail:mechanics? e)
                    (equal? (exn-message e)
                            "gauge-function: F is not a total time derivative\n  its Euler-Lagrange expression: (* 2 xddot)")))
             (lambda () (gauge-function F line))))

(define (F (up t x v)) v)

(says
 [(gauge-function 3 line)
  "gauge-function: expected a function of the local tuple (up t q v); given the number 3"]
 [(verify-total-time-derivative F (up 't 'x))
  "verify-total-time-derivative: expected a local tuple (up t q v ...); given (up t x), an up tuple of 2"]
 [((gauge-function F line) (up 0 (up 1 2)))
  "gauge-function: expected a local tuple like (up t x); given (up 0 (up 1 2)), an up tuple of 2"])

(test-case "an integral does not begin at a singularity"
  (define (turning (up t (up x y) (up vx vy))) (/ (- (* x vy) (* y vx)) (+ (square x) (square y))))
  (define plane (up 't (up 'x 'y) (up 'vx 'vy)))
  (check-exn
   #rx"^gauge-function: the integral for turning cannot begin where it is not finite\n  begin: .up 0 .up 0 0.."
   (lambda () ((gauge-function turning plane) (up 0 (up 1 2)))))
  (check-within ((gauge-function turning plane #:zero-at (up 0 (up 1 0))) (up 0 (up 1 2)))
                (atan 2)
                1e-11))
