#lang racket/base
;; Stiff systems: what dies out at once, and what stays.

(require racket/flonum
         rackunit
         mechanics/numeric/failure
         mechanics/numeric/ode/differentiated mechanics/numeric/ode/dormand-prince-853
         mechanics/numeric/ode/integrate mechanics/numeric/ode/radau
         mechanics/numeric/ode/stepper)

;; -> the state at the end and the number of steps
(define (follow m f! y0 end tolerance #:limit [limit +inf.0])
  (define steps 0)
  (define-values (t y)
    (integrate m f! y0 0.0 end #:tolerance tolerance #:limit limit
               #:visit (lambda (from to interpolant) (set! steps (+ steps 1)) #t)))
  (values y steps))

(define (after-steps f! y0 h count)
  (define s ((method-start radau-iia-5) f! y0))
  (for ([_ (in-range count)])
    ((stepper-try! s) h)
    ((stepper-accept! s)))
  (stepper-state s))

(define (decay! y dy) (flvector-set! dy 0 (- (flvector-ref y 0))))
(define (pendulum! y dy)
  (flvector-set! dy 0 (flvector-ref y 1))
  (flvector-set! dy 1 (- (sin (flvector-ref y 0)))))

(test-case "the error of a step is of order 6, that of many steps of order 5"
  (define (error-of-one h)
    (- (flvector-ref (after-steps decay! (flvector 1.0) h 1) 0) (exp (- h))))
  (check-= (/ (error-of-one 0.1) (error-of-one 0.05)) 64 5)
  (check-= (error-of-one 0.05) (/ (expt 0.05 6) 7200) 2e-13)      ; Padé: h^6/7200
  (define-values (y _) (follow dormand-prince-853 pendulum! (flvector 2.0 0.0) 4.0 1e-13))
  (define (error-of-many count)
    (- (flvector-ref (after-steps pendulum! (flvector 2.0 0.0) (/ 4.0 count) count) 0)
       (flvector-ref y 0)))
  (check-= (/ (error-of-many 20) (error-of-many 40)) 32 8))

(test-case "the estimate of the error is of order 4"
  (define (f! y dy) (flvector-set! dy 0 (cos (flvector-ref y 0))))
  (define (estimate h) ((stepper-try! ((method-start radau-iia-5) f! (flvector 0.1))) h))
  (check-= (/ (estimate 0.02) (estimate 0.01)) 16 2))

;; Slopes -1, -1000 and -10^6 along skew directions.
(define (linear! y dy)
  (define-values (a b c) (values (flvector-ref y 0) (flvector-ref y 1) (flvector-ref y 2)))
  (flvector-set! dy 0 (+ (- a) (* 999.0 b) (* 999000.0 c)))
  (flvector-set! dy 1 (+ (* -1000.0 b) (* -999000.0 c)))
  (flvector-set! dy 2 (* -1e6 c)))

(test-case "a linear system of slopes 1 to 10^6 takes few steps and is right"
  (for ([tolerance (in-list '(1e-4 1e-6 1e-8))])
    ;; eigenvectors (1 0 0), (-1 1 0), (-1 1 1): together (-1 2 1)
    (define-values (y steps) (follow radau-iia-5 linear! (flvector -1.0 2.0 1.0) 3.0 tolerance))
    (define a (exp -3.0))
    (check-= (flvector-ref y 0) a (* 10 tolerance))
    (check-= (flvector-ref y 1) 0.0 (* 10 tolerance))
    (check-= (flvector-ref y 2) 0.0 (* 10 tolerance))
    (check-true (< steps 1500) (format "~a steps" steps)))
  (check-exn exn:fail:mechanics:not-convergent?
             (lambda ()
               (follow dormand-prince-853 linear! (flvector -1.0 2.0 1.0) 3.0 1e-6 #:limit 10000))))

(test-case "what dies out within one step leaves nothing, however long the step"
  (define (f! y dy) (flvector-set! dy 0 (* -1e8 (flvector-ref y 0))))
  (define s ((method-start radau-iia-5) f! (flvector 1.0)))
  ((stepper-try! s) 1.0)
  ((stepper-accept! s))
  (check-= (flvector-ref (stepper-state s) 0) 0.0 1e-7))

;; Van der Pol's oscillator for a large damping: 1.7061677321704833 and
;; -8.928097010248257e-4 at 2000 (Hairer and Wanner's test set, 12 digits).
(define ((van-der-pol! mu) y dy)
  (define-values (x v) (values (flvector-ref y 0) (flvector-ref y 1)))
  (flvector-set! dy 0 v)
  (flvector-set! dy 1 (- (* mu (- 1.0 (* x x)) v) x)))

(define ((van-der-pol-jacobian! mu) y J)
  (define-values (x v) (values (flvector-ref y 0) (flvector-ref y 1)))
  (flvector-set! J 0 0.0)
  (flvector-set! J 1 (- (* -2.0 mu x v) 1.0))
  (flvector-set! J 2 1.0)
  (flvector-set! J 3 (* mu (- 1.0 (* x x)))))

(test-case "van der Pol's oscillator jumps and is followed, by derivatives or by differences"
  (define exact (differentiated (van-der-pol! 1000.0) (van-der-pol-jacobian! 1000.0)))
  (for ([f! (in-list (list exact (van-der-pol! 1000.0)))])
    (define-values (y steps) (follow radau-iia-5 f! (flvector 2.0 0.0) 2000.0 1e-8))
    (check-= (flvector-ref y 0) 1.7061677321704833 1e-8)
    (check-= (flvector-ref y 1) -8.928097010248257e-4 1e-10)
    (check-true (< steps 4000) (format "~a steps" steps))))

(test-case "differences are the derivatives to half the digits"
  (define y (flvector 1.3 -0.4))
  (define-values (J K) (values (make-flvector 4) (make-flvector 4)))
  ((van-der-pol-jacobian! 3.0) y J)
  ((jacobian-of (van-der-pol! 3.0) 2) y K)
  (for ([a (in-flvector J)] [b (in-flvector K)]) (check-= a b 1e-6))
  (check-equal? y (flvector 1.3 -0.4)))

(test-case "wrong derivatives cost steps but do not make it wrong"
  (define (zero! y J) (for ([k (in-range 4)]) (flvector-set! J k 0.0)))
  (define f! (differentiated (van-der-pol! 1.0) zero!))
  (define-values (y _) (follow radau-iia-5 f! (flvector 2.0 0.0) 5.0 1e-8))
  (define-values (z __) (follow dormand-prince-853 (van-der-pol! 1.0) (flvector 2.0 0.0) 5.0 1e-12))
  (check-= (flvector-ref y 0) (flvector-ref z 0) 1e-7))

(test-case "a singularity is reached and reported"
  (define (f! y dy) (flvector-set! dy 0 (* (flvector-ref y 0) (flvector-ref y 0))))
  (check-exn #rx"cannot be followed any further"
             (lambda () (follow radau-iia-5 f! (flvector 1.0) 2.0 1e-8))))
