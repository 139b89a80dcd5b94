#lang racket/base
;; Extrapolation in numbers of higher precision: order, error and tolerance.

(require math/bigfloat
         (only-in racket/list drop drop-right)
         mechanics/numeric/bigfloat/extrapolation
         "../../support/checks.rkt" "../../support/bigfloats.rkt" "../../support/skip.rkt")

(define evaluations 0)
(define (oscillator y)
  (set! evaluations (+ evaluations 1))
  (vector (vector-ref y 1) (bf- (vector-ref y 0))))
(define (start) (vector (bf 1) (bf 0)))

(define (log2 x) (bigfloat->flonum (bf/ (bflog (bfabs x)) (bflog (bf 2)))))

;; The error of the first component after the time T.
(define (error-of y T) (bf- (vector-ref y 0) (bfcos T)))

(skip-unless bigfloats? no-bigfloats
  (test-case "j rows make order 2j: half the step leaves an error smaller by 2^(2j+1), or one more"
    (parameterize ([bf-precision 400])
      (for ([j (in-range 1 13)])
        (define (step-error H) (error-of (step-by-rows oscillator (start) H j) H))
        (define order (log2 (bf/ (step-error (bf 1/8)) (step-error (bf 1/16)))))
        (check-true (< (+ (* 2 j) 0.9) order (+ (* 2 j) 2.1)) (format "~a rows: 2^~a" j order)))))

  (define (run digits T)
    (set! evaluations 0)
    (define-values (t y)
      (parameterize ([bf-precision (+ (ceiling (* 4 digits)) (guard-bits digits))])
        ((make-integrator oscillator (start) (bf 0) (bfexpt (bf 10) (bf (- digits))) digits
                          #:clock #f #:stuck (lambda (t y why) (fail-check "stuck")))
         (bf T) (lambda (from y to z) #t))))
    (check-equal? (bigfloat->integer t) T)
    (parameterize ([bf-precision 600])
      (- (/ (log2 (error-of y (bf T))) (log2 (bf 10))))))

  (test-case "the error falls with the tolerance, and work grows as the square of the digits"
    (define counts
      (for/list ([digits (in-list '(15 30 60 90))])
        (define reached (run digits 20))
        (check-true (< (- digits 3) reached) (format "~a digits, ~a right" digits reached))
        evaluations))
    (check-true (< (/ (cadddr counts) (cadr counts)) 12) (format "~a" counts)))

  ;; -> the times after each step from 0 to the end, as flonums
  (define (times-of-steps f y0 end)
    (define times '())
    (parameterize ([bf-precision 100])
      ((make-integrator f y0 (bf 0) (bf 1e-10) 10 #:clock #f #:stuck void)
       (bf end)
       (lambda (from y to z) (set! times (cons (bigfloat->flonum to) times)))))
    (reverse times))

  (test-case "of a motion that is always alike the steps are, but for the first ones and the last"
    (define times (times-of-steps oscillator (start) 100))
    (define lengths
      (drop-right (drop (for/list ([t (in-list times)] [u (in-list (cdr times))]) (- u t)) 4) 1))
    (check-true (> (length lengths) 10))
    (check-true (< (/ (apply max lengths) (apply min lengths)) 2) (format "~a" lengths)))

  ;; There is no error in y' = c.
  (test-case "the first step is a tenth of the time in which the state changes by 1 + |y|"
    (for ([c+y0+first (in-list '((2 3 0.2) (-1 0 0.1) (1 0 0.1) (1/8 1 1.6)))])
      (define-values (c y0 first) (apply values c+y0+first))
      (define times (times-of-steps (lambda (y) (vector (bf c))) (vector (bf y0)) 1000))
      (check-= (car times) first 1e-12)
      (check-true (< (length times) 8) (format "~a" times)))
    (check-= (car (times-of-steps (lambda (y) (vector (bf 0))) (vector (bf 0)) 1000)) 1.0 0.0))

  ;; Without these the first step is 1.6 and the next reaches the end.
  (test-case "steps are no longer, and no more, than allowed"
    (define-values (times why)
      (let/ec return
        (define times '())
        ((make-integrator (lambda (y) (vector (bf 1/8))) (vector (bf 1)) (bf 0) (bf 1e-10) 10
                          #:clock #f #:longest 0.5 #:limit 4
                          #:stuck (lambda (t y why) (return (reverse times) why)))
         (bf 5)
         (lambda (from y to z) (set! times (cons (bigfloat->flonum to) times))))))
    (check-equal? times '(0.5 1.0 1.5 2.0))
    (check-eq? why 'too-many-steps))

  ;; t' = 1, x' = 1/t², from 10 to the pole at 0: steps are in proportion to t.
  (test-case "towards a pole a step is too short beside the time since the start"
    (define (towards-pole y)
      (define t (vector-ref y 0))
      (vector (bf 1) (bf/ (bf 1) (bf* t t))))
    (define-values (t why)
      (let/ec return
        ((make-integrator towards-pole (vector (bf 10) (bf 0)) (bf 10) (bf 1e-10) 10 #:clock 0
                          #:stuck (lambda (t y why) (return t why)) #:shortest 1e-3 #:limit 100)
         (bf 0) void)))
    (check-eq? why 'too-short)
    (check-true (bf< (bf 1e-3) t (bf 1))))

  (test-case "a step to where there are no numbers is given up with its first rows"
    (define calls 0)
    (define (until-1 y)
      (set! calls (+ calls 1))
      (vector (if (bf< (vector-ref y 0) (bf 1)) (bf 1) +nan.bf)))
    (define t
      (let/ec return
        ((make-integrator until-1 (vector (bf 0)) (bf 0) (bf 1e-10) 10 #:clock #f
                          #:stuck (lambda (t y why) (return t)) #:shortest 1e-3)
         (bf 2) void)))
    (check-= (bigfloat->flonum t) 1.0 1e-2)
    (check-true (< calls 500) (format "~a calls" calls)))

  (test-case "backwards"
    (check-true (> (run 30 -7) 27)))

  ;; x' = 1/(1 + 10⁴ (t − 1)²): x(2) = atan(100)/50
  (test-case "a narrow peak after long steps: a step that finds it is taken again, shorter"
    (parameterize ([bf-precision 200])
      (define (peak y)
        (define s (bf* (bf 100) (bf- (vector-ref y 0) (bf 1))))
        (vector (bf 1) (bf/ (bf 1) (bf+ (bf 1) (bf* s s)))))
      (define advance
        (make-integrator peak (vector (bf 0) (bf 0)) (bf 0) (bf 1e-20) 20 #:clock 0 #:stuck void))
      (define-values (t y) (advance (bf 2) void))
      (check-true (bf< (bfabs (bf- (vector-ref y 1) (bf/ (bfatan (bf 100)) (bf 50))))
                       (bf 1e-17))))))
