#lang racket/base
;; The way out of a region within one long step, by a function that is known in closed form.

(require racket/flonum
         (only-in mechanics/motion/event/event crossing-at)
         mechanics/motion/event/region-watch
         "../../support/checks.rkt")

;; -> where a step from 0 to `to` leaves the region in which f, with the rate f', is above the limit
(define (ways-out f f-rate limit [to 1.0])
  (define (look point seen)
    (flvector-set! seen 0 (f (flvector-ref point 0)))
    (flvector-set! seen 1 (f-rate (flvector-ref point 0))))
  (define (at place point) (flvector-set! point 0 (* to place)))
  (define watch (watch-region (region look limit #f values) (lambda (at) '()) 1))
  (map crossing-at (watch at 0.0 to)))

;; 1 − e^(−u²), u = (t − c)/w: nearly 1 but for a dip at c
(define ((dip c w) t) (- 1.0 (exp (- (expt (/ (- t c) w) 2)))))
(define ((dip-rate c w) t) (* 2.0 (/ (- t c) w w) (exp (- (expt (/ (- t c) w) 2)))))
(define (ways-into-dip c limit to)
  (ways-out (dip (* to c) 0.0667) (dip-rate (* to c) 0.0667) limit to))

(test-case "a dip is found by how fast the function falls before it, and rises after it"
  (for* ([c '(0.1 0.43)] [to '(1.0 -1.0)])
    (define found (ways-into-dip c 0.3 to))
    (check-equal? (length found) 1)
    (check-true (< ((dip c 0.0667) (car found)) 0.3)))
  (check-equal? (ways-into-dip 0.1 -0.1 1.0) '()))

;; Steps of length h -> the time where the first of them leaves the region, or #f, and how
;; often the function was looked at
(define (followed f f-rate limit h count [start 0.0])
  (define looks 0)
  (define (look point seen)
    (set! looks (+ looks 1))
    (flvector-set! seen 0 (f (flvector-ref point 0)))
    (flvector-set! seen 1 (f-rate (flvector-ref point 0))))
  (define watch (watch-region (region look limit #f values) (lambda (at) '()) 1))
  (define out
    (for/or ([k count])
      (define-values (from to) (values (+ start (* h k)) (+ start (* h (+ k 1)))))
      (define (at place point) (flvector-set! point 0 (+ from (* place h))))
      (define found (watch at from to))
      (and (pair? found) (+ from (* h (crossing-at (car found)))))))
  (values out looks))

(test-case "a function that is nearly flat, and then falls, is looked at in time, either way"
  (define (steep t) (- 1.0 (expt (abs t) 20)))
  (define (steep-rate t) (* -20.0 (if (> t 0) 1.0 -1.0) (expt (abs t) 19)))
  (for* ([h '(0.01 -0.01 0.03)] [start '(0.0 10.0)])
    (define (later f) (lambda (t) (f (- t start))))
    (define-values (out looks) (followed (later steep) (later steep-rate) 0.3 h 200 start))
    (check-true (<= (expt 0.7 1/20) (abs (- out start)) (+ (expt 0.7 1/20) (abs h))))))

(test-case "where it stays the same, no more than every third step, however long the steps are"
  (for ([h '(0.01 1.0 1000.0)])
    (define-values (out looks) (followed (lambda (t) 1.0) (lambda (t) 0.0) 0.3 h 300))
    (check-false out)
    (check-true (< looks 150))))

(test-case "it is looked at as often whenever the motion begins"
  (define (looks-from start)
    (define (f t) (+ 1.0 (* 0.1 (sin (- t start)))))
    (define (f-rate t) (* 0.1 (cos (- t start))))
    (define-values (out looks) (followed f f-rate 0.3 0.5 100 start))
    looks)
  (check-equal? (looks-from 1024.0) (looks-from 0.0)))
