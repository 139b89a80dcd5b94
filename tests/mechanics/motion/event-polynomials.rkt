#lang racket/base
;; Events on steps that are polynomials.

(require mechanics "../support/checks.rkt")

(define (oscillator (up t x v)) (up 1 v (- x)))

(define (events-of f #:direction [direction 'both] #:method [method 'Taylor] #:end [end 20.0]
                   #:start [start (up 0 1 0)])
  (trajectory-events
   (evolve-trajectory oscillator start end #:tolerance 1e-12 #:method method
                      #:events (event f #:direction direction))))

(define (times os) (map occurrence-time os))

(define (check-times os expected tolerance)
  (check-equal? (length os) (length expected))
  (for ([t (times os)] [e expected]) (check-= t e tolerance)))

(test-case "a coordinate, in each direction and backwards in time"
  (define all (for/list ([k (in-range 6)]) (* pi (+ k 1/2))))
  (check-times (events-of (lambda (s) (ref s 1))) all 1e-12)
  (check-times (events-of (lambda (s) (ref s 1)) #:direction 'falling)
               (list (* 1/2 pi) (* 5/2 pi) (* 9/2 pi)) 1e-12)
  (check-times (events-of (lambda (s) (ref s 1)) #:end -20.0) (map - all) 1e-12))

(test-case "a start on the section is no event"
  (check-times (events-of (lambda (s) (ref s 1)) #:start (up 0 0 1))
               (for/list ([k (in-range 1 7)]) (* pi k)) 1e-12))

(test-case "a function of the state, by the same recurrences"
  (check-times (events-of (lambda (s) (- (exp (ref s 1)) 2)))
               (for*/list ([k (in-range 4)] [s '(-1 1)]
                           [t (in-value (+ (* 2 pi k) (* s (acos (log 2)))))]
                           #:when (< 0 t 20))
                 t)
               1e-11))

(test-case "many zeros within one step, which a look at nine places would miss"
  (define (line (up t x)) (up 1 1))
  (define (wiggle s)                    ; zeros at 10.01, 10.02, 10.03, and 70
    (define (d x) (- (ref s 1) x))
    (* (d 10.01) (d 10.02) (d 10.03) (d 70)))
  (define tr (evolve-trajectory line (up 0 0) 100 #:method 'Taylor #:events (event wiggle)))
  (check-times (trajectory-events tr) '(10.01 10.02 10.03 70) 1e-5))

(test-case "two zeros that are close, and one that is touched"
  (define os (events-of (lambda (s) (- (ref s 1) 0.9999999))))
  (check-true (>= (length os) 6))
  (check-false (ormap occurrence-grazing? os))
  (define touched (events-of (lambda (s) (- (ref s 1) 1))))
  (check-times touched (for/list ([k (in-range 1 4)]) (* 2 pi k)) 1e-5)
  (check-true (andmap occurrence-grazing? touched))
  ;; no direction is taken there
  (check-equal? (events-of (lambda (s) (- (ref s 1) 1)) #:direction 'rising) '())
  (check-equal? (events-of (lambda (s) (- (ref s 1) 1.0001))) '()))

;; the energy of the oscillator, from its start on
(define (energy s) (- (+ (square (ref s 1)) (square (ref s 2))) 1))

(test-case "what is 0 all the time is not touched"
  (check-equal? (events-of (lambda (s) (- (+ (square (ref s 1)) (square (ref s 2))) 1))) '())
  (for* ([method '(Taylor Dormand-Prince-853 bulirsch-stoer)] [direction '(both rising)])
    (check-equal? (events-of energy #:method method #:direction direction) '())
    (check-equal? (events-of (lambda (s) (* 1e9 (energy s))) #:method method) '())
    (check-equal? (events-of (lambda (s) (- (log (+ 2 (energy s))) (log 2))) #:method method)
                  '())))

(test-case "a motion may be as small as it likes"
  (for* ([method '(Taylor Dormand-Prince-853)]
         [f (list (lambda (s) (ref s 1))
                  (lambda (s) (* 2 (ref s 1) (exp (ref s 2))))
                  (lambda (s) (* 1e-200 (ref s 1))))])
    (define tr
      (evolve-trajectory oscillator (up 0 1e-15 0) 20 #:tolerance 1e-12 #:method method
                         #:longest-step 0.5 #:events (event f)))
    (check-times (trajectory-events tr) (for/list ([k (in-range 6)]) (* pi (+ k 1/2))) 1e-8)))

(test-case "what is large and varies little is no noise"
  ;; late, and far away
  (for ([method '(Taylor Dormand-Prince-853)])
    (define tr
      (evolve-trajectory oscillator (up 1e6 1 0) (+ 1e6 3) #:tolerance 1e-6 #:method method
                         #:events (list (event (lambda (s) (- (ref s 0) (+ 1e6 2))))
                                        (event (lambda (s) (sin (* 3 (- (ref s 0) 1e6))))
                                               #:direction 'falling))))
    (check-times (trajectory-events tr) (list (+ 1e6 (/ pi 3)) (+ 1e6 2)) 1e-8)
    ;; at the very end
    (define end (+ (acos 0.3) 1e-11))
    (check-times (events-of (lambda (s) (- (ref s 1) 0.3)) #:end end #:method method)
                 (list (acos 0.3)) 1e-10)))

(test-case "what is nearly 0 all the time is not touched"
  (define (nearly s) (+ 3e-13 (- (+ (square (ref s 1)) (square (ref s 2))) 1)))
  (check-equal? (events-of nearly) '()))

(test-case "a pole, a kink, a function without recurrence, a terminal event"
  (for ([method '(Taylor Dormand-Prince-853)])
    (check-times (events-of (lambda (s) (/ (ref s 2) (ref s 1))) #:method method)
                 (for/list ([k (in-range 1 7)]) (* k pi)) 1e-10)
    (check-times (events-of (lambda (s) (- (abs (ref s 1)) 0.5)) #:end 3.0 #:method method)
                 (list (acos 0.5) (acos -0.5)) 1e-10))
  (define tr
    (evolve-trajectory oscillator (up 0 1 0) 20 #:method 'Taylor
                       #:events (event (lambda (s) (- (ref s 1) 0.3)) #:terminal? #t)))
  (check-= (trajectory-end tr) (acos 0.3) 1e-10)
  (check-= (ref (trajectory-final-state tr) 1) 0.3 1e-10))

(test-case "events at the ends of steps are found once"
  (define tr
    (evolve-trajectory (lambda (s) (up 1 1)) (up 0 0) 10 #:method 'Taylor #:longest-step 0.5
                       #:events (event (lambda (s) (- (ref s 1) 5)))))
  (check-times (trajectory-events tr) '(5) 1e-12))

;; (t - 1)(t - 5/4), of which the step that begins at 1 has the other zero
(test-case "a zero where a step begins does not hide another within it"
  (define tr
    (evolve-trajectory (lambda (s) (up 1 (ref s 2) 2)) (up 0 5/4 -9/4) 2 #:method 'Taylor
                       #:longest-step 0.5 #:events (event (lambda (s) (ref s 1)))))
  (check-times (trajectory-events tr) '(1 5/4) 1e-12))
