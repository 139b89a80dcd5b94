#lang racket/base
;; Which method integrates: the name of an adaptive one, as the book gives it, or a
;; method made with a fixed step; and in numbers of how many bits.
;;
;; The names are here, the methods are loaded when one is used.

(require "../error/complain.rkt" "../error/spelling.rkt"
         "../generic/describe.rkt" "../generic/wrong-argument.rkt"
         "../numeric/ode/stepper.rkt")

(provide ode-integration-method set-ode-integration-method! integration-method?
         check-method
         ode-precision check-precision)

;; auto : Taylor where it can be, Dormand-Prince-853 elsewhere
(define names
  '(auto Taylor Dormand-Prince-853 Dormand-Prince-54 bulirsch-stoer qcrk4 Radau-IIA-5))

;; procedures of a step, which are methods when they are given one
(define made-with-a-step
  '(leapfrog Yoshida-4 Yoshida-6 Yoshida-8
    Gauss-Legendre-2 Gauss-Legendre-4 Gauss-Legendre-6))

(define (integration-method? x) (or (method? x) (and (memq x names) #t)))

(define (check-method who m)
  (unless (integration-method? m)
    (complain who "expected a method of integration or the name of one\n  given: ~a\n  ~a"
              (describe-with-value m)
              (advice m)))
  m)

(define (advice m)
  (define name (if (string? m) (string->symbol m) m))
  (cond [(procedure? m) (made-of-a-step (value->text m))]
        [(memq name made-with-a-step) (made-of-a-step name)]
        [(and (string? m) (memq name names)) (format "a name is quoted: '~a" m)]
        [(elsewhere name) => (lambda (here) (format "take ~a" here))]
        [else (format "~anames: ~a" (meant name) names)]))

;; name : of a method in other systems, without regard to capitals -> the method that does the same
(define (elsewhere name)
  (and (symbol? name)
       (case (string->symbol (string-downcase (symbol->string name)))
         [(rk45 ode45 dopri5 dp5 tsit5 dormand-prince) "'Dormand-Prince-54, or 'Dormand-Prince-853"]
         [(dop853 dopri8 dp8 vern7 vern8 vern9 ode113) "'Dormand-Prince-853"]
         [(rk4 runge-kutta) "'qcrk4, which chooses its steps; other methods take fewer"]
         [(radau5 radauiia5 lsoda bdf ode15s rodas5 stiff) "'Radau-IIA-5, for stiff systems"]
         [(gbs odex) "'bulirsch-stoer"]
         [(verlet velocity-verlet stormer-verlet symplectic symplectic-euler)
          "(leapfrog h), or (Yoshida-8 h), h being the step"]
         [else #f])))

(define (meant name)
  (define near (if (symbol? name) (likely-names name names) '()))
  (if (null? near) "" (format "did you mean '~a?\n  " (alternatives near))))

(define (made-of-a-step name)
  (format "a method with a fixed step is made of the step: (~a 0.01)" name))

(define ode-integration-method
  (make-parameter 'auto (lambda (m) (check-method 'ode-integration-method m))))

(define (set-ode-integration-method! m)
  (ode-integration-method (check-method 'set-ode-integration-method! m)))

;; ---------------------------------------------------------------------------
;; Precision

(define most-bits 100000)

;; A number of bits, more than those of flonums, or #f for flonums.
(define (check-precision who bits)
  (unless (or (not bits) (and (exact-integer? bits) (< 53 bits most-bits)))
    (complain-of-argument who "a number of bits from 54 on, or #f for flonums" bits))
  bits)

(define ode-precision
  (make-parameter #f (lambda (bits) (check-precision 'ode-precision bits))))
