#lang racket/base
;; Constants that met were combined even where their product is beyond the flonums:
;; 1e200 (1e200 x) was infinite, and 1e-200 (1e-200 x) zero, for every x.

(require racket/flonum
         (except-in mechanics format)
         "../support/checks.rkt" "../support/random.rkt")

;; Of the function, of its code, and of its expression; equal up to rounding.
(define-check (check-everywhere f x)
  (define value (exact->inexact (f x)))
  (define code (compile-function f 1.0))
  (define results
    (list (flvector-ref (code (flvector x)) 0)
          (exact->inexact (substitute (f 'x) 'x x))))
  (with-check-info (['value value] ['results results])
    (when (compiled-function-reason code) (fail-check "not compiled"))
    (unless (for/and ([y results]) (close? y value)) (fail-check))))

(define (close? x y) (or (equal? x y) (<= (abs (- x y)) (* 1e-12 (abs y)))))

(test-case "products and quotients that leave the flonums and come back"
  (check-everywhere (lambda (x) (/ (* 1e200 x) 1e-200)) 1e-250)
  (check-everywhere (lambda (x) (* 1e-200 (* 1e-200 x))) 1e300)
  (check-everywhere (lambda (x) (* (* x 1e200) 1e200)) 1e-250)
  (check-everywhere (lambda (x) (* (* 1e200 x) (* 1e200 x))) 1e-250)
  (check-everywhere (lambda (x) (* 1e-160 (sin (* 1e-150 (* 1e-200 x))))) 1e300)
  (check-everywhere (lambda (x) (/ x 1e-320)) 1e-310)
  (check-everywhere (lambda (x) (/ x 1.5e308)) 1e308))

(test-case "sums, too"
  (check-everywhere (lambda (x) (+ 1e308 (+ x 1e308))) -1e308)
  (check-everywhere (lambda (x) (+ (+ 1e308 x) (+ 1e308 x))) -0.8e308)
  (check-everywhere (lambda (x) (+ (* 1e308 x) (* 1e308 x))) 1e-3))

(test-case "exact constants of any size"
  (define big (expt 10 400))
  (check-everywhere (lambda (x) (* big x)) 1e-300)
  (check-everywhere (lambda (x) (/ x big)) 1e300)
  (check-everywhere (lambda (x) (* (expt 10 200) (* (expt 10 200) x))) 1e-250)
  (check-everywhere (lambda (x) (* (expt 10 -200) (* (expt 10 -200) x))) 1e250)
  (check-everywhere (lambda (x) (/ big x)) 1e200)
  (check-everywhere (lambda (x) (+ (* big x) (* (- big 1) x))) 1e-300))

(test-case "what fits is combined as before"
  (check-equal? (format "~a" (* 2.0 (* 3.0 'x))) "(* 6.0 x)")
  (check-equal? (format "~a" (* 1e-300 (* 1e-200 'x))) "(* 1e-300 (* 1e-200 x))")
  (check-equal? (format "~a" (* 0.0 (* 1e-200 'x))) "(* 0.0 x)")
  (check-equal? (format "~a" (* -1 (* 1e-320 'x))) "(* -1e-320 x)")
  (check-equal? (format "~a" (/ 'x 0.0)) "(* +inf.0 x)")
  (check-equal? (compiled-function-operations
                 (compile-function (lambda (x) (* 1e150 (* 1e150 x))) 1e-10))
                1))

;; Chains of such steps, at random.
(test-case "wherever the function has a normal value, its code has it"
  (define (random-constant) (* (random-flonum) (expt 10.0 (random-integer -250 250))))
  (define (random-step)
    (define c (random-constant))
    (define d (* c (+ 1.0 (random))))
    (case (random 6)
      [(0 1) (lambda (x) (* c x))]
      [(2) (lambda (x) (/ x c))]
      [(3) (lambda (x) (- (* c x) (* d x)))]
      [(4) (lambda (x) (* (inexact->exact c) x))]
      [else (lambda (x) (- (* c x)))]))
  (define (normal? x) (< 1e-290 (abs x) 1e290))
  (define tried 0)
  (with-seed 1012
    (for ([_ 1500])
      (define steps (for/list ([_ (random-integer 2 4)]) (random-step)))
      (define x (* (random-flonum) (expt 10.0 (random-integer -290 290))))
      (define-values (value all-normal?)
        (for/fold ([y x] [all? (normal? x)]) ([s steps])
          (define z (if all? (s y) y))
          (values z (and all? (normal? z)))))
      (when all-normal?
        (set! tried (+ tried 1))
        (check-everywhere (lambda (x) (for/fold ([y x]) ([s steps]) (s y))) x)))
    (check-true (> tried 50) (format "~a" tried))))
