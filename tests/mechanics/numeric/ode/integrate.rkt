#lang racket/base
;; Integration of systems whose solutions are known.

(require racket/flonum
         mechanics/error/failure
         mechanics/numeric/ode/bulirsch-stoer
         mechanics/numeric/ode/dormand-prince-54
         mechanics/numeric/ode/dormand-prince-853
         mechanics/numeric/ode/gauss-legendre
         mechanics/numeric/ode/integrate
         mechanics/numeric/ode/doubled-runge-kutta
         mechanics/numeric/ode/radau
         mechanics/numeric/ode/symplectic
         mechanics/numeric/ode/stepper
         tests/mechanics/support/rates
         "../../support/checks.rkt")

(define methods
  (list dormand-prince-853 dormand-prince-54 quality-controlled-runge-kutta-4 bulirsch-stoer
        radau-iia-5))

(define (final m f! y0 start end tolerance)
  (define-values (t y) (integrate m f! y0 start end #:tolerance tolerance))
  (check-equal? t end)
  y)

(define (error-of y expected)
  (for/fold ([worst 0.0]) ([a (in-flvector y)] [b (in-list expected)]) (max worst (abs (- a b)))))

(define 2pi (* 8.0 (atan 1.0)))
(define eccentric (flvector 0.5 0.0 0.0 (sqrt 3.0)))       ; e = 1/2, a = 1: period 2π

(for ([m (in-list methods)])
  (test-case (format "~a: errors follow the tolerance, forwards and backwards" (method-name m))
    (for ([tolerance (in-list '(1e-6 1e-9 1e-12))])
      (check-true (< (error-of (final m oscillator! (flvector 1.0 0.0) 0.0 10.0 tolerance)
                               (list (cos 10.0) (- (sin 10.0))))
                     (* 10 tolerance)))
      (check-true (< (error-of (final m oscillator! (flvector 1.0 0.0) 2.0 -3.0 tolerance)
                               (list (cos 5.0) (sin 5.0)))
                     (* 10 tolerance)))
      (check-true (< (error-of (final m kepler! eccentric 0.0 (* 3 2pi) tolerance)
                               (for/list ([x (in-flvector eccentric)]) x))
                     (* 1000 tolerance)))))

  (test-case (format "~a: halving the step divides the error by 2 to the order" (method-name m))
    ;; one step of length h from a known point, against the solution
    (define (error-after h)
      (define s ((method-start m) oscillator! (flvector 1.0 0.0)))
      ((stepper-try! s) h)
      ((stepper-accept! s))
      (error-of (stepper-state s) (list (cos h) (- (sin h)))))
    (define h (for/first ([h (in-list '(0.4 0.8 1.6 3.2))] #:when (> (error-after h) 1e-11)) h))
    (define ratio (/ (error-after (* 2.0 h)) (error-after h)))
    (check-true (> ratio (expt 2.0 (method-order m))) (format "ratio ~a" ratio)))

  (test-case (format "~a: between the ends of steps the interpolant is as good" (method-name m))
    (define out (make-flvector 2))
    (define worst 0.0)
    (define kept '())
    (define (measure at from to)
      (for ([theta (in-list '(0.0 0.1 0.37 0.5 0.8 1.0))])
        (define t (+ from (* theta (- to from))))
        (at theta out)
        (set! worst (max worst (error-of out (list (cos t) (- (sin t))))))))
    (integrate m oscillator! (flvector 1.0 0.0) 0.0 20.0 #:tolerance 1e-10
               #:visit (lambda (from to interpolant)
                         (set! kept (cons (list (interpolant) from to) kept))
                         #t))
    (for ([k (in-list kept)]) (apply measure k))
    (check-true (< 0.0 worst 1e-9) (format "~a" worst))))

;; ---------------------------------------------------------------------------
;; Methods with a fixed step

(define fixed (list leapfrog yoshida-4 yoshida-6 yoshida-8
                    gauss-legendre-2 gauss-legendre-4 gauss-legendre-6))

(define (energy y) (* 0.5 (+ (expt (flvector-ref y 0) 2) (expt (flvector-ref y 1) 2))))

(for ([make (in-list fixed)])
  (define m (make 0.1))
  (define name (method-name m))

  (test-case (format "~a: halving the step divides the error by 2 to the order" name)
    (define (error-with h)
      (error-of (final (make h) oscillator! (flvector 1.0 0.0) 0.0 8.0 1.0)
                (list (cos 8.0) (- (sin 8.0)))))
    (define h (for/first ([h (in-list '(0.125 0.25 0.5))] #:when (> (error-with h) 1e-11)) h))
    (define ratio (/ (error-with (* 2.0 h)) (error-with h)))
    (define two^order (expt 2.0 (method-order m)))
    (check-true (< (* 0.6 two^order) ratio (* 1.8 two^order)) (format "ratio ~a" ratio)))

  (test-case (format "~a: energy does not drift" name)
    (define-values (early late) (values 0.0 0.0))
    (define y (make-flvector 2))
    (integrate m oscillator! (flvector 1.0 0.0) 0.0 2010.0
               #:visit (lambda (from to interpolant)
                         (when (or (< to 10.0) (> to 2000.0))
                           ((interpolant) 1.0 y)
                           (define e (abs (- (energy y) 0.5)))
                           (if (< to 10.0) (set! early (max early e)) (set! late (max late e))))
                         #t))
    (check-true (< late (* 1.5 (+ 1e-12 early))) (format "~a ~a" early late)))

  (test-case (format "~a: there and back" name)
    (define there (final m kepler! eccentric 0.0 5.0 1.0))
    (check-true (< (error-of (final m kepler! there 5.0 0.0 1.0)
                             (for/list ([x (in-flvector eccentric)]) x))
                   1e-9)))

  (test-case (format "~a: states between steps, and a clock" name)
    (define (f! y dy)
      (flvector-set! dy 0 1.0)
      (flvector-set! dy 1 (flvector-ref y 2))
      (flvector-set! dy 2 (- (flvector-ref y 1))))
    (define out (make-flvector 3))
    (define (close? from to interpolant)
      ((interpolant) 0.3 out)
      (define t (+ from (* 0.3 (- to from))))
      (check-= (flvector-ref out 0) t 1e-12)
      (check-= (flvector-ref out 1) (cos t) 1e-4)
      #t)
    (with-called ([visit close?])
      (integrate (make 0.01) f! (flvector 0.0 1.0 0.0) 0.0 1.0 #:clock 0 #:visit visit))))

(test-case "an implicit step that does not converge stops the integration"
  (define (steep! y dy) (flvector-set! dy 0 (exp (* 10.0 (flvector-ref y 0)))))
  (check-exn #rx"cannot be followed any further"
             (lambda () (integrate (gauss-legendre-4 0.1) steep! (flvector 1.0) 0.0 1.0))))

;; ---------------------------------------------------------------------------

(test-case "the clock is exact and the end is met exactly"
  (define (f! y dy) (flvector-set! dy 0 1.0) (flvector-set! dy 1 (cos (flvector-ref y 0))))
  (define-values (t y)
    (integrate dormand-prince-853 f! (flvector 0.1 (sin 0.1)) 0.1 100.7 #:clock 0
               #:tolerance 1e-12))
  (check-equal? t 100.7)
  (check-equal? (flvector-ref y 0) 100.7)
  (check-= (flvector-ref y 1) (sin 100.7) 1e-11))

(test-case "no step is longer than allowed, and no more than allowed are taken"
  (define steps 0)
  (integrate dormand-prince-853 oscillator! (flvector 1.0 0.0) 0.0 10.0 #:longest 0.1
             #:visit (lambda (from to interpolant)
                       (set! steps (+ steps 1))
                       (check-true (<= (- to from) 0.1000001))
                       #t))
  (check-true (>= steps 100))
  (check-exn exn:fail:mechanics:not-convergent?
             (lambda ()
               (integrate dormand-prince-853 oscillator! (flvector 1.0 0.0) 0.0 10.0 #:limit 3))))

(test-case "a visitor can end the integration"
  (define-values (t y)
    (integrate dormand-prince-853 oscillator! (flvector 1.0 0.0) 0.0 10.0
               #:visit (lambda (from to interpolant) (< to 2.0))))
  (check-true (< 2.0 t 10.0)))

(test-case "where the solution ends, the failure tells the time and the last good state"
  (define (blow-up! y dy) (flvector-set! dy 0 (* (flvector-ref y 0) (flvector-ref y 0))))
  (define failure
    (with-handlers ([exn:fail:mechanics:singular? values])
      (integrate dormand-prince-853 blow-up! (flvector 1.0) 0.0 2.0)))
  (check-regexp-match #rx"time: 1\\.0000" (exn-message failure))
  (check-true (> (flvector-ref (exn:fail:mechanics:singular-where failure) 0) 1e6)))

(test-case "a slope that is not a number stops it, too"
  (define (f! y dy) (flvector-set! dy 0 (if (< (flvector-ref y 0) 2.0) 1.0 +nan.0)))
  (check-exn #rx"cannot be followed any further"
             (lambda () (integrate dormand-prince-853 f! (flvector 0.0) 0.0 5.0))))

(test-case "no time passes"
  (define-values (t y) (integrate dormand-prince-853 oscillator! (flvector 1.0 0.0) 1.0 1.0))
  (check-equal? y (flvector 1.0 0.0)))

;; At 1e16 the next number is 2 away: the steps are that long at least, in both directions.
(test-case "steps that would not change the time are made as long as it takes"
  (define (decaying! y dy) (flvector-set! dy 0 (fl* -0.1 (flvector-ref y 0))))
  (for ([end '(1.0000000000000020e16 0.9999999999999980e16)])
    (define span (- end 1e16))
    (define y (final dormand-prince-853 decaying! (flvector 1.0) 1e16 end 1e-6))
    (check-= (flvector-ref y 0) (exp (* -0.1 span)) (* 1e-3 (exp (* -0.1 span))))))
