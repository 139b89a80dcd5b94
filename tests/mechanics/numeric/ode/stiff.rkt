#lang racket/base
;; Stiff systems: what dies out at once, and what stays.

(require racket/flonum
         mechanics/error/failure
         mechanics/numeric/ode/rates-with-jacobian
         mechanics/numeric/ode/dormand-prince-853
         mechanics/numeric/ode/integrate
         mechanics/numeric/ode/radau
         mechanics/numeric/ode/stepper
         "../../support/checks.rkt" "../../support/close.rkt")

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

;; ---------------------------------------------------------------------------
;; The problems by which stiff methods are judged, with the reference values of the Test
;; Set for IVP Solvers (Mazzia and Magherini 2008).

;; -> the state at the end, and how many steps, evaluations and sets of derivatives it took
(define (count-work f! jacobian! y0 end tolerance)
  (define-values (steps evaluations derivatives) (values 0 0 0))
  (define counted
    (differentiated (lambda (y dy)
                      (set! evaluations (+ evaluations 1))
                      (f! y dy))
                    (lambda (y J)
                      (set! derivatives (+ derivatives 1))
                      (jacobian! y J))))
  (define-values (t y)
    (integrate radau-iia-5 counted y0 0.0 end #:tolerance tolerance
               #:visit (lambda (from to interpolant) (set! steps (+ steps 1)) #t)))
  (values y steps evaluations derivatives))

;; Chemical reactions of rates 0.04, 10^4 and 3·10^7.
(define (robertson! y dy)
  (define-values (a b c) (values (flvector-ref y 0) (flvector-ref y 1) (flvector-ref y 2)))
  (define-values (slow fast back) (values (* 0.04 a) (* 3e7 b b) (* 1e4 b c)))
  (flvector-set! dy 0 (- back slow))
  (flvector-set! dy 1 (- slow back fast))
  (flvector-set! dy 2 fast))

(define (robertson-jacobian! y J)
  (define-values (b c) (values (flvector-ref y 1) (flvector-ref y 2)))
  (for ([k (in-naturals)]
        [x (in-list (list -0.04 0.04 0.0
                          (* 1e4 c) (- (* -1e4 c) (* 6e7 b)) (* 6e7 b)
                          (* 1e4 b) (* -1e4 b) 0.0))])
    (flvector-set! J k x)))

(test-case "Robertson's reactions, to the time 40 and to 10^11"
  (for ([end (in-list '(40.0 1e11))]
        [expected (in-list '((0.7158270687193941 0.9185534764557338e-5 0.2841637457458413)
                             (0.2083340149701255e-7 0.8333360770334713e-13 0.9999999791665050)))]
        [most (in-list '(200 900))])
    (define-values (y steps evaluations derivatives)
      (count-work robertson! robertson-jacobian! (flvector 1.0 0.0 0.0) end 1e-8))
    (check-close y expected 1e-9)
    (check-true (< steps most) (format "~a steps" steps))
    (check-true (< evaluations (* 10 steps)) (format "~a evaluations" evaluations))
    (check-true (< derivatives (/ steps 2)) (format "~a derivatives" derivatives))))

;; High irradiance response: eight reactions of plants to light.
(define (hires! y dy)
  (define-values (a b c d e f g h) (apply values (for/list ([x (in-flvector y)]) x)))
  (define joining (* 280.0 f h))
  (for ([k (in-naturals)]
        [x (in-list (list (+ (* -1.71 a) (* 0.43 b) (* 8.32 c) 0.0007)
                          (- (* 1.71 a) (* 8.75 b))
                          (+ (* -10.03 c) (* 0.43 d) (* 0.035 e))
                          (+ (* 8.32 b) (* 1.71 c) (* -1.12 d))
                          (+ (* -1.745 e) (* 0.43 f) (* 0.43 g))
                          (+ (- joining) (* 0.69 d) (* 1.71 e) (* -0.43 f) (* 0.69 g))
                          (- joining (* 1.81 g))
                          (- (* 1.81 g) joining)))])
    (flvector-set! dy k x)))

(test-case "HIRES, by derivatives that are differences"
  (for ([tolerance (in-list '(1e-5 1e-8))] [most (in-list '(100 500))])
    (define-values (y steps)
      (follow radau-iia-5 hires! (flvector 1.0 0.0 0.0 0.0 0.0 0.0 0.0 0.0057) 321.8122 tolerance))
    (check-close y '(0.7371312573325668e-3 0.1442485726316185e-3 0.5888729740967575e-4
                     0.1175651343283149e-2 0.2386356198831331e-2 0.6238968252742796e-2
                     0.2849998395185769e-2 0.2850001604814231e-2)
                 tolerance)
    (check-true (< steps most) (format "~a steps" steps))))

(define (linear-jacobian! y J)
  (for ([k (in-naturals)]
        [x (in-list '(-1.0 0.0 0.0 999.0 -1000.0 0.0 999000.0 -999000.0 -1e6))])
    (flvector-set! J k x)))

(test-case "derivatives are taken again only where they have changed"
  (define-values (y steps evaluations derivatives)
    (count-work (van-der-pol! 1000.0)
                (van-der-pol-jacobian! 1000.0)
                (flvector 2.0 0.0)
                2000.0
                1e-8))
  (check-true (< derivatives (/ steps 4)) (format "~a of ~a" derivatives steps))
  (define-values (z steps* evaluations* derivatives*)
    (count-work linear! linear-jacobian! (flvector -1.0 2.0 1.0) 3.0 1e-6))
  (check-true (<= derivatives* 3) (format "~a of ~a" derivatives* steps*)))

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
