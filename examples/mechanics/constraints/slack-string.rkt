#lang mechanics
;; A mass on a string that goes slack, flies, and is caught again. Three motions follow each
;; other: on the circle until the tension is zero, free until the string is taut, and after
;; the jerk, which takes the velocity along the string away, on the circle again.

(define g 9.8)
(define ((L-mass m g) (up t (up x y) (up vx vy)))
  (- (* 1/2 m (+ (square vx) (square vy))) (* m g y)))
(define L (L-mass 1 g))
(define (slackness t q) (- (sqrt (square q)) 1))
(define string (holonomic slackness))

(define multiplier (constrained-accelerations L string))
(define goes-slack
  (event (lambda (state) (ref (multiplier state) 1))
         #:name 'slack #:direction 'rising #:terminal? #t))
(define is-taut
  (event (lambda (state) (slackness 0 (coordinate state)))
         #:name 'taut #:direction 'rising #:terminal? #t))

(define swing (constrained-state-derivative L string))
(define flight (Lagrangian->state-derivative L))
(define caught (consistent-state L string))

;; A list of trajectories, from the state to the end, on the circle at first.
(define (hybrid state end)
  (define (next derivative happens continue state)
    (define tr
      (evolve-trajectory derivative state end #:tolerance 1e-12 #:events happens))
    (define last (trajectory-final-state tr))
    (cons tr (if (null? (trajectory-events tr)) '() (continue last))))
  (define (on-circle state) (next swing goes-slack in-flight state))
  (define (in-flight state) (next flight is-taut (compose on-circle caught) state))
  (on-circle state))

;; With v² = 3.5 g l at the bottom it goes slack 30° above the horizontal, and is caught at
;; the very bottom again.
(define motion (hybrid (up 0 (up 0 -1) (up (sqrt (* 3.5 g)) 0)) 4))
(for ([tr motion] [name (in-cycle '(circle flight))])
  (printf "~a until ~a: ~a\n" name (trajectory-end tr)
          (coordinate (trajectory-final-state tr))))

(module+ test
  (require rackunit racket/list)
  (define (place k) (coordinate (trajectory-final-state (list-ref motion k))))
  (test-case "where it goes slack"
    (check-= (ref (place 0) 1) 1/2 1e-10))
  (test-case "the parabola ends at the bottom"
    (check-= (ref (place 1) 0) 0 1e-9)
    (check-= (ref (place 1) 1) -1 1e-9))
  (test-case "caught, it swings without going slack again: too much is lost"
    (check-equal? (length motion) 3)
    (define energy (Lagrangian->energy L))
    (define before (energy (trajectory-final-state (second motion))))
    (define after (energy (trajectory-final-state (third motion))))
    (check-true (< after before)))
  (test-case "the string is never longer than it is"
    (for* ([tr motion] [k 101])
      (define t (+ (trajectory-start tr)
                   (* (/ k 100) (- (trajectory-end tr) (trajectory-start tr)))))
      (check-true (< (slackness 0 (coordinate (tr t))) 1e-10)))))
