#lang racket/base
;; A force that acts on contact alone becomes 0 and stays so.  When it does was told as the first
;; of eight places in a step at which it was seen to be 0, up to an eighth of the step too late:
;; of ⌊t⌋ = 5, that t is 5.014.  The expected times are those of a circle, x = cos t.

(require (except-in mechanics time) "../support/checks.rkt")

(define (circle s) (up 1 (ref s 2) (* -1 (ref s 1))))
(define (x s) (ref s 1))
(define turn 6.283185307179586)

(define (times-of f . keywords)
  (map occurrence-time (trajectory-events (apply follow f keywords))))

(define (follow f [method 'auto] [precision #f])
  (evolve-trajectory circle (up 0 1.0 0.0) 10.0 #:method method #:precision precision
                     #:events (event f)))

(define-check (check-times found expected within)
  (unless (and (= (length found) (length expected))
               (for/and ([a (in-list found)] [b (in-list expected)]) (< (abs (- a b)) within)))
    (with-check-info (['found found] ['expected expected]) (fail-check))))

(define ((pushed-by size) s) (* size (max 0 (- 0.3 (x s)))))
(define (with-a-gap s) (if (< (abs (x s)) 0.1) 0 (x s)))
(define into-the-gap
  (list (acos 0.1) (- (* 3/4 turn) (- (acos -0.1) (/ turn 4))) (+ turn (acos 0.1))))

(test-case "when it becomes 0"
  (for ([method '(auto Dormand-Prince-853 Radau-IIA-5)] [within '(1e-9 1e-9 1e-6)])
    (for ([size '(1 1e-200)])
      (check-times (times-of (pushed-by size) method) (list (- turn (acos 0.3))) within))
    (check-times (times-of with-a-gap method) into-the-gap within)
    (check-times (times-of (lambda (s) (- (floor (ref s 0)) 5)) method) '(5) within)))

(test-case "to as many digits as are asked for"
  (define found (times-of (pushed-by 1) #f 100))
  (check-times found (list (- turn (acos 0.3))) 1e-14)
  (check-times (times-of with-a-gap #f 100) into-the-gap 1e-14))

(test-case "what comes back at once is found as before"
  (check-times (times-of (lambda (s) (- (ref s 0) 5)) 'Dormand-Prince-853) '(5) 1e-15)
  (check-times (times-of (lambda (s) (- (ref s 0) 5)) #f 100) '(5) 1e-15))
