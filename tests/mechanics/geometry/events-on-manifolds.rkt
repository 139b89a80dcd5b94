#lang racket/base
;; Events along motions whose charts change: each is found once, where the same motion without
;; coordinates has it.

(require mechanics mechanics/geometry
         "../support/checks.rkt" "../support/close.rkt" "../support/messages.rkt")

;; A geodesic of the sphere, tilted so that it passes near to the poles or through them
(define g (coordinate-system->metric S2-spherical))
(define (circle start end . events)
  (evolve-geodesic g S2-spherical start end #:events events #:tolerance 1e-12))

(define (times tr) (map occurrence-time (trajectory-events tr)))

;; The geodesic from the place a with velocity b there, |b| = 1: a cos t + b sin t
(define near-pole (up 0 (up 1.0 0.3) (up -0.999 0.02)))
(define (place-at start)
  (define (embed local)
    (define-values (theta phi) (values (ref (coordinate local) 0) (ref (coordinate local) 1)))
    (up (* (sin theta) (cos phi)) (* (sin theta) (sin phi)) (cos theta)))
  (define there ((F->C embed) start))
  (define-values (a b) (values (coordinate there) (velocity there)))
  (define w (sqrt (square b)))
  (lambda (t) (+ (* a (cos (* w t))) (* b (/ (sin (* w t)) w)))))

;; Sign changes of f between many places
(define (crossings f end [n 200000])
  (let loop ([k 0] [before (f 0.0)] [found '()])
    (define t (* end (/ (+ k 1.0) n)))
    (cond [(= k n) (reverse found)]
          [else
           (define now (f t))
           (loop (+ k 1) now (if (< (* before now) 0) (cons t found) found))])))

(define (check-times tr f end)
  (define found (times tr))
  (define expected (crossings f end))
  (check-equal? (length found) (length expected))
  (for ([a found] [b expected]) (check-close a b (* 2 (/ (abs end) 200000)))))

(define-coordinates (up theta phi) S2-spherical)
(define-coordinates (up x y) S2-stereographic)

(test-case "dense events, as functions on the manifold and in home coordinates"
  (define place (place-at near-pole))
  (for ([end '(20 -20)])
    (define (f t) (sin (+ 0.1 (* 60 (ref (place t) 2)))))
    (check-times (circle near-pole end (event (sin (+ 0.1 (* 60 (cos theta)))))) f end)
    (check-times (circle near-pole end
                         (event (lambda (s) (sin (+ 0.1 (* 60 (cos (ref (coordinate s) 0))))))))
                 f end)))

(test-case "angles are followed through whole turns: no event where one comes round"
  ;; the longitude grows by nearly half a turn at a pole, 20 for 10 turns
  (define (level n) (event (lambda (s) (- (ref (coordinate s) 1) n)) #:name n))
  (define tr (apply circle near-pole 63 (for/list ([n (in-range 1 60 3)]) (level n))))
  (check-close (for/list ([o (trajectory-events tr)]) (ref (coordinate (occurrence-state o)) 1))
               (for/list ([n (in-range 1 60 3)]) n)
               1e-9))

(test-case "an event of the velocity at home"
  (define place (place-at near-pole))
  ;; θ' = 0 where the place is farthest from the plane z = 0
  (define tr (circle near-pole 20 (event (lambda (s) (ref (velocity s) 0)))))
  (define (zdot t) (/ (- (ref (place (+ t 1e-6)) 2) (ref (place (- t 1e-6)) 2)) 2e-6))
  (check-times tr zdot 20))

(test-case "where charts change an event is neither lost nor doubled"
  (define changes (map car (trajectory-chart-changes (circle near-pole 20))))
  (check-true (> (length changes) 3))
  (for ([t changes] [k (in-naturals)])
    (define (clock-event at) (event (lambda (s) (- (time s) at))))
    (for ([by '(0 1e-15 -1e-15 1e-12 -1e-12)])
      (check-close (times (circle near-pole 20 (clock-event (+ t by)))) (list t) 1e-11))
    (define tr (circle near-pole 20
                       (event (lambda (s) (- (time s) t)) #:terminal? #t)))
    (check-close (trajectory-end tr) t 1e-11)
    (check-equal? (length (trajectory-events tr)) 1)))

(test-case "events in one direction, and terminal ones in whatever chart"
  (define place (place-at near-pole))
  (define rising (event (lambda (s) (- (ref (coordinate s) 0) 0.5)) #:direction 'rising))
  (define tr (circle near-pole 12 rising))
  (check-equal? (length (times tr)) 2)
  (define last (event (lambda (s) (- (ref (coordinate s) 0) 0.5)) #:direction 'rising
                      #:terminal? #t))
  (define cut (circle near-pole 12 last))
  (check-close (trajectory-end cut) (car (times tr)) 1e-12)
  (check-close (ref (coordinate (trajectory-final-state cut)) 0) 0.5 1e-11)
  (check-equal? (length (times cut)) 1)
  (define on-manifold
    (circle near-pole 12 (event (- theta 0.5) #:direction 'rising #:terminal? #t)))
  (check-close (trajectory-end on-manifold) (car (times tr)) 1e-11)
  (define none (circle near-pole 12 (event (lambda (s) (- (ref (coordinate s) 0) 0.5))
                                           #:direction 'rising)
                       (event (- theta 10) #:terminal? #t)))
  (check-equal? (length (times none)) 2))

(test-case "a conserved function that is 0 is no event, in whatever chart"
  (define (momentum s)
    (* (square (sin (ref (coordinate s) 0))) (ref (velocity s) 1)))
  (define size (momentum near-pole))
  (check-equal? (times (circle near-pole 20 (event (lambda (s) (- (momentum s) size))))) '()))

(test-case "through the pole itself: what is continuous is an event, what jumps is refused"
  (define start (up 0 (up 1.0 0.3) (up -1.0 0.0)))
  (check-close (times (circle start 3 (event (lambda (s) (- (ref (coordinate s) 0) 0.5)))))
               (list 0.5 1.5) 1e-10)
  (check-equal? (times (circle start 1.001 (event (lambda (s) 0.0)))) '())
  (check-equal?
   (regexp-replace "time: .*"
                   (message-of (circle start 3 (event (lambda (s) (+ (ref (coordinate s) 1) 1))
                                                      #:name 'longitude)))
                   "time: 1")
   (string-append
    "evolve-geodesic: an event is in coordinates that are singular where the motion passes"
    "\n  make it a function on the manifold, such as the coordinates of another chart"
    "\n  event: (event longitude)\n  coordinates: S2-spherical\n  time: 1")))
