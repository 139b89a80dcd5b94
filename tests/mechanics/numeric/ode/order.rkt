#lang racket/base
;; How the error falls with the length of the steps: each method's order is measured as the
;; slope of log error against log h, over steps of one length that divide a given time, and
;; so is that of the states between the ends of a step.

(require racket/flonum racket/math
         mechanics/numeric/ode/bulirsch-stoer
         mechanics/numeric/ode/dormand-prince-54 mechanics/numeric/ode/dormand-prince-853
         mechanics/numeric/ode/gauss-legendre mechanics/numeric/ode/doubled-runge-kutta
         mechanics/numeric/ode/radau mechanics/numeric/ode/stepper
         mechanics/numeric/ode/symplectic
         "../../support/checks.rkt")

;; f! : right-hand side; exact : t -> state
(struct problem (f! exact start))

;; A pendulum that goes from the bottom to the top: θ = 2 asin(tanh t), θ' = 2/cosh t.
(define separatrix
  (problem (lambda (y dy)
             (flvector-set! dy 0 (flvector-ref y 1))
             (flvector-set! dy 1 (- (sin (flvector-ref y 0)))))
           (lambda (t) (flvector (* 2.0 (asin (tanh t))) (/ 2.0 (cosh t))))
           -1.5))

(define oscillator
  (problem (lambda (y dy)
             (flvector-set! dy 0 (flvector-ref y 1))
             (flvector-set! dy 1 (- (flvector-ref y 0))))
           (lambda (t) (flvector (cos t) (- (sin t))))
           0.0))

(define (distance v w)
  (sqrt (for/sum ([x (in-flvector v)] [y (in-flvector w)]) (expt (- x y) 2))))

;; ---------------------------------------------------------------------------

;; The error after n steps through a time.
(define ((global-error p make time) n)
  (define h (/ time n))
  (define s ((method-start (make h)) (problem-f! p) ((problem-exact p) (problem-start p))))
  (for ([_ (in-range n)])
    ((stepper-try! s) h)
    ((stepper-accept! s)))
  (distance (stepper-state s) ((problem-exact p) (+ (problem-start p) time))))

;; The greatest error within the first of n steps.
(define ((inner-error p make time) n)
  (define h (/ time n))
  (define start (problem-start p))
  (define s ((method-start (make h)) (problem-f! p) ((problem-exact p) start)))
  ((stepper-try! s) h)
  ((stepper-accept! s))
  (define interpolate ((stepper-interpolant s)))
  (define out (make-flvector 2))
  (for/fold ([worst 0.0]) ([theta (in-list '(0.15 0.3 0.45 0.6 0.75 0.9))])
    (interpolate theta out)
    (max worst (distance out ((problem-exact p) (+ start (* theta h)))))))

;; The slope of log error against log h by least squares.
(define (measured-order error-with ns)
  (define points (for/list ([n (in-list ns)]) (cons (- (log n)) (log (error-with n)))))
  (define (mean f) (/ (for/sum ([p (in-list points)]) (f p)) (length points)))
  (define x (mean car))
  (define y (mean cdr))
  (/ (mean (lambda (p) (* (- (car p) x) (- (cdr p) y))))
     (mean (lambda (p) (expt (- (car p) x) 2)))))

(define (check-order what order error-with ns)
  (define measured (measured-order error-with ns))
  (test-case (format "~a is of order ~a" what order)
    (check-true (< (abs (- measured order)) (* 0.08 order)) (format "measured ~a" measured))))

;; ---------------------------------------------------------------------------

(define ((adaptive m) h) m)

;; method of step h, order of its error after many steps and within a step, problem, time,
;; and into how many steps it is divided: short enough for the order to show, long enough
;; for rounding not to
(define table
  (list
   (list (adaptive dormand-prince-853) 8 8 separatrix 3.0 '(20 24 28 32) '(12 16 24 32))
   (list (adaptive dormand-prince-54) 5 5 separatrix 3.0 '(32 64 128 192) '(16 32 64 128))
   (list (adaptive quality-controlled-runge-kutta-4) 5 6 separatrix 3.0
         '(16 32 64 128) '(16 32 64 96))
   (list (adaptive bulirsch-stoer) 16 17 oscillator 40.0 '(8 10 12 16) '(7 8 10 12))
   (list (adaptive radau-iia-5) 5 4 separatrix 3.0 '(12 24 48 96) '(24 48 96 192))
   (list leapfrog 2 3 separatrix 3.0 '(32 64 128 256) '(16 32 64 128))
   (list yoshida-4 4 5 separatrix 3.0 '(16 32 64 128) '(16 32 64 128))
   (list yoshida-6 6 7 separatrix 3.0 '(8 16 32 64) '(8 16 32 64))
   (list yoshida-8 8 9 separatrix 3.0 '(12 16 24 48) '(8 12 16 24))
   (list gauss-legendre-2 2 3 separatrix 3.0 '(16 32 64 128) '(16 32 64 128))
   (list gauss-legendre-4 4 5 separatrix 3.0 '(16 32 64 128) '(16 32 64 128))
   (list gauss-legendre-6 6 7 separatrix 3.0 '(8 16 32 64) '(8 16 32 48))))

(for ([row (in-list table)])
  (define-values (make order inner-order p time ns inner-ns) (apply values row))
  (define name (method-name (make 0.1)))
  (check-order name order (global-error p make time) ns)
  (check-order (format "~a within a step" name) inner-order
               (inner-error p make time) inner-ns))

(test-case "a method of a lower order is found out"
  (check-false
   (< (abs (- 5 (measured-order (global-error separatrix yoshida-4 3.0) '(16 32 64 128)))) 0.4)))
