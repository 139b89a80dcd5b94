#lang racket/base
;; Motions that end before their time: the failure tells where and why, and carries
;; what was computed.

(require mechanics "../support/checks.rkt")

;; -> message and what the failure carries
(define-syntax-rule (failure-of expression)
  (with-handlers ([exn:fail:mechanics:singular?
                   (lambda (e) (values (exn-message e) (exn:fail:mechanics:singular-where e)))]
                  [exn:fail:mechanics:not-convergent?
                   (lambda (e) (values (exn-message e)
                                       (exn:fail:mechanics:not-convergent-value e)))])
    expression
    (values "no failure" #f)))

(define-syntax-rule (check-failure pattern expression)
  (let-values ([(message kept) (failure-of expression)])
    (check-regexp-match pattern message)
    kept))

(define start (up 0 1 0))
(define oscillator (lambda (s) (up 1 (velocity s) (- (coordinate s)))))
(define (oscillator-maker) oscillator)

(test-case "a fixed step too long for the equations of an implicit method"
  ;; x = -log(1 - t); near its end no step of that length is one
  (define (steep s) (up 1 (exp (coordinate s)) 0))
  (define (follow method)
    (check-failure
     (string-append "^evolve-trajectory: the motion cannot be followed any further\n"
                    "  time: [.0-9]+\n"
                    "  last state: [(]up [^\n]*[)]\n"
                    "  length of a step: 0.1\n"
                    "  take a shorter step, such as [(]Gauss-Legendre-[246] 0.025[)], "
                    "or a method that chooses its own$")
     (evolve-trajectory steep (up 0 0 0) 100 #:method method)))
  (for ([make (list Gauss-Legendre-2 Gauss-Legendre-4 Gauss-Legendre-6)])
    (define tr (follow (make 0.1)))
    (check-true (trajectory? tr))
    (check-true (< 0.2 (trajectory-end tr) 10))
    (check-= (coordinate (tr 0.15)) (- (log 0.85)) 1e-3)))

(test-case "an advancer's failure carries the last good state"
  (define (steep s) (up 1 (exp (* 10 (coordinate s))) 0))
  (check-equal? (check-failure #rx"such as [(]Gauss-Legendre-4 0.025[)]"
                               ((state-advancer (lambda () steep)) start 1 1e-10
                                                                   #:method (Gauss-Legendre-4 0.1)))
                (up 0.0 1.0 0.0)))

(test-case "a state derivative that is not finite at the start, or not real"
  (for ([f (list (lambda (s) (up 1 0 +nan.0))
                 (lambda (s) (up 1 0 (/ 1 (velocity s))))
                 (lambda (s) (up 1 0 (sqrt (- (velocity s) 1)))))]
        [value '("[+]nan.0" "[+]inf.0" "0.0[+]1.0i")])
    (define tr
      (check-failure (string-append "\n  time: 0.0\n  last state: [(]up 0.0 1.0 0.0[)]\n"
                                    "  state derivative there: [(]up 1 0 " value "[)]$")
                     (evolve-trajectory f start 1)))
    (check-equal? (tr 0) (up 0.0 1.0 0.0))))

(test-case "an infinite force is approached"
  (define (falling-in s) (up 1 (velocity s) (/ -1 (square (coordinate s)))))
  (for ([method '(Dormand-Prince-853 Dormand-Prince-54 bulirsch-stoer qcrk4 Radau-IIA-5)])
    (define tr
      (check-failure
       #rx"\n  time: 1[.]1107[^\n]*\n  last state: [^\n]*\n  steps became too short to change the time$"
                     (evolve-trajectory falling-in start 2 #:method method)))
    (check-= (trajectory-end tr) (/ :pi (* 2 (sqrt 2))) 1e-8)))

(test-case "a place beyond which nothing is defined, met at full speed"
  (define (f s) (up 1 (velocity s) (- (* (coordinate s) (sqrt (- 1 (square (coordinate s))))))))
  (for* ([method '(Dormand-Prince-853 Dormand-Prince-54 bulirsch-stoer qcrk4 Radau-IIA-5)]
         [q '(1 0.9)])
    (define tr
      (check-failure #rx"derivative (there|beyond): [(]up 1 [.0-9]+ [^\n]*i[)]$"
                     (evolve-trajectory f (up 0 q 2) 3 #:method method)))
    (check-= (coordinate (trajectory-final-state tr)) 1 1e-7)))

(test-case "as many steps as allowed"
  (define tr
    (check-failure
     (string-append "^evolve-trajectory: the motion takes more steps than allowed\n  time: [^\n]*\n"
                    "  last state: [^\n]*\n  if it is stiff, use the method 'Radau-IIA-5$")
     (evolve-trajectory oscillator start 100 #:most-steps 20)))
  (check-= (length (trajectory-states tr)) 21 0)
  ;; who uses it already is not told of it
  (check-failure #rx"\n  last state: [^\n]*$"
                 (evolve-trajectory oscillator start 100 #:most-steps 5 #:method 'Radau-IIA-5))
  (check-= (coordinate (tr 1)) (cos 1) 1e-9)
  (check-failure #rx"^state-advancer: .*more steps than allowed"
                 ((state-advancer oscillator-maker) start 100 1e-10 #:most-steps 3))
  (check-failure #rx"^evolve: .*more steps than allowed"
                 ((evolve oscillator-maker) start void 1 100 1e-10 #:most-steps 3))
  (check-equal? (time ((state-advancer oscillator-maker) start 1 1e-10 #:most-steps 1000)) 1.0))

(test-case "no step is longer than allowed"
  (define times
    (map time (trajectory-states (evolve-trajectory oscillator start 5 #:longest-step 0.01))))
  (for ([a times] [b (cdr times)]) (check-true (<= (- b a) 0.0100001)))
  (check-equal? (car (reverse times)) 5.0)
  (define short-kick                            ; missed by steps that are longer than it
    (lambda (s) (up 1 (velocity s) (* 1e3 (exp (- (square (* 1e3 (- (time s) 50)))))))))
  (define s ((state-advancer (lambda () short-kick)) (up 0 0 0) 100 1e-10 #:longest-step 0.01))
  (check-= (velocity s) (sqrt :pi) 1e-8))

;; ---------------------------------------------------------------------------
;; The user's own doing

(struct my-own exn:fail ())
(define (raise-mine) (raise (my-own "enough" (current-continuation-marks))))

(define methods
  (list 'auto 'Taylor 'Dormand-Prince-853 'Dormand-Prince-54 'bulirsch-stoer 'qcrk4 'Radau-IIA-5
        (leapfrog 0.01) (Gauss-Legendre-4 0.01)))

;; The trajectory so far, as far as it goes.
(define (check-so-far tr end)
  (check-pred trajectory? tr)
  (check-true (< 0 (trajectory-end tr) (+ end 1e-9)))
  (define t (* 0.5 (trajectory-end tr)))
  (check-true (< (abs (- (coordinate (tr t)) (cos t))) 1e-3)))

(test-case "an error of the user's own in the state derivative keeps the trajectory so far"
  ;; a test of the time is a decision, which the Taylor method does not take
  (define (f s)
    (when (> (time s) 3) (raise-mine))
    (oscillator s))
  (for ([method methods] #:unless (eq? method 'Taylor))
    (define e
      (with-handlers ([my-own? values]) (evolve-trajectory f start 10 #:method method)))
    (check-equal? (exn-message e) "enough")
    (check-so-far (trajectory-so-far e) 3)))

(test-case "one in the function of an event, too, with the events until then"
  (define zero (event coordinate))
  (define limit (event (lambda (s) (when (> (time s) 5) (raise-mine)) 1)))
  (for ([method methods])
    (define e
      (with-handlers ([my-own? values])
        (evolve-trajectory oscillator start 10 #:method method #:events (list zero limit))))
    (define tr (trajectory-so-far e))
    (check-so-far tr 5)
    (for ([o (trajectory-events tr)]) (check-true (<= (occurrence-time o) (trajectory-end tr)))))
  (define e
    (with-handlers ([my-own? values])
      (evolve-trajectory oscillator start 10 #:events limit #:precision 100 #:tolerance 1e-20)))
  (check-so-far (trajectory-so-far e) 5))

(test-case "a break from the keyboard"
  (for ([method methods])
    (define running (make-semaphore 0))
    (define seen 'nothing)
    (define reached (event (lambda (s) (when (> (time s) 50) (semaphore-post running)) 1)))
    (define motion
      (thread
       (lambda ()
         (with-handlers ([exn:break? (lambda (e) (set! seen (trajectory-so-far e)))])
           (evolve-trajectory oscillator start 1e9 #:method method #:events reached)))))
    (semaphore-wait running)
    (break-thread motion)
    (thread-wait motion)
    (check-so-far seen 1e9)))

(test-case "failures of the motion itself, and exceptions from elsewhere"
  (define e
    (with-handlers ([exn:fail? values])
      (evolve-trajectory (lambda (s) (up 1 (square (ref s 1)))) (up 0 1) 2)))
  (check-= (trajectory-end (trajectory-so-far e)) 1 1e-6)
  (check-equal? (trajectory-so-far (with-handlers ([exn:fail? values]) (car 1))) #f)
  (check-exn #rx"^trajectory-so-far: expected an exception" (lambda () (trajectory-so-far 1))))

;; ---------------------------------------------------------------------------
;; Motions whose steps are not kept

;; The state reached, from which the motion goes on.
(define (check-reached tr least most [method #f])
  (check-pred trajectory? tr)
  (check-true (<= least (trajectory-end tr) most))
  (check-equal? (trajectory-start tr) (trajectory-end tr))
  (define s (trajectory-final-state tr))
  (check-equal? (time s) (trajectory-end tr))
  (check-true (< (abs (- (coordinate s) (cos (time s)))) 1e-3))
  (when method (check-equal? (trajectory-method tr) method)))

(define (raised thunk) (trajectory-so-far (with-handlers ([my-own? values]) (thunk))))

(test-case "an error of the user's own keeps the state that an advancer and evolve reached"
  (define ((maker) s)
    (when (> (time s) 3) (raise-mine))
    (oscillator s))
  (for ([m methods] #:unless (eq? m 'Taylor))
    (define shown (if (eq? m 'auto) 'Dormand-Prince-853 m))
    (check-reached (raised (lambda () ((state-advancer maker) start 10 1e-10 #:method m)))
                   0.5 3.01 shown)
    (check-reached (raised (lambda () ((evolve maker) start void 0.1 10 1e-10 #:method m)))
                   0.5 3.01 shown)))

(test-case "one of the monitor's, too, and with any precision"
  (define (limited s) (when (> (time s) 5) (raise-mine)))
  (for ([m methods])
    (check-reached (raised (lambda () ((evolve oscillator-maker) start limited 0.1 10 1e-10
                                                                  #:method m)))
                   5 7.5))
  (define tr
    (raised (lambda () ((evolve oscillator-maker) start limited 1/10 10 1e-20 #:precision 100))))
  (check-reached tr 5 6 'extrapolation)
  (define ((precise-maker) s)
    (when (> (time s) 3) (raise-mine))
    (oscillator s))
  (check-reached (raised (lambda () ((state-advancer precise-maker) start 10 1e-20
                                                                     #:precision 100)))
                 0 3))

(test-case "a break from the keyboard leaves the state reached; and nothing before there is one"
  (define running (make-semaphore 0))
  (define seen 'nothing)
  (define (watching s) (when (> (time s) 50) (semaphore-post running)))
  (define motion
    (thread
     (lambda ()
       (with-handlers ([exn:break? (lambda (e) (set! seen (trajectory-so-far e)))])
         ((evolve oscillator-maker) start watching 1.0 1e9 1e-10)))))
  (semaphore-wait running)
  (break-thread motion)
  (thread-wait motion)
  (check-reached seen 50 1e9 'Taylor)
  (define ((maker) s) (raise-mine))
  (check-equal? (raised (lambda () ((state-advancer maker) start 1))) #f))

(test-case "the motion goes on from there, as it would have"
  (define calls 0)
  (define ((maker) s)
    (set! calls (+ calls 1))
    (when (= calls 2000) (raise-mine))
    (if (> (time s) -1) (oscillator s) 0))
  (define tr (raised (lambda () ((state-advancer maker) start 100 1e-10))))
  (define s (trajectory-final-state tr))
  (define end ((state-advancer maker) s (- 100 (time s)) 1e-10))
  (check-= (coordinate end) (cos 100) 1e-8))

;; ---------------------------------------------------------------------------
;; Events

(test-case "an event that has no real value any more stops there"
  (define root (event (lambda (s) (sqrt (- 0.5 (time s)))) #:name 'root))
  (define tr
    (check-failure
     (string-append "^evolve-trajectory: the function of an event has no real value\n"
                    "  event: [(]event root[)]\n  time: 0.5[0-9]*\n  state: [(]up 0.5")
     (evolve-trajectory oscillator start 1 #:events root)))
  (check-true (< 0.5 (trajectory-end tr) 1))
  (check-exn #rx"\n  time: 0.0\n"
             (lambda ()
               (evolve-trajectory oscillator start 1 #:events (event (lambda (s) +nan.0))))))

(test-case "beyond a terminal event nobody asks for it"
  (define root (event (lambda (s) (sqrt (- 0.5 (time s)))) #:name 'root))
  (define end (event (lambda (s) (- (time s) 0.49)) #:terminal? #t))
  (check-= (trajectory-end (evolve-trajectory oscillator start 1 #:events (list root end)))
           0.49 1e-12))

(test-case "a pole is no zero, a jump is"
  (define (times f)
    (map occurrence-time
         (trajectory-events (evolve-trajectory oscillator start 1 #:events (event f)))))
  (check-equal? (times (lambda (s) (/ 1 (- (time s) 0.513)))) '())
  (for ([t (times (lambda (s) (tan (* 20 (time s)))))] [k (in-naturals 1)])
    (check-= t (* k (/ :pi 20)) 1e-12))
  (define jump (times (lambda (s) (if (< (time s) 0.3) -1 1))))
  (check-equal? (length jump) 1)
  (check-= (car jump) 0.3 1e-12))

(test-case "an event that is zero throughout never happens"
  (check-equal? (trajectory-events
                 (evolve-trajectory oscillator (up 0 0 0) 10
                                    #:events (event coordinate #:terminal? #t)))
                '()))

;; ---------------------------------------------------------------------------
;; Ends

(test-case "no time to pass"
  (check-equal? ((state-advancer oscillator-maker) start 0) (up 0.0 1.0 0.0))
  (define seen '())
  (check-equal? ((evolve oscillator-maker) start (lambda (s) (set! seen (cons s seen))) 0.1 0)
                (up 0.0 1.0 0.0))
  (check-equal? seen (list (up 0.0 1.0 0.0)))
  (define tr (evolve-trajectory oscillator start 0))
  (check-equal? (tr 0) (up 0.0 1.0 0.0))
  (check-equal? (trajectory-end tr) 0.0))

(test-case "the last time is the one that was asked for"
  (for* ([method (list 'Dormand-Prince-853 'bulirsch-stoer 'Radau-IIA-5 (leapfrog 0.1)
                       (Gauss-Legendre-4 0.03))]
         [end '(100/3 0.1 -7.7)])
    (define tr (evolve-trajectory oscillator start end #:method method #:tolerance 1e-6))
    (check-equal? (time (trajectory-final-state tr)) (real->double-flonum end))))

(test-case "exact numbers become flonums once, at the edge"
  (define seen '())
  (define (note x) (set! seen (cons x seen)))
  (define (f s)
    (when (rational? (coordinate s)) (note (coordinate s)))
    (up 1 (velocity s) (if (< (time s) 10) (- (coordinate s)) 0)))
  (define s ((state-advancer (lambda () f)) (up 0 1/3 2) 1/2))
  (check-true (andmap flonum? seen))
  (for ([x s]) (check-true (flonum? x)))
  (check-= (coordinate s) (+ (* 1/3 (cos 1/2)) (* 2 (sin 1/2))) 1e-9))
