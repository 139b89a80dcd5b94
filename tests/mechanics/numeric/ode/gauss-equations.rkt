#lang racket/base
;; Gauss–Legendre methods where their equations are not solved by repetition: stiff systems.

(require racket/flonum
         mechanics/numeric/ode/rates-with-jacobian
         mechanics/numeric/ode/gauss-legendre
         mechanics/numeric/ode/integrate
         mechanics/numeric/ode/stepper
         "../../support/checks.rkt")

;; How far the state is after some steps, and how many evaluations and sets of derivatives
;; that took.
(define (follow m f! y0 steps [jacobian! #f])
  (define-values (evaluations derivatives) (values 0 0))
  (define (counted! y dy)
    (set! evaluations (+ evaluations 1))
    (f! y dy))
  (define s
    (start-stepper m
                   (if jacobian!
                       (differentiated counted! (lambda (y J)
                                                  (set! derivatives (+ derivatives 1))
                                                  (jacobian! y J)))
                       counted!)
                   y0 1e-10))
  (for ([_ (in-range steps)])
    (check-equal? ((stepper-try! s) (method-step m)) 0.0)
    ((stepper-accept! s)))
  (values (stepper-state s) evaluations derivatives))

(define methods (list gauss-legendre-2 gauss-legendre-4 gauss-legendre-6))

;; The diagonal Padé approximations of exp, which a step multiplies y by if y' = y z/h
(define (Pade order z)
  (define p
    (case order
      [(2) (lambda (z) (+ 1.0 (/ z 2.0)))]
      [(4) (lambda (z) (+ 1.0 (/ z 2.0) (/ (* z z) 12.0)))]
      [(6) (lambda (z) (+ 1.0 (/ z 2.0) (/ (* z z) 10.0) (/ (* z z z) 120.0)))]))
  (/ (p z) (p (- z))))

(test-case "a step of a linear equation multiplies by Padé's approximation, however stiff it is"
  (for* ([make (in-list methods)] [slope (in-list '(-0.3 -1.0 -30.0 -1e4 -1e8))])
    (define (f! y dy) (flvector-set! dy 0 (* slope (flvector-ref y 0))))
    (define (jacobian! y J) (flvector-set! J 0 slope))
    (define m (make 0.5))
    (define factor (Pade (method-order m) (* 0.5 slope)))
    (for ([J (in-list (list jacobian! #f))])
      (define-values (y _ derivatives) (follow m f! (flvector 1.0) 5 J))
      (check-= (flvector-ref y 0) (expt factor 5) (* 1e-13 (expt (max 1.0 (abs factor)) 5)))
      (check-true (<= derivatives (if (< (abs slope) 2.0) 0 1))))))

;; A stiff spring that turns: coordinates x and y, momenta
(define ((spring! k) s ds)
  (define-values (x y px py)
    (values (flvector-ref s 0) (flvector-ref s 1) (flvector-ref s 2) (flvector-ref s 3)))
  (define r (sqrt (+ (* x x) (* y y))))
  (define pull (* -1.0 k (/ (- r 1.0) r)))
  (flvector-set! ds 0 px)
  (flvector-set! ds 1 py)
  (flvector-set! ds 2 (* pull x))
  (flvector-set! ds 3 (* pull y)))

(define (energy k s)
  (define-values (x y px py)
    (values (flvector-ref s 0) (flvector-ref s 1) (flvector-ref s 2) (flvector-ref s 3)))
  (+ (* 0.5 (+ (* px px) (* py py))) (* 0.5 k (expt (- (sqrt (+ (* x x) (* y y))) 1.0) 2))))

(define (angular-momentum s)
  (- (* (flvector-ref s 0) (flvector-ref s 3)) (* (flvector-ref s 1) (flvector-ref s 2))))

;; It is a square, which these methods keep (Hairer, Lubich and Wanner, IV.2.1): if their equations
;; are solved.
(test-case "angular momentum is kept by steps much longer than the period of the spring"
  (define k 1e6)
  (for ([make (in-list methods)])
    (define-values (s evaluations _)
      (follow (make 0.02) (spring! k) (flvector 1.0 0.0 0.0 1.0) 400))
    (check-= (angular-momentum s) 1.0 1e-10)
    (check-= (energy k s) 0.5 0.01)))

(test-case "where repetition converges fast, nothing else is done"
  (define (f! y dy)
    (flvector-set! dy 0 (flvector-ref y 1))
    (flvector-set! dy 1 (- (sin (flvector-ref y 0)))))
  (define (jacobian! y J) (error "not to be asked for"))
  (for ([make (in-list methods)])
    (define-values (y evaluations derivatives)
      (follow (make 0.1) f! (flvector 2.0 0.0) 100 jacobian!))
    (check-equal? derivatives 0)))

(test-case "equations without a solution end the motion; so do rates that are no numbers"
  (define (steep! y dy) (flvector-set! dy 0 (exp (* 10.0 (flvector-ref y 0)))))
  (define (broken! y dy) (flvector-set! dy 0 (if (> (flvector-ref y 0) 1.0) +nan.0 1.0)))
  (for ([make (in-list methods)])
    (check-exn #rx"cannot be followed any further"
               (lambda () (integrate (make 0.1) steep! (flvector 1.0) 0.0 1.0)))
    (check-exn #rx"cannot be followed any further"
               (lambda () (integrate (make 0.1) broken! (flvector 0.0) 0.0 3.0)))))

(test-case "between the ends of stiff steps, and to an end within a step"
  (define (f! y dy) (flvector-set! dy 0 (* -1e4 (- (flvector-ref y 0) 1.0))))
  (define (close? from to interpolant)
    (define out (flvector 0.0))
    ((interpolant) 0.3 out)
    (check-= (flvector-ref out 0) 1.0 1e-12)
    #t)
  (define-values (t y)
    (with-called ([visit close?])
      (integrate (gauss-legendre-4 0.1) f! (flvector 1.0) 0.0 1.03 #:visit visit)))
  (check-= t 1.03 0.0)
  (check-= (flvector-ref y 0) 1.0 1e-12))
