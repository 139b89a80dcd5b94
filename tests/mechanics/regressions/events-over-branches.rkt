#lang racket/base
;; The Taylor series of an angle goes on after half a turn, where the angle begins anew; that of
;; √x² = |x| is x, beyond 0 as well.  Events were the zeros of such series: of three times at
;; which an angle is 2 the first was found alone, of nineteen zeros of atan tan 3t - 1/2 seven,
;; and of |x| = 1/2 there were some that are none.  The expected times are those of a circle.

(require (except-in mechanics time) "../support/checks.rkt")

(define (circle s) (up 1 (ref s 2) (* -1 (ref s 1))))     ; x = cos t, v = - sin t
(define (x s) (ref s 1))
(define (angle-of s) (atan (- (ref s 2)) (ref s 1)))
(define pi 3.141592653589793)

(define (check-times f expected #:direction [direction 'both])
  (for* ([method '(auto Taylor Dormand-Prince-853)] [tolerance '(1e-8 1e-11)])
    (define found
      (trajectory-events
       (evolve-trajectory circle (up 0 1.0 0.0) 20.0 #:method method #:tolerance tolerance
                          #:events (event f #:direction direction))))
    (check-equal? (map (lambda (o) (round (* 1e5 (occurrence-time o)))) found)
                  (map (lambda (t) (round (* 1e5 t))) expected))))

(test-case "an angle that begins anew"
  (for ([a '(2.0 3.0 -1.0)])
    (check-times (lambda (s) (- (angle-of s) a)) #:direction 'rising
                 (for*/list ([k 5] [t (in-value (+ a (* 2 pi k)))] #:when (< 0 t 20.0)) t))))

(test-case "the modulus as a root"
  (for ([a '(0.5 0.1)])
    (define t (acos a))
    (check-times (lambda (s) (- (sqrt (square (x s))) a))
                 (for*/list ([k 8] [t (in-list (list (- (* k pi) t) (+ (* k pi) t)))]
                             #:when (< 0 t 20.0))
                   t))))

(test-case "arcs of what they are the arcs of"
  (check-times (lambda (s) (- (atan (tan (* 3 (ref s 0)))) 1/2)) #:direction 'rising
               (for*/list ([k 20] [t (in-value (/ (+ 0.5 (* k pi)) 3))] #:when (< t 20.0)) t))
  (check-times (lambda (s) (- (acos (x s)) 1)) #:direction 'rising
               (for/list ([k 4]) (+ 1 (* 2 pi k)))))

(test-case "roots that have no kink on the way"
  (check-times (lambda (s) (- (sqrt (+ 1 (x s))) 1.2)) #:direction 'falling
               (for*/list ([k 4] [t (in-value (+ (acos 0.44) (* 2 pi k)))] #:when (< t 20.0)) t)))
