#lang racket/base
;; Along a step of the usual method an event's function is a polynomial, and that was believed
;; wherever the last terms are small beside the others, or beside 1.  Where the others are 10⁴³
;; they tell nothing of zeros: of exp(100 x) = 1, with x = cos t, no time was found, but another.  A
;; function of 10⁻²⁵ had its last terms unread, and four of 31 zeros; and where 64 parts of a step
;; do not do, as for sin 500 t, half the zeros were missed.  Expected times are those of a circle.

(require (except-in mechanics time) "../support/checks.rkt")

(define (circle s) (up 1 (ref s 2) (* -1 (ref s 1))))     ; x = cos t, v = - sin t
(define (t s) (ref s 0))
(define (x s) (ref s 1))
(define pi 3.141592653589793)

(define (times-of f end)
  (map occurrence-time
       (trajectory-events
        (evolve-trajectory circle (up 0 1.0 0.0) end #:method 'Taylor #:events (event f)))))

(define-check (check-times f end expected)
  (define found (times-of f end))
  (unless (and (= (length found) (length expected))
               (for/and ([a (in-list found)] [b (in-list expected)]) (< (abs (- a b)) 1e-9)))
    (with-check-info (['found found] ['expected expected]) (fail-check))))

(define quarters (list (* 1/2 pi) (* 3/2 pi) (* 5/2 pi)))

(test-case "a function that is very large beside its zeros"
  (for ([k '(5 20 30 60 100 200)])
    (check-times (lambda (s) (- (exp (* k (x s))) 1)) 10.0 quarters)
    (check-times (lambda (s) (- 1 (exp (* -1 k (x s))))) 10.0 quarters)))

;; Far from there its terms are as small as 10⁻⁸⁷.
(test-case "a function that comes near 0 for a short time"
  (for ([k '(20 50 200 500)])
    (define off (asin (sqrt (/ (log 2) k))))
    (check-times (lambda (s) (- (exp (* -1 k (square (x s)))) 1/2)) 10.0
                 (for*/list ([q quarters] [sign '(-1 1)]) (+ q (* sign off))))))

(test-case "a function that is small throughout"
  (for ([size '(1 1e-12 1e-25 1e-200)])
    (check-times (lambda (s) (* size (sin (* 10 (t s))))) 10.0
                 (for/list ([k (in-range 1 32)]) (* 1/10 pi k)))
    (check-times (lambda (s) (* size (- (sqrt (square (x s))) 1/2))) 10.0
                 (for*/list ([k (in-range 4)] [sign '(-1 1)]
                             [t (in-value (+ (* k pi) (* sign (acos 0.5))))] #:when (< 0 t 10.0))
                   t))))

(test-case "a function that is zero many times within a step"
  (for ([k '(50 500 2000)])
    (check-times (lambda (s) (sin (* k (t s)))) 6.0
                 (for/list ([j (in-range 1 (+ 1 (floor (inexact->exact (/ (* k 6.0) pi)))))])
                   (/ (* pi j) k)))))

(test-case "what is conserved, or nearly 0, still has none"
  (define (energy s) (+ (square (x s)) (square (ref s 2))))
  (check-times (lambda (s) (- (energy s) 1)) 100.0 '())
  (check-times (lambda (s) (- (energy s) 1.000000001)) 100.0 '())
  (check-times (lambda (s) (* 1e-25 (- (energy s) 1))) 100.0 '()))
