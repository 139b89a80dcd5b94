#lang racket/base
;; The error function is an operation like others: numbers, derivatives, series, balls, compiled
;; code, programs in other languages, notation.

(require racket/file
         racket/flonum
         (prefix-in m: mechanics)
         (only-in math/special-functions [erf math:erf])
         mechanics/algebra/expression/numeric-functions
         mechanics/algebra/expression/read
         mechanics/algebra/assumption/interval
         (only-in mechanics/algebra/notation/read-infix infix->datum)
         (only-in mechanics/algebra/ball/ball exact->ball ball-lower ball-upper ball-scale)
         (only-in mechanics/algebra/ball/ball-functions ball-erf)
         mechanics/compile/Racket-code mechanics/compile/program mechanics/compile/derivative-sweep
         mechanics/compile/trace
         (only-in mechanics/show/typesetting/TeX tree->TeX)
         (only-in mechanics/algebra/notation/formula plain-datum->tree)
         "../support/checks.rkt"
         "../support/bigfloats.rkt" "../support/exported.rkt" "../support/random.rkt"
         "../support/skip.rkt")

(define (slope x) (* (/ 2 (sqrt m:pi)) (exp (- (* x x)))))

(test-case "its numbers are right to a few units of the last place"
  (with-seed 401
    (for ([_ (in-range 200)])
      (define x (- (* 14 (random)) 7))
      (check-= (erf x) (math:erf x) (* 2e-15 (abs (math:erf x))))))
  (check-equal? (map erf '(0 0.0 +inf.0 -inf.0)) '(0 0.0 1.0 -1.0))
  (check-false (= (erf +nan.0) (erf +nan.0)))
  (check-= (erf 1e-20) (* 1e-20 (/ 2 (sqrt m:pi))) 1e-35))

(test-case "its derivative, as a form and as numbers"
  (check-equal? (format "~a" (m:simplify ((m:D m:erf) 'x)))
                "(/ (* 2 (exp (* -1 (expt x 2)))) (sqrt :pi))")
  (check-true (m:proved? (m:verify-equal ((m:D m:erf) 'x)
                                         (m:/ (m:* 2 (m:exp (m:negate (m:square 'x))))
                                              (m:sqrt ':pi)))))
  (for ([x '(-1.5 0.0 0.3 2.0)])
    (check-= ((m:D m:erf) x) (slope x) 1e-15)
    (check-= (((m:expt m:D 2) m:erf) x) (* -2 x (slope x)) 1e-14))
  (check-= ((m:D m:erf) 0) (/ 2 (sqrt m:pi)) 1e-15))

(test-case "its power series is that of the book"
  (define s ((m:Taylor-series m:erf) 0.0))
  (for ([k (in-range 8)]
        [c (list 0 1 0 -1/3 0 1/10 0 -1/42)])
    (check-= (m:series:ref s k) (* c (/ 2 (sqrt m:pi))) 1e-14)))

(test-case "balls hold its value, and tell it from others"
  (skip-unless bigfloats? no-bigfloats
    (with-seed 402
      (for* ([p '(60 200)] [x '(1/1000000 1/3 1 -5/2 4 9 -30)])
        (define b (ball-erf (exact->ball x (+ p 20)) p))
        (define true
          (parameterize ([(big 'bf-precision) (+ p 60)])
            ((big 'bigfloat->rational) ((big 'bferf) ((big 'bf) x)))))
        (define unit (expt 2 (ball-scale b)))
        (check-true (<= (* unit (ball-lower b)) true (* unit (ball-upper b))) (format "~a" x))
        (check-true (< (* unit (- (ball-upper b) (ball-lower b))) (expt 2 (- 4 p)))))))
  (check-true (m:refuted? (m:verify-equal (m:erf 1/2) 52/100)))
  (check-true (m:refuted? (m:verify-equal (m:erf 'x) (m:atan 'x)))))

(test-case "intervals hold its values"
  (define i (interval-of-operation 'erf (interval -1 2)))
  (check-true (<= -8427008/10000000 (interval-low i) -842700/1000000))
  (check-true (<= 995322/1000000 (interval-high i) 1)))

(test-case "compiled code computes it, and sweeps give its derivative"
  (define (f v) (m:* (m:ref v 1) (m:erf (m:ref v 0))))
  (define-values (p shape) (trace 'test f (m:up 0.5 2.0)))
  (define (outputs p)
    (define out (make-flvector (vector-length (program-outputs p))))
    (((program->maker p)) (flvector 0.5 2.0) out)
    out)
  (check-= (flvector-ref (outputs p) 0) (* 2 (math:erf 0.5)) 1e-15)
  (define gradient (outputs (program-with-gradient p)))
  (check-= (flvector-ref gradient 1) (* 2 (slope 0.5)) 1e-15)
  (check-= (flvector-ref gradient 2) (math:erf 0.5) 1e-15))

(test-case "programs in other languages call theirs"
  (define pulled
    (m:Lagrangian->state-derivative
     (lambda (s) (m:- (m:* 1/2 (m:square (m:velocity s)))
                      (m:* (m:erf (m:coordinate s)) (m:square (m:coordinate s)))))))
  (define (text target file)
    (define folder (make-temporary-file "erf~a" 'directory))
    (m:export-system pulled (m:up 't 'x 'xdot) #:language target #:name "pulled" #:folder folder
                     #:replace? #t)
    (begin0 (file->string (build-path folder file))
            (delete-directory/files folder)))
  (check-regexp-match #rx"[^_]erf[(]" (text 'C "pulled.c"))
  (check-regexp-match #rx"jax.scipy.special.erf[(]" (text 'JAX "pulled.py"))
  (skip-unless compiler? "there is no compiler of C"
    (call-with-export
     (lambda (folder library)
       (define rates ((exported-function library "pulled_derivative" 3) (flvector 0.0 0.7 0.1)
                                                                        (flvector)))
       (check-= (flvector-ref rates 2)
                (- (+ (* 0.49 (slope 0.7)) (* 1.4 (math:erf 0.7))))
                1e-14))
     "pulled" pulled (m:up 't 'x 'xdot))))

(test-case "a motion in its field keeps the energy"
  (define (L s)
    (m:- (m:* 1/2 (m:square (m:velocity s))) (m:erf (m:square (m:coordinate s)))))
  (define q (m:evolve-trajectory (m:Lagrangian->state-derivative L) (m:up 0 0.7 0.0) 5))
  (define energy (m:Lagrangian->energy L))
  (check-= (energy (q 5)) (energy (m:up 0 0.7 0.0)) 1e-8))

(test-case "it is read as it is printed, and typeset"
  (check-equal? (format "~a" (m:erf 'x)) "(erf x)")
  (check-equal? (datum->expression '(erf x)) (m:erf 'x))
  (check-equal? (infix->datum "erf(x)²") '(expt (erf x) 2))
  (check-equal? (tree->TeX (plain-datum->tree '(erf (/ x 2))))
                "\\operatorname{erf}\\left(\\frac{x}{2}\\right)"))
