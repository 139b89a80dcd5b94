#lang racket/base
;; An event's function may end in nothing but noise within the step in which it was zero: that of
;; a spring which pushes only when it is compressed, beside what is conserved.  Whether there is
;; noise was asked of the part of the step that was looked at last, and all its zeros went with it.
;; The expected values are those of a circle: x = sin t is -1/2 at - π/6.

(require (except-in mechanics time) "../support/checks.rkt")

(define (circle s) (up 1 (ref s 2) (* -1 (ref s 1))))
(define (conserved s) (- (+ (square (ref s 1)) (square (ref s 2))) 1))
(define (compression s) (* 1/2 (- (sqrt (square (ref s 1))) (ref s 1))))
(define (at-half s) (+ (conserved s) (* (expt (compression s) 9) (+ (ref s 1) 1/2))))

(define half-compressed -0.5235987755982989)

(for ([start '(-2.0 -1.3 -1.0 -0.9 -0.6)])
  (test-case (format "a compression that ends, seen from ~a on" start)
    (define state (up start (sin start) (cos start)))
    (define events
      (trajectory-events
       (evolve-trajectory circle state 1.2 #:method 'Taylor #:events (event at-half))))
    (check-pred pair? events)
    (check-= (occurrence-time (car events)) half-compressed 1e-9)))

(test-case "what is noise all the way has no zeros"
  (define events
    (trajectory-events
     (evolve-trajectory circle (up 0 0.0 1.0) 50.0 #:method 'Taylor
                        #:events (event (lambda (s) (* (conserved s) (+ 1 (compression s))))))))
  (check-equal? events '()))
